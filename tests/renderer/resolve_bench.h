// A resolve on pictures made by hand, under validation.
#pragma once

#include <cmath>
#include <limits>
#include <random>

#include <glm/gtc/packing.hpp>
#include <gtest/gtest.h>

#include "app/paths.h"
#include "renderer/gpu/device.h"
#include "renderer/resolve_alone.h"

namespace unghost {

using Inputs = ResolveInputs;

class ResolveBench {
public:
  std::vector<std::vector<glm::vec3>> resolve(const Inputs& inputs, const std::vector<ModeRun>& runs,
                                              bool cut) {
    return alone_.resolve(inputs, runs, cut);
  }
  /// What the last frame's resolves ran, in the order of the runs.
  const std::vector<UsedPipeline>& ran() const { return alone_.ran(); }
  std::filesystem::path shader_file(const std::string& shader) const {
    return data_.shaders / (shader + ".spv");
  }
  const std::vector<std::string>& messages() const { return device_.validation_messages(); }

private:
  Device device_{{.validate = true}};
  DataFolders data_ = find_data_folders();
  ResolveAlone alone_{device_, data_.shaders};
};

/// A bench for each test, on which nothing may complain.
class ResolveBenchTest : public testing::Test {
protected:
  void TearDown() override {
    for (const std::string& message : bench.messages()) ADD_FAILURE() << message;
  }
  ResolveBench bench;
};

/// Numbers that a frame may hold, the extreme ones among them.
inline float any_number(std::mt19937& random, bool extreme) {
  static constexpr float limit = 65504, infinite = std::numeric_limits<float>::infinity();
  static constexpr float odd[] = {0, 1e-7f, 6e-5f, 1, limit, infinite, -infinite, -1, NAN};
  if (extreme && random() % 8 == 0) return odd[random() % std::size(odd)];
  return std::exp2(float(random() % 2000) / 200 - 7);
}

/// What a half float holds of it.
inline glm::dvec3 half(glm::vec3 c) {
  return glm::dvec3(glm::vec3(glm::unpackHalf4x16(glm::packHalf4x16(glm::vec4(c, 1)))));
}

} // namespace unghost
