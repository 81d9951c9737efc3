// What a window shows, beside the displays that it is made of.
#pragma once

#include "tests/renderer/studio.h"

namespace unghost {

using Pixel = glm::u8vec4;

inline Pixel pixel_of(const Image& image, int x, int y) {
  const size_t at = (size_t(y) * image.width + size_t(x)) * 4;
  return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2], image.rgba[at + 3]};
}

struct Shot {
  Image screen;
  std::vector<Image> displays;
};

class ScreenTest : public StudioTest {
protected:
  static constexpr glm::ivec2 picture{320, 180};

  static FrameResult draw(const ScreenInput& screen, const std::vector<std::string>& modes,
                          std::vector<Wanted> wanted, glm::ivec2 size = picture) {
    FrameResult result;
    for (int index = 0; index < 3; ++index) {
      FrameInput input = studio->frame("drive", index, {}, index == 2 ? wanted : std::vector<Wanted>{});
      for (const std::string& mode : modes) input.modes.push_back(run_of(mode));
      input.width = uint32_t(size.x), input.height = uint32_t(size.y);
      input.screen = screen;
      result = studio->renderer.render(input);
    }
    return result;
  }
  static Shot shoot(const ScreenInput& screen, const std::vector<std::string>& modes,
                    glm::ivec2 size = picture) {
    std::vector<Wanted> wanted{{Output::screen}};
    for (size_t mode = 0; mode < modes.size(); ++mode) wanted.push_back({Output::display, mode});
    FrameResult result = draw(screen, modes, wanted, size);
    Shot shot{.screen = std::move(result.delivered[0].picture), .displays = {}};
    for (size_t mode = 0; mode < modes.size(); ++mode)
      shot.displays.push_back(std::move(result.delivered[mode + 1].picture));
    EXPECT_EQ(shot.screen.width, screen.width);
    EXPECT_EQ(shot.screen.height, screen.height);
    return shot;
  }
  static std::vector<std::string> passes(const FrameResult& result) {
    std::vector<std::string> names;
    for (const PassReport& pass : result.passes) names.push_back(pass.name);
    return names;
  }
  static ScreenInput window(Arrangement arrangement, glm::ivec2 size = picture) {
    return {.width = uint32_t(size.x), .height = uint32_t(size.y), .arrangement = arrangement};
  }
};

} // namespace unghost
