// A stage that is built once for a test suite: the asphalt, small pictures, validation on.
#pragma once

#include <gtest/gtest.h>

#include "app/paths.h"
#include "app/rigs.h"
#include "app/stage.h"
#include "renderer/gpu/device.h"
#include "renderer/renderer.h"

namespace unghost {

struct Studio {
  Device device{{.validate = true}};
  DataFolders data = find_data_folders();
  Staged staged = build_stage(data.assets / "asphalt.glb", data.assets / "asphalt.glb", {});
  Renderer renderer{device, data.shaders, staged.scene};

  Instant at(const char* rig, int frame) const {
    const RigContext context{.track_radius = staged.track_radius, .vehicle = staged.vehicle};
    return find_rig(rig)->at(context, frame * seconds_per_frame);
  }
  /// Frame `index` of a rig: 0 is a cut.
  FrameInput frame(const char* rig, int index, std::vector<ModeRun> modes, std::vector<Wanted> wanted) const {
    return {.now = at(rig, index),
            .before = at(rig, std::max(index - 1, 0)),
            .index = uint64_t(index),
            .cut = index == 0,
            .width = 320,
            .height = 180,
            .modes = std::move(modes),
            .wanted = std::move(wanted)};
  }
};

inline ModeRun run_of(std::string_view mode) { return {std::string(mode), settings_for_mode(mode).taa}; }

class StudioTest : public testing::Test {
protected:
  static void SetUpTestSuite() { studio = new Studio; }
  static void TearDownTestSuite() {
    delete studio;
    studio = nullptr;
  }
  void TearDown() override {
    for (const std::string& message : studio->device.validation_messages()) ADD_FAILURE() << message;
  }
  static inline Studio* studio = nullptr;
};

} // namespace unghost
