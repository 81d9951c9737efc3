// What modes that know causes take a pixel for, as the views show it.
#include <algorithm>

#include "tests/renderer/box_scene.h"
#include "tests/renderer/studio.h"

namespace unghost {
namespace {

struct Colours {
  size_t blue = 0, red = 0, yellow = 0, green = 0, orange = 0;
};

/// Each far from grey, and from the others.
Colours colours_of(const Image& picture) {
  Colours counts;
  for (size_t i = 0; i < picture.rgba.size(); i += 4) {
    const int r = picture.rgba[i], g = picture.rgba[i + 1], b = picture.rgba[i + 2];
    if (b > r + 60 && b > g + 60) ++counts.blue;
    if (r > g + 60 && r > b + 60) ++counts.red;
    if (g > r + 60 && g > b + 60) ++counts.green;
    if (std::min(r, g) > b + 60) ++counts.yellow;
    if (r > b + 40 && r > g + 10 && g > b) ++counts.orange;
  }
  return counts;
}

class PixelClasses : public StudioTest {
protected:
  Colours seen(Renderer& renderer, const char* rig, View view) {
    Colours colours;
    for (int index = 0; index < 2; ++index) {
      FrameInput input = studio->frame(rig, index, {run_of("unghost")}, {{Output::display}});
      input.settings.view = view;
      colours = colours_of(renderer.render(input).delivered[0].picture);
    }
    return colours;
  }
  bool is_glossy(const Material& material) {
    Renderer renderer(studio->device, studio->data.shaders, box_of(material));
    EXPECT_EQ(seen(renderer, "still", View::pixel_class).blue, 0u) << "what it mirrors rests";
    return seen(renderer, "rotate", View::pixel_class).blue > 500;
  }
};

// What is seen in such a surface does not stay with it: its history is bounded.
TEST_F(PixelClasses, ACoatOrALobeOfAFewDegreesIsGlossy) {
  EXPECT_TRUE(is_glossy({.metalness = 0, .roughness = 0.29f}));
  EXPECT_FALSE(is_glossy({.metalness = 0, .roughness = 0.31f}));
  EXPECT_TRUE(is_glossy({.metalness = 0, .roughness = 0.9f, .clearcoat = 0.11f}));
  EXPECT_FALSE(is_glossy({.metalness = 0, .roughness = 0.9f, .clearcoat = 0.09f}));
  EXPECT_FALSE(is_glossy({.metalness = 0, .roughness = 0.1f, .unlit = true}));
}

TEST_F(PixelClasses, EdgesAreMixedAndThoseOfWhatMovesRed) {
  const Colours drive = seen(studio->renderer, "drive", View::pixel_class);
  EXPECT_GT(drive.blue, 1000u) << "paint";
  EXPECT_GT(drive.green, 50u) << "number plate and bumper";
  EXPECT_GT(drive.red, 300u) << "the outline of the car";
  EXPECT_GT(drive.yellow, 2000u) << "trees, posts, the side of the road";
  const Colours still = seen(studio->renderer, "still", View::pixel_class);
  EXPECT_EQ(still.red, 0u);
  EXPECT_EQ(still.green, 0u);
}

TEST_F(PixelClasses, LightMayChangeWhereSomethingMoves) {
  EXPECT_EQ(seen(studio->renderer, "still", View::light_channel).orange, 0u);
  EXPECT_GT(seen(studio->renderer, "drive", View::light_channel).orange, 2000u);
}

} // namespace
} // namespace unghost
