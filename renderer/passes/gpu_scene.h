// A scene on the device: vertices, indices, materials, and what is drawn with what.
#pragma once

#include <vector>

#include "renderer/passes/material_textures.h"

namespace unghost {

/// One primitive of one node.
struct Draw {
  uint32_t object = 0; // index into the objects of a frame
  uint32_t first_index = 0, index_count = 0, first_vertex = 0;
  uint32_t material = 0;
  uint32_t features = 0; // bits of frame.h: which pipeline
  uint8_t tag = 0;
  bool double_sided = false, blended = false;
  bool shines = false; // by itself
  Bounds bounds;       // object space
};

/// What the scene has at all, found once when it is loaded: a list that is empty is never looped over.
struct SceneTraits {
  bool tagged = false, emissive = false;
  bool lit = false, masked = false; // some material is
  uint32_t features = ~0u;          // bits of frame.h that every draw has
};

struct GpuScene {
  GpuScene(Device& device, const Scene& scene);

  /// Draws of one pipeline and material follow each other.
  std::vector<Draw> draws;
  /// The node of each object; as long as the objects of a frame.
  std::vector<int> object_nodes;
  /// What the G-buffer writes of each (shaders/shared/taa_key.h), but for what changes from pixel to pixel.
  std::vector<uint32_t> object_words;
  SceneTraits traits;
  bool software = false; // the device: some ways to the same result suit one better
  Bounds vehicle;        // in its own frame; empty where the scene has none
  std::vector<MaterialData> materials;
  GpuBuffer vertices, indices, texture_places;
  MaterialTextures textures;
};

} // namespace unghost
