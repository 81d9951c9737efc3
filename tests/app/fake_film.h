// Frames without a device: what a test says that each shows.
#pragma once

#include "app/measure/display.h"
#include "app/measure/film.h"

namespace unghost {

constexpr uint32_t fake_width = 16, fake_height = 12;

/// Of one frame and one of its modes: linear grey, by pixel.
using FakePicture =
    std::function<float(const FrameInput& input, const ModeRun& mode, uint32_t x, uint32_t y)>;

struct FakeFilm {
  explicit FakeFilm(FakePicture shows) : shows_(std::move(shows)) {
    film.at = [](uint32_t frame) {
      FrameInput input;
      input.index = frame, input.cut = frame == 0;
      input.width = fake_width, input.height = fake_height;
      input.now.animation_s = frame, input.before.animation_s = frame == 0 ? 0 : frame - 1;
      return input;
    };
    film.draw = [this](const FrameInput& input) {
      drawn.push_back(input);
      return draw(input);
    };
  }

  Film film;
  std::vector<FrameInput> drawn;

private:
  FrameResult draw(const FrameInput& input) const {
    FrameResult result;
    for (const Wanted& wanted : input.wanted) {
      Delivered& delivered = result.delivered.emplace_back();
      const ModeRun& mode = input.modes.at(wanted.mode);
      const uint32_t channels = wanted.what == Output::motion ? 2 : 3;
      delivered.image = {fake_width, fake_height, channels, {}};
      // surfaces: one object at rest, one metre away
      const bool colour = wanted.what == Output::display || wanted.what == Output::resolved;
      for (uint32_t y = 0; y < fake_height; ++y)
        for (uint32_t x = 0; x < fake_width; ++x)
          delivered.image.values.insert(delivered.image.values.end(), channels,
                                        colour          ? shows_(input, mode, x, y)
                                        : channels == 2 ? 0.0f
                                                        : 1.0f);
      if (wanted.what == Output::display) delivered.picture = displayed_8_bit(delivered.image, 0);
    }
    return result;
  }

  FakePicture shows_;
};

} // namespace unghost
