#include "app/measure/protocols.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "app/measure/display.h"
#include "app/measure/flip.h"
#include "tests/app/fake_film.h"

namespace unghost {
namespace {

constexpr Protocol small{
    .word = "small", .fill = 3, .measured = 4, .samples = 8, .references = 4, .rounds = 5};

Measured rows_for(const std::vector<ModeRun>& modes) {
  Measured measured;
  for (const ModeRun& mode : modes)
    measured.rows.push_back({.mode = mode.name, .figures = {}, .samples = {}});
  return measured;
}

std::vector<ModeRun> modes_named(const std::vector<std::string>& names) {
  std::vector<ModeRun> runs;
  for (const std::string& name : names) runs.push_back({.name = name, .taa = find_taa_mode(name)->settings});
  return runs;
}

struct Trial {
  FakeFilm film;
  Measured measured;
  std::map<std::string, Image> saved;
};

Trial measured(const FakePicture& shows, const std::vector<std::string>& names,
               const std::set<Aspect>& aspects, Keep keep = Keep::none) {
  Trial run{.film = FakeFilm(shows), .measured = rows_for(modes_named(names)), .saved = {}};
  measure_all({.film = run.film.film,
               .protocol = small,
               .aspects = aspects,
               .modes = jittered(modes_named(names)),
               .references = {},
               .keep = keep,
               .save = [&](const std::string& file, const Image& image) { run.saved[file] = image; }},
              run.measured);
  return run;
}

Image shown(float grey) {
  return displayed_8_bit(
      {fake_width, fake_height, 3, std::vector<float>(size_t(fake_width) * fake_height * 3, grey)}, 0);
}
double flip_of(float a, float b) { return mean_flip(seen(shown(a)), seen(shown(b))); }

TEST(Protocols, GhostingIsTheMeanFlipToTheAliasedFrameOverTheFramesThatCount) {
  const auto shows = [](const FrameInput& input, const ModeRun& mode, uint32_t, uint32_t) {
    return mode.name == "blend" ? 0.25f + 0.05f * float(input.index) : 0.25f;
  };
  const Trial run = measured(shows, {"off", "blend"}, {Aspect::ghosting});
  double sum = 0;
  for (uint32_t frame = 3; frame <= 6; ++frame) sum += flip_of(0.25f, 0.25f + 0.05f * float(frame));
  EXPECT_NEAR(run.measured.rows[1].figures.at("ghosting"), sum / 4, 1e-8);
  EXPECT_EQ(run.measured.rows[1].samples.at("ghosting").size(), 4u);
  EXPECT_EQ(run.measured.rows[0].figures.at("ghosting"), 0);
  ASSERT_EQ(run.film.drawn.size(), 7u) << "one frame feeds all modes";
  for (const FrameInput& input : run.film.drawn)
    for (const ModeRun& mode : input.modes) EXPECT_EQ(mode.taa.policy.jitter, Jitter::none) << mode.name;
  EXPECT_TRUE(run.film.drawn.front().cut);
  EXPECT_EQ(std::ranges::count(run.film.drawn, true, &FrameInput::cut), 1);
}

TEST(Protocols, ShimmerIsTheMeanFlipBetweenFramesOfAWorldAtRest) {
  const auto shows = [](const FrameInput& input, const ModeRun& mode, uint32_t, uint32_t) {
    return mode.name == "blend" && input.index % 2 == 1 ? 0.5f : 0.4f;
  };
  const Trial run = measured(shows, {"blend", "rgb", "crytek-2x", "off"}, {Aspect::shimmer});
  EXPECT_NEAR(run.measured.rows[0].figures.at("shimmer"), flip_of(0.4f, 0.5f), 1e-8);
  EXPECT_EQ(run.measured.rows[0].samples.at("shimmer").size(), 4u);
  EXPECT_EQ(run.measured.rows[1].figures.at("shimmer"), 0);
  const FrameInput& last = run.film.drawn.back();
  EXPECT_EQ(last.now.animation_s, 3) << "the first instant that counts elsewhere";
  EXPECT_EQ(last.before.animation_s, last.now.animation_s);
  EXPECT_EQ(last.modes[0].taa.policy.jitter, Jitter::r2_10) << "not its own";
  EXPECT_EQ(last.modes[1].taa.policy.jitter, Jitter::r2_10);
  EXPECT_EQ(last.modes[2].taa.policy.jitter, Jitter::two_samples) << "all that it mixes";
  EXPECT_EQ(last.modes[3].taa.policy.jitter, Jitter::none);
}

TEST(Protocols, ReferencesAreTheMeanOfLinearLightAtPlacesThatNoModeTakes) {
  // darker to the left of the pixel's middle
  const auto shows = [](const FrameInput& input, const ModeRun&, uint32_t, uint32_t) {
    return input.jitter_px && input.jitter_px->x < 0 ? 0.1f : 0.5f;
  };
  FakeFilm film(shows);
  const SupersampledFrame frame = supersampled(film.film, 5, 64, {});
  std::set<std::pair<double, double>> places;
  double left = 0;
  for (const FrameInput& input : film.drawn) {
    EXPECT_TRUE(input.cut);
    EXPECT_EQ(input.now.animation_s, 5);
    EXPECT_TRUE(places.emplace(input.jitter_px->x, input.jitter_px->y).second) << "drawn twice";
  }
  ASSERT_EQ(film.drawn.size(), 64u + 17u);
  for (size_t i = 0; i < 64; ++i) left += film.drawn[i].jitter_px->x < 0; // the reference's come first
  EXPECT_NEAR(left / 64, 0.5, 0.05) << "spread evenly";
  const auto mean = float((left * 0.1f + (64 - left) * 0.5f) / 64);
  EXPECT_EQ(frame.reference.rgba[0], shown(mean).rgba[0]);
  ASSERT_EQ(frame.fewer.size(), std::size(supersampling_steps));
  glm::dvec2 sum(0);
  for (size_t i = 0; i < film.drawn.size(); ++i) {
    sum += *film.drawn[i].jitter_px;
    if (i % 2 == 1 && i < 64) {
      EXPECT_LT(glm::length(sum), 1e-9) << "the mean is the pixel's middle";
    }
  }
  EXPECT_LT(glm::length(sum), 1e-9);
}

TEST(Protocols, ErrorsAreTakenAtPairsOfFramesAndTheLast) {
  EXPECT_EQ(reference_frames(small), (std::vector<uint32_t>{3, 4, 5, 6}));
  for (const Protocol& protocol : protocols()) {
    const std::vector<uint32_t> frames = reference_frames(protocol);
    EXPECT_EQ(frames.size(), protocol.references) << protocol.word;
    EXPECT_EQ(frames.back(), last_frame(protocol));
    EXPECT_GE(frames.front(), protocol.fill);
    std::set<uint32_t> phases; // of the jitter's ten points
    for (size_t i = 0; i < frames.size(); i += 2) {
      EXPECT_EQ(frames[i] + 1, frames[i + 1]);
      phases.insert(frames[i] % 10);
    }
    EXPECT_EQ(phases.size(), frames.size() / 2) << protocol.word;
  }
}

TEST(Protocols, NothingIsDrawnBetweenTheFramesOfAHistory) {
  const auto shows = [](const FrameInput&, const ModeRun&, uint32_t, uint32_t) { return 0.5f; };
  const Trial run = measured(shows, {"off", "blend"}, {Aspect::error, Aspect::flicker});
  size_t changes = 0;
  for (size_t i = 1; i < run.film.drawn.size(); ++i)
    changes += run.film.drawn[i].modes.size() != run.film.drawn[i - 1].modes.size();
  EXPECT_EQ(changes, 1u) << "samples, then frames";
  EXPECT_EQ(run.measured.rows[1].figures.at("error"), 0);
  EXPECT_EQ(run.measured.rows[1].samples.at("error").size(), 4u);
  EXPECT_EQ(run.measured.rows[1].samples.at("flicker").size(), 2u) << "one a pair";
  EXPECT_EQ(run.measured.supersampled.size(), std::size(supersampling_steps));
}

TEST(Protocols, FlickerSeesAnErrorThatComesAndGoes) {
  const auto shows = [](const FrameInput& input, const ModeRun& mode, uint32_t, uint32_t) {
    return mode.name == "blend" && input.index % 2 == 1 && !input.jitter_px ? 0.75f : 0.5f;
  };
  const Trial run = measured(shows, {"blend", "rgb"}, {Aspect::flicker});
  EXPECT_NEAR(run.measured.rows[0].figures.at("flicker"),
              (shown(0.75f).rgba[0] - shown(0.5f).rgba[0]) / 255.0, 1e-6);
  EXPECT_NEAR(run.measured.rows[1].figures.at("flicker"), 0, 1e-6);
}

TEST(Protocols, ConvergenceIsErrorAgainstTheNumberOfFrames) {
  const auto shows = [](const FrameInput& input, const ModeRun& mode, uint32_t, uint32_t) {
    if (input.jitter_px) return 0.5f;
    return mode.name == "blend" ? 0.5f + 0.25f / float(input.index + 1) : 0.5f;
  };
  const Trial run = measured(shows, {"blend"}, {Aspect::convergence});
  ASSERT_TRUE(run.measured.convergence);
  const Convergence& convergence = *run.measured.convergence;
  EXPECT_EQ(convergence.frames, (std::vector<uint32_t>{1, 2, 4}));
  ASSERT_EQ(convergence.curves.front().name, "blend");
  EXPECT_TRUE(std::ranges::is_sorted(convergence.curves.front().error, std::greater<>()));
  EXPECT_EQ(convergence.curves.back().kind, "supersampling");
  for (const ConvergenceCurve& curve : convergence.curves) EXPECT_EQ(curve.error.size(), 3u) << curve.name;
}

TEST(Protocols, FramesAreKeptAsAskedFor) {
  const auto shows = [](const FrameInput& input, const ModeRun& mode, uint32_t, uint32_t) {
    return mode.name == "blend" ? (input.index == 4 ? 0.9f : 0.6f) : 0.5f;
  };
  const Trial worst = measured(shows, {"blend", "rgb"}, {Aspect::ghosting}, Keep::worst);
  ASSERT_EQ(worst.measured.kept.size(), 2u);
  EXPECT_EQ(worst.measured.kept[0].frame, 4u);
  for (const KeptFrame& kept : worst.measured.kept) {
    EXPECT_TRUE(worst.saved.contains(kept.picture)) << kept.picture;
    EXPECT_TRUE(worst.saved.contains(kept.reference)) << kept.reference;
  }
  EXPECT_EQ(worst.saved.at(worst.measured.kept[0].picture).rgba[0], shown(0.9f).rgba[0]);
  const Trial all = measured(shows, {"blend", "rgb"}, {Aspect::ghosting}, Keep::all);
  EXPECT_EQ(all.saved.size(), 4u * 3u) << "two modes and the aliased frame";
  EXPECT_TRUE(measured(shows, {"blend"}, {Aspect::ghosting}).saved.empty());
}

} // namespace
} // namespace unghost
