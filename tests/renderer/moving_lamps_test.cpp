// What lags behind lamps that move, and behind what moves below them: no light of the sun has a part in it.
#include <algorithm>
#include <cstdlib>

#include "tests/renderer/lamp_scene.h"
#include "tests/renderer/studio.h"

namespace unghost {
namespace {

constexpr int last_frame = 30; // what slides is in the middle of its way, and histories are old

/// Of each mode's picture from that of `off`, a mean over pixels and channels of 1.
struct Lag {
  double unghost = 0, rgb = 0, blend = 0;
};

class MovingLamps : public StudioTest {
protected:
  /// Without jitter, so that nothing but what is late differs.
  Lag lag_of(Scene scene, float sky = 0) {
    Renderer renderer(studio->device, studio->data.shaders, std::move(scene));
    FrameResult result;
    for (int index = 0; index <= last_frame; ++index)
      result = renderer.render(frame(index, sky, index == last_frame));
    const auto from_off = [&](size_t mode) {
      const auto &is = result.delivered[mode].picture.rgba, &off = result.delivered[0].picture.rgba;
      double sum = 0;
      for (size_t i = 0; i < off.size(); ++i) sum += std::abs(int(is[i]) - int(off[i]));
      return sum / (255 * 0.75 * double(off.size())); // alpha is the same
    };
    return {from_off(1), from_off(2), from_off(3)};
  }

private:
  static FrameInput frame(int index, float sky, bool last) {
    const auto at = [](int i) {
      return Instant{.eye = {0, 4, 4},
                     .camera = glm::angleAxis(-0.8, glm::dvec3(1, 0, 0)),
                     .animation_s = std::max(i, 0) * seconds_per_frame,
                     .towards_sun = {0, 1, 0}};
    };
    FrameInput input{.now = at(index),
                     .before = at(index - 1),
                     .index = uint64_t(index),
                     .cut = index == 0,
                     .width = 160,
                     .height = 90};
    input.settings.light.sun_illuminance = 0;
    input.settings.light.sky_luminance = sky;
    for (const char* mode : {"off", "unghost", "rgb", "blend"}) {
      if (last) input.wanted.push_back({Output::display, input.modes.size()});
      input.modes.push_back(run_of(mode));
      input.modes.back().taa.policy.jitter = Jitter::none;
    }
    if (!last) input.wanted = {{Output::depth, 0}};
    return input;
  }
};

Material matt(float albedo, float emission = 0) {
  return {.base_colour = glm::vec4(glm::vec3(albedo), 1), .emissive = glm::vec3(emission)};
}

Scene lamp_over(Scene plate, float intensity) {
  slide(plate, add_lamp(plate, intensity, {}), {-2, 1.5f, 0}, {2, 1.5f, 0});
  return plate;
}

Scene noisy_plate(const Material& material) {
  Scene plate = plate_of(material);
  add_noise(plate);
  return plate;
}

TEST_F(MovingLamps, LightOfALampIsFollowed) {
  for (const float sky : {0.0f, 0.3f})
    for (const float intensity : {2.0f, 8.0f, 40.0f}) {
      const Lag lag = lag_of(lamp_over(plate_of(matt(0.5f)), intensity), sky);
      EXPECT_LT(lag.unghost, 0.5 * lag.blend) << sky << " " << intensity;
      // which bounds by colours alone, and on a plain plate does well; steps of dim light are coarse
      EXPECT_LE(lag.unghost, 1.35 * lag.rgb) << sky << " " << intensity;
    }
}

TEST_F(MovingLamps, LightIsFollowedWhereColoursTellNothing) {
  for (const float sky : {0.0f, 0.3f})
    for (const float intensity : {2.0f, 8.0f}) {
      const Lag lag = lag_of(lamp_over(noisy_plate(matt(0.9f)), intensity), sky);
      EXPECT_LT(lag.unghost, 0.65 * lag.rgb) << sky << " " << intensity;
    }
}

// Beyond what steps of light can tell, colours do.
TEST_F(MovingLamps, LightThatDazzlesIsBounded) {
  for (const float intensity : {200.0f, 400.0f, 1000.0f}) {
    const Lag lag = lag_of(lamp_over(plate_of(matt(0.02f)), intensity));
    EXPECT_LE(lag.unghost, 1.2 * lag.rgb) << intensity;
  }
}

TEST_F(MovingLamps, WhatSlidesBelowALampComesToOtherLight) {
  for (const float intensity : {2.0f, 8.0f, 40.0f}) {
    Scene scene = plate_of(matt(0.5f));
    add_lamp(scene, intensity, {0, 1.5f, 0});
    slide(scene, 0, {-2, -0.2f, 0}, {2, -0.2f, 0});
    const Lag lag = lag_of(std::move(scene));
    EXPECT_LT(lag.unghost, 0.45 * lag.rgb) << intensity;
    EXPECT_LT(lag.unghost, 0.2 * lag.blend) << intensity;
  }
}

// Of the second plate, which is noise, the colours around do not tell.
TEST_F(MovingLamps, WhatShinesByItselfStays) {
  for (const float intensity : {2.0f, 8.0f, 40.0f})
    for (Scene plate : {plate_of(matt(0.02f, 0.4f)), noisy_plate(matt(0.2f, 0.4f))}) {
      const Lag lag = lag_of(lamp_over(std::move(plate), intensity));
      EXPECT_LE(lag.unghost, 1.2 * lag.rgb) << intensity;
    }
}

} // namespace
} // namespace unghost
