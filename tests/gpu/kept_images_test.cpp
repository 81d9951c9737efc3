// What outlives frames: when a history or a cache holds what was asked for.
#include <gtest/gtest.h>

#include "renderer/gpu/frame_plan.h"

namespace unghost {
namespace {

constexpr VkFormat colour_format = VK_FORMAT_R16G16B16A16_SFLOAT;

/// Whether the history of frame `number` is valid, with that size, after what `kept` remembers.
bool history_valid(KeptImages& kept, uint64_t number, uint32_t width, bool reset = false,
                   bool writes = true) {
  FrameGraph graph(kept, number);
  const History history =
      graph.history("h", {.name = "h", .format = colour_format, .extent = {width, 8}}, reset);
  if (writes) graph.pass({.name = "resolve", .bindings = {storage_write(1, history.next)}});
  note_kept(graph, cull(graph));
  return history.valid;
}

TEST(History, IsNotValidAtFirstAfterAResizeAResetOrAGap) {
  KeptImages kept;
  EXPECT_FALSE(history_valid(kept, 0, 8));
  EXPECT_TRUE(history_valid(kept, 1, 8));
  EXPECT_FALSE(history_valid(kept, 2, 16)) << "another size";
  EXPECT_TRUE(history_valid(kept, 3, 16));
  EXPECT_FALSE(history_valid(kept, 4, 16, true)) << "a cut";
  EXPECT_TRUE(history_valid(kept, 5, 16));
  EXPECT_FALSE(history_valid(kept, 7, 16)) << "a frame without it";
  EXPECT_TRUE(history_valid(kept, 8, 16, false, false));
  EXPECT_FALSE(history_valid(kept, 9, 16)) << "a frame that did not write it";
}

TEST(History, PreviousOfAnInvalidOneIsNeutral) {
  KeptImages kept;
  FrameGraph graph(kept, 0);
  const History history = graph.history("h", {.name = "h", .format = colour_format, .extent = {8, 8}}, false);
  EXPECT_EQ(graph.desc(history.previous).extent.width, 1u);
  EXPECT_NE(history.previous, history.next);
}

TEST(Cache, IsRecentWhereItWasWrittenInTheFrameBefore) {
  KeptImages kept;
  const auto recent = [&](uint64_t number, uint64_t version) {
    FrameGraph graph(kept, number);
    const Cache cache = graph.cache("c", {.name = "c", .format = colour_format, .extent = {8, 8}}, version);
    graph.pass({.name = "draw", .bindings = {storage_write(1, cache.image)}});
    graph.want(cache.image);
    note_kept(graph, cull(graph));
    return cache.recent;
  };
  EXPECT_FALSE(recent(0, 7));
  EXPECT_TRUE(recent(1, 7));
  EXPECT_FALSE(recent(3, 7)) << "but in one before that";
  EXPECT_FALSE(recent(4, 8)) << "but something else";
}

TEST(Cache, StaysValidUntilItsVersionChanges) {
  KeptImages kept;
  const auto valid = [&](uint64_t number, uint64_t version, bool writes = true) {
    FrameGraph graph(kept, number);
    const Cache cache = graph.cache("c", {.name = "c", .format = colour_format, .extent = {8, 8}}, version);
    if (!cache.valid && writes) graph.pass({.name = "draw", .bindings = {storage_write(1, cache.image)}});
    graph.want(cache.image);
    note_kept(graph, cull(graph));
    return cache.valid;
  };
  EXPECT_FALSE(valid(0, 7));
  EXPECT_TRUE(valid(1, 7));
  EXPECT_TRUE(valid(9, 7)) << "a gap does not matter";
  EXPECT_FALSE(valid(10, 8, false));
  EXPECT_FALSE(valid(11, 8)) << "declared, but never drawn";
  EXPECT_TRUE(valid(12, 8));
}

} // namespace
} // namespace unghost
