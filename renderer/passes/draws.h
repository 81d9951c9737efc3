// Recording draws: the one place where geometry meets pipelines.
#pragma once

#include "renderer/passes/passes.h"

namespace unghost {

struct DrawStyle {
  std::string vertex, fragment;
  bool shadow = false;    // depth alone, biased; `fragment` only where a mask cuts holes
  bool tags = false;      // into the stencil
  uint32_t written = ~0u; // as GraphicsDesc has it
};

/// The bindings of set 0 that drawing needs, FrameConstants included.
std::vector<Binding> draw_bindings(const FrameContext& in);
/// Records `draws` with the pipelines that their features ask for; specialization constants: the features,
/// and whether the object moved.
void record_draws(PassCommands& commands, const FrameContext& in, std::span<const Draw* const> draws,
                  const DrawStyle& style);

} // namespace unghost
