// Every pixel to which a shadow comes, or which it leaves, is one whose light may change; and what it leaves
// has the frame's hue.
#include <array>
#include <cmath>
#include <optional>

#include "tests/renderer/lamp_scene.h"
#include "tests/renderer/studio.h"

namespace unghost {
namespace {

/// A frame as its shadows are told.
struct Shadows {
  std::vector<float> visibility, motion, object;
  std::vector<uint8_t> light; // as the view draws it

  bool flagged(size_t pixel) const { return light[4 * pixel] > light[4 * pixel + 2] + 40; } // else it is grey
  bool rests(size_t pixel) const { return motion[2 * pixel] == 0 && motion[2 * pixel + 1] == 0; }
};

struct Flags {
  size_t changed = 0, missed = 0, flagged = 0;
};

ModeRun without_jitter(const char* mode) {
  ModeRun run = run_of(mode);
  run.taa.policy.jitter = Jitter::none;
  return run;
}

class ShadowFlags : public StudioTest {
protected:
  static Shadows drawn(Renderer& renderer, FrameInput input) {
    input.modes = {without_jitter("unghost")};
    input.wanted = {{Output::sun_visibility}, {Output::motion}, {Output::object}, {Output::display}};
    input.settings.view = View::light_channel;
    const std::vector<Delivered> of = renderer.render(input).delivered;
    return {of[0].image.values, of[1].image.values, of[2].image.values, of[3].picture.rgba};
  }
  /// Of the camera at rest: the same pixel shows the same point of what rests.
  static Flags compare(const Shadows& before, const Shadows& now) {
    Flags flags;
    for (size_t i = 0; i < now.visibility.size(); ++i) {
      const bool same_point = now.object[i] == before.object[i] && now.rests(i),
                 changed = same_point && now.visibility[i] != before.visibility[i];
      flags.flagged += now.flagged(i);
      flags.changed += changed;
      flags.missed += changed && !now.flagged(i);
    }
    return flags;
  }
};

glm::dvec3 low_sun(glm::dvec3 towards_sun) {
  return glm::normalize(glm::dvec3(towards_sun.x, 0.2, towards_sun.z));
}

TEST_F(ShadowFlags, AreWhereShadowsComeAndGoAndNotEverywhere) {
  constexpr size_t pixels = 320 * 180;
  for (const int start : {0, 12, 24, 48, 64}) {
    Shadows before;
    for (int index = start; index < start + 3; ++index) {
      FrameInput input = studio->frame("pass", index, {}, {});
      input.cut = index == start;
      // low, so that shadows go beyond what lies around the vehicle's underside
      input.now.towards_sun = input.before.towards_sun = low_sun(input.now.towards_sun);
      const Shadows now = drawn(studio->renderer, input);
      if (index > start) {
        const Flags flags = compare(before, now);
        EXPECT_GT(flags.changed, 40u) << index;
        EXPECT_EQ(flags.missed, 0u) << index;
        // the car, its long shadow and what lies between the two are up to two fifths of the picture
        EXPECT_LT(flags.flagged, pixels / 2) << index;
      }
      before = now;
    }
  }
}

/// A box 2 m above a plate, which slides towards the sun within a second.
Scene box_above_plate(float from_m, float to_m) {
  Scene scene = plate_of({.base_colour = {0.5f, 0.5f, 0.5f, 1}});
  slide(scene, add_box(scene, 0.5f, {}), {0, 2, from_m}, {0, 2, to_m});
  return scene;
}

/// Where the box's shadow ends on its side, of a sun that stands low: there what lifts surfaces above
/// themselves takes them furthest into the shadow. A texel is 9 pixels wide.
FrameInput above_shadow_end(double time_s, double before_s, bool cut) {
  const double elevation = 0.35;
  FrameInput input{.now = {.eye = {0, 1.2, -4.4},
                           .camera = glm::angleAxis(-1.57, glm::dvec3(1, 0, 0)),
                           .animation_s = time_s,
                           .towards_sun = {0, std::sin(elevation), std::cos(elevation)}},
                   .cut = cut,
                   .width = 160,
                   .height = 270};
  input.before = input.now;
  input.before.animation_s = before_s;
  return input;
}

// The box throws its shadow to the very sides of its bounds, and goes on by a ninth of a texel a frame.
TEST_F(ShadowFlags, ReachAsFarAsTheFilterDoes) {
  Renderer renderer(studio->device, studio->data.shaders, box_above_plate(0, 0.7f));
  Shadows before;
  size_t changed = 0;
  for (int index = 0; index < 30; ++index) {
    const double time_s = index * seconds_per_frame;
    const Shadows now = drawn(renderer, above_shadow_end(time_s, time_s - seconds_per_frame, index == 0));
    if (index > 0) {
      const Flags flags = compare(before, now);
      EXPECT_EQ(flags.missed, 0u) << index;
      EXPECT_LT(flags.flagged, now.visibility.size()) << index << ": some lies beyond";
      changed += flags.changed;
    }
    before = now;
  }
  EXPECT_GT(changed, 10000u);
}

TEST_F(ShadowFlags, AreWhereAShadowCameFromAndWhereItWent) {
  Renderer renderer(studio->device, studio->data.shaders, box_above_plate(-1.5f, 1.5f));
  Shadows before = drawn(renderer, above_shadow_end(0, 0, true));
  for (const double time_s : {1.0, 0.0, 1.0}) { // over all of the picture, and off it
    const Shadows now = drawn(renderer, above_shadow_end(time_s, 1 - time_s, false));
    const Flags flags = compare(before, now);
    EXPECT_EQ(flags.changed, now.visibility.size()) << time_s;
    EXPECT_EQ(flags.missed, 0u) << time_s;
    before = now;
  }
}

class RelitHue : public StudioTest {
protected:
  /// Where each pixel's surface was in the last frame; nothing of the vehicle, and of what lay beyond the
  /// picture's sides.
  static std::optional<size_t> before(const FloatImage& motion, const FloatImage& tag, size_t pixel) {
    const int width = int(motion.width), height = int(motion.height);
    const int x = int(std::lround(float(int(pixel) % width) + motion.values[2 * pixel])),
              y = int(std::lround(float(int(pixel) / width) + motion.values[2 * pixel + 1]));
    const bool inside = x >= 0 && y >= 0 && x < width && y < height;
    if (!inside || tag.values[pixel] != 0) return {};
    return size_t(y * width + x);
  }
};

glm::dvec3 colour_of(const FloatImage& image, size_t pixel) {
  return {image.values[3 * pixel], image.values[3 * pixel + 1], image.values[3 * pixel + 2]};
}

// Blue by red: what only the sky lit is bluer than what the sun shines on, too.
TEST_F(RelitHue, OfWhatAShadowHasJustLeftIsTheFrames) {
  const std::vector<ModeRun> modes{without_jitter("off"), without_jitter("unghost"),
                                   without_jitter("unghost-lite")};
  std::array<glm::dvec3, 3> sums{};
  std::vector<float> seen_before;
  for (int index = 0; index < 60; ++index) {
    FrameInput input = studio->frame("overhead", index, modes, {});
    for (size_t mode = 0; mode < modes.size(); ++mode) input.wanted.push_back({Output::resolved, mode});
    for (const Output what : {Output::sun_visibility, Output::tag, Output::motion})
      input.wanted.push_back({what});
    const std::vector<Delivered> of = studio->renderer.render(input).delivered;
    const std::vector<float>& seen = of[3].image.values;
    for (size_t pixel = 0; index > 20 && pixel < seen.size(); ++pixel) { // histories are old by then
      const std::optional<size_t> was = before(of[5].image, of[4].image, pixel);
      if (!was || seen[pixel] < 1 || seen_before[*was] > 0) continue;
      for (size_t mode = 0; mode < modes.size(); ++mode) sums[mode] += colour_of(of[mode].image, pixel);
    }
    seen_before = seen;
  }
  const auto hue = [&](size_t mode) { return sums[mode].z / sums[mode].x; };
  for (const size_t mode : {1, 2}) {
    EXPECT_NEAR(hue(mode) / hue(0), 1, 0.02) << modes[mode].name;
    EXPECT_GT(sums[mode].y / sums[0].y, 0.88) << modes[mode].name << ": lit anew at all";
  }
}

} // namespace
} // namespace unghost
