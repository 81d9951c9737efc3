// Tests that draw, in a folder of their own.
#pragma once

#include <gtest/gtest.h>

#include "renderer/gpu/device.h"
#include "tests/app/scratch_folder.h"

namespace unghost {

/// Skipped where nothing can be drawn on.
class DeviceTest : public testing::Test {
protected:
  void SetUp() override {
    try {
      for (const DeviceFacts& device : list_devices())
        if (device.usable) return;
    } catch (const GpuError& error) {
      GTEST_SKIP() << error.what();
    }
    GTEST_SKIP() << "no usable Vulkan device";
  }

  const ScratchFolder folder;
};

} // namespace unghost
