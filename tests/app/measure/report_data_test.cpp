// What the report says is worked out right: fronts, orders, scales, places for names.
#include <cmath>

#include <gtest/gtest.h>

#include "app/measure/report/chart.h"
#include "app/measure/report/html.h"
#include "app/measure/report/jpeg.h"
#include "app/measure/report/labels.h"
#include "app/measure/report/paper_tables.h"
#include "app/measure/report/pareto.h"
#include "renderer/scene/gltf_pictures.h"

namespace unghost {
namespace {

using Indices = std::vector<size_t>;
using Points = std::vector<CostAndError>;

TEST(ParetoFront, IsWhatNothingBeats) {
  EXPECT_EQ(pareto_front(Points{}), Indices{});
  EXPECT_EQ(pareto_front(Points{{1, 1}}), Indices{0});
  // cheap and bad, dear and good, between and worse than the first, between and better
  EXPECT_EQ(pareto_front(Points{{1, 5}, {4, 1}, {2, 6}, {3, 2}}), (Indices{0, 3, 1}));
  EXPECT_EQ(pareto_front(Points{{3, 3}, {2, 2}, {1, 1}}), Indices{2});
}

TEST(ParetoFront, TiesInOneAreBeatenAndInBothAreNot) {
  EXPECT_EQ(pareto_front(Points{{1, 3}, {1, 2}}), Indices{1});
  EXPECT_EQ(pareto_front(Points{{1, 2}, {2, 2}}), Indices{0});
  EXPECT_EQ(pareto_front(Points{{1, 2}, {1, 2}}), (Indices{0, 1}));
  EXPECT_EQ(pareto_front(Points{{NAN, 0}, {1, NAN}, {5, 5}}), Indices{2});
}

TEST(ParetoFront, CostsAreEqualWithinTheirMargins) {
  // the second costs no more for all that is known, and is better
  EXPECT_EQ(pareto_front(Points{{1, 3, .2}, {1.3, 2, .2}}), Indices{1});
  EXPECT_EQ(pareto_front(Points{{1, 3, .1}, {1.3, 2, .1}}), (Indices{0, 1}));
  // as good as each other: cheaper by more than the margins, or both
  EXPECT_EQ(pareto_front(Points{{1, 2, .1}, {1.3, 2, .1}}), Indices{0});
  EXPECT_EQ(pareto_front(Points{{1, 2, .2}, {1.3, 2, .2}}), (Indices{0, 1}));
  // of a chain of neighbours the first is surely cheaper than the last: only the second is beaten by the
  // front
  EXPECT_EQ(pareto_front(Points{{1, 3, .2}, {1.3, 2, .2}, {1.6, 1, .2}}), (Indices{0, 2}));
}

TEST(Orders, PairsThatDifferAreNamed) {
  const std::vector<double> theirs = {1, 2, 3, 3}, ours = {10, 30, 20, 25};
  const OrderComparison order = compare_orders(theirs, ours);
  EXPECT_EQ(order.pairs, 6u);
  EXPECT_EQ(order.tied, 1u); // 3 and 3
  EXPECT_EQ(order.alike, 3u);
  EXPECT_EQ(order.unlike, (std::vector<std::pair<size_t, size_t>>{{1, 2}, {1, 3}}));
}

TEST(Orders, WhatWasNotMeasuredIsNotCounted) {
  const OrderComparison order = compare_orders(std::vector<double>{1, 2, 3}, std::vector<double>{1, NAN, 3});
  EXPECT_EQ(order.pairs, 1u);
  EXPECT_EQ(order.alike, 1u);
}

TEST(Orders, ThePaperAgreesWithItselfOnTwentyOnePairs) {
  ASSERT_EQ(paper_tables().size(), 2u);
  for (const PaperTable& table : paper_tables()) {
    std::vector<double> ghosting, shimmer;
    for (const PaperRow& row : table.rows) ghosting.push_back(row.ghosting), shimmer.push_back(row.shimmer);
    EXPECT_EQ(compare_orders(ghosting, ghosting).alike, 21u) << table.title;
    // "the least shimmering method ghosts the most and the most shimmering method ghosts the least"
    EXPECT_EQ(std::ranges::max_element(shimmer) - shimmer.begin(),
              std::ranges::min_element(ghosting) - ghosting.begin());
  }
}

TEST(Scales, ZeroHasItsPlaceBeforeALogarithm) {
  const Scale scale({.label = {}, .log = true, .rows = {}}, {0, 0.01, 1});
  EXPECT_GT(scale(0), 0);
  ASSERT_EQ(scale.breaks().size(), 1u);
  EXPECT_LT(scale(0), scale.breaks()[0]);
  EXPECT_GT(scale(0.01), scale.breaks()[0]);
  EXPECT_NEAR(scale(0.1) - scale(0.01), scale(1) - scale(0.1), 1e-9);
  EXPECT_EQ(scale.ticks().front().text, "0");
  EXPECT_TRUE(Scale({.label = {}, .log = true, .rows = {}}, {0.01, 1}).breaks().empty());
}

TEST(Scales, BeyondTheKneeTheyAreTighterAndStillRise) {
  const std::vector<double> values = {0, 6, 8, 10, 50, 700};
  const ChartAxis axis{.label = {}, .log = true, .rows = {}, .knee = 10};
  const Scale scale(axis, values);
  ASSERT_EQ(scale.breaks().size(), 2u);
  for (size_t i = 1; i < values.size(); ++i) EXPECT_LT(scale(values[i - 1]), scale(values[i])) << values[i];
  EXPECT_LT(scale(10), scale.breaks()[1]);
  EXPECT_GT(scale(50), scale.breaks()[1]);
  EXPECT_LE(scale(700), 1);
  EXPECT_GT(scale(10) - scale(6), 2 * (Scale({.label = {}, .log = true, .rows = {}}, values)(10) -
                                       Scale({.label = {}, .log = true, .rows = {}}, values)(6)));
  for (const Tick& tick : scale.ticks()) EXPECT_NEAR(scale(std::stod(tick.text)), tick.at, 1e-6) << tick.text;
}

TEST(Scales, EveryTickLiesOnItAndSaysWhereItIs) {
  for (const bool log : {false, true})
    for (const std::vector<double>& values : std::vector<std::vector<double>>{
             {1, 2}, {0.031, 0.033}, {0, 0.04}, {5, 5}, {1e-4, 3e3}, {0}, {}, {NAN, 7}}) {
      const Scale scale({.label = {}, .log = log, .rows = {}}, values);
      EXPECT_GE(scale.ticks().size(), 2u) << testing::PrintToString(values);
      for (const Tick& tick : scale.ticks()) {
        EXPECT_TRUE(tick.at > -1e-9 && tick.at < 1 + 1e-9) << tick.text;
        EXPECT_NEAR(scale(std::stod(tick.text)), tick.at, 1e-6) << tick.text;
      }
      std::vector<Tick> ticks = scale.ticks();
      std::ranges::sort(ticks, {}, &Tick::at);
      for (size_t i = 1; i < ticks.size(); ++i) // none is written over another
        EXPECT_GT(ticks[i].at - ticks[i - 1].at, 0.02) << ticks[i - 1].text << " and " << ticks[i].text;
      for (const double value : values)
        EXPECT_TRUE(std::isnan(value) || (scale(value) >= 0 && scale(value) <= 1)) << value;
    }
}

TEST(Labels, DoNotCoverEachOtherWhereThereIsRoom) {
  std::vector<Label> labels;
  for (int i = 0; i < 6; ++i) labels.push_back({"a-mode-" + std::to_string(i), 300, 200 + 2. * i});
  const auto placed = place_labels(labels, {}, {0, 0, 600, 400});
  for (size_t a = 0; a < placed.size(); ++a)
    for (size_t b = a + 1; b < placed.size(); ++b)
      EXPECT_TRUE(std::abs(placed[a].y - placed[b].y) >= label_size - 1e-9 ||
                  std::abs(placed[a].x - placed[b].x) >= text_width(labels[0]) - 1e-9)
          << a << " and " << b;
  const auto ends = place_at_ends(labels);
  for (size_t i = 1; i < ends.size(); ++i) EXPECT_GE(ends[i].y - ends[i - 1].y, label_size);
}

TEST(Html, TextAndDataStayWhatTheyAre) {
  EXPECT_EQ(escaped("<a href=\"x\">'&"), "&lt;a href=&quot;x&quot;&gt;&#39;&amp;");
  const nlohmann::json data = {{"a", "</script><!--"}, {"bytes", "\xff"}};
  const std::string script = script_json(data);
  EXPECT_EQ(script.find('<'), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(script).at("a"), "</script><!--");
  EXPECT_EQ(base64(std::vector<uint8_t>{}), "");
  EXPECT_EQ(base64(std::vector<uint8_t>{'M'}), "TQ==");
  EXPECT_EQ(base64(std::vector<uint8_t>{'M', 'a'}), "TWE=");
  EXPECT_EQ(base64(std::vector<uint8_t>{'M', 'a', 'n'}), "TWFu");
  // of nothing
  EXPECT_EQ(csp_hash("e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"),
            "'sha256-47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU='");
  EXPECT_EQ(milliseconds(0.02134), "0.0213");
  EXPECT_EQ(milliseconds(21.34), "21.3");
  EXPECT_EQ(milliseconds(0), "0");
}

TEST(Jpeg, KeepsTheColourOfEachPixel) {
  Image stripes{.name = {}, .width = 32, .height = 16, .rgba = {}};
  for (int i = 0; i < 32 * 16; ++i) // red beside blue: half the colours would make violet of both
    stripes.rgba.insert(stripes.rgba.end(), {uint8_t(i % 2 ? 220 : 30), 40, uint8_t(i % 2 ? 30 : 220), 255});
  gltf::PictureBounds bounds{.side = 64, .bytes_left = 1 << 20};
  const Image back = gltf::decode_jpeg(encode_jpeg(stripes), bounds);
  ASSERT_EQ(back.width, 32u);
  for (size_t i = 0; i < stripes.rgba.size(); ++i) EXPECT_NEAR(back.rgba[i], stripes.rgba[i], 40) << i;
  EXPECT_EQ(encode_jpeg(stripes), encode_jpeg(stripes));
}

} // namespace
} // namespace unghost
