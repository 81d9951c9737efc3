// The graph without a device: what runs, what exists, and which barriers stand between.
#include <gtest/gtest.h>

#include "renderer/gpu/frame_plan.h"

namespace unghost {
namespace {

constexpr VkFormat colour_format = VK_FORMAT_R16G16B16A16_SFLOAT;

struct Declared {
  KeptImages kept{};
  uint64_t frame = 0;
  Keeping keeping{};
  FrameGraph graph{kept, frame, keeping};

  ImageRef image(const char* name, VkFormat format = colour_format) {
    return graph.image({.name = name, .format = format, .extent = {64, 32}});
  }
  void compute(const char* name, std::vector<ImageRef> reads, std::vector<ImageRef> writes) {
    Pass pass{.name = name};
    uint32_t slot = 0;
    for (const ImageRef read : reads) pass.bindings.push_back(sampled(++slot, read));
    for (const ImageRef written : writes) pass.bindings.push_back(storage_write(++slot, written));
    graph.pass(std::move(pass));
  }
  std::vector<std::string> running() const {
    std::vector<std::string> names;
    for (const PlannedPass& pass : cull(graph).passes) names.push_back(graph.passes()[pass.pass].name);
    return names;
  }
  FramePlan planned() const {
    FramePlan plan = cull(graph);
    std::vector<uint32_t> place(graph.images().size());
    for (uint32_t i = 0; i < place.size(); ++i) place[i] = i;
    std::vector<ImageState> states(place.size());
    derive_barriers(graph, plan, place, states);
    return plan;
  }
};

using Names = std::vector<std::string>;

std::vector<LeftOut> unread_of(const Declared& d) { return unread(d.graph, cull(d.graph)); }

TEST(FramePlan, RunsNothingThatNobodyWants) {
  Declared d;
  const ImageRef a = d.image("a"), b = d.image("b"), c = d.image("c");
  d.compute("makes a", {}, {a});
  d.compute("makes b from a", {a}, {b});
  d.compute("makes c from a", {a}, {c});
  EXPECT_EQ(d.running(), Names{});
  d.graph.want(b);
  EXPECT_EQ(d.running(), (Names{"makes a", "makes b from a"}));
}

TEST(FramePlan, KeepsTheOrderOfDeclaration) {
  Declared d;
  const ImageRef a = d.image("a"), b = d.image("b"), c = d.image("c");
  d.compute("first", {}, {b});
  d.compute("second", {}, {a});
  d.compute("third", {a, b}, {c});
  d.graph.want(c);
  EXPECT_EQ(d.running(), (Names{"first", "second", "third"}));
}

TEST(FramePlan, AllocatesOnlyWhatLives) {
  Declared d;
  const ImageRef wanted = d.image("wanted"), unread = d.image("unread"), never = d.image("never");
  d.compute("makes both", {}, {wanted, unread});
  d.compute("makes none", {unread}, {never});
  d.graph.want(wanted);
  const FramePlan plan = cull(d.graph);
  EXPECT_TRUE(plan.images[wanted.index].live);
  EXPECT_TRUE(plan.images[unread.index].needed); // its descriptor must be valid: 1x1
  EXPECT_FALSE(plan.images[unread.index].live);
  EXPECT_FALSE(plan.images[never.index].needed);
}

TEST(FramePlan, DropsAttachmentsThatNobodyReads) {
  Declared d;
  const ImageRef albedo = d.image("albedo"), object = d.image("object", VK_FORMAT_R32_UINT),
                 depth = d.image("depth", VK_FORMAT_D32_SFLOAT_S8_UINT), lit = d.image("lit");
  const VkClearValue zero{};
  d.graph.pass({.name = "g-buffer",
                .kind = PassKind::raster,
                .attachments = {{albedo, zero}, {object, zero}, {depth, zero, Use::depth_attachment}}});
  d.compute("light", {albedo}, {lit});
  d.graph.want(lit);
  const FramePlan plan = d.planned();
  EXPECT_FALSE(plan.images[object.index].needed);
  EXPECT_TRUE(plan.images[depth.index].live) << "the depth test reads it";
  for (const ImageBarrier& barrier : plan.passes[0].barriers) EXPECT_NE(barrier.image, object);
}

TEST(FramePlan, KeepsAttachmentsTogetherThatSaySo) {
  Declared d;
  const ImageRef read = d.image("read"), beside = d.image("beside"), alone = d.image("alone"),
                 out = d.image("out");
  d.graph.pass({.name = "draws",
                .kind = PassKind::raster,
                .attachments = {{.image = read, .clear = VkClearValue{}, .together = true},
                                {.image = beside, .clear = VkClearValue{}, .together = true},
                                {.image = alone, .clear = VkClearValue{}}}});
  d.compute("reads one", {read}, {out});
  d.graph.want(out);
  const FramePlan plan = cull(d.graph);
  EXPECT_TRUE(plan.images[beside.index].live);
  EXPECT_TRUE(plan.images[beside.index].needed);
  EXPECT_FALSE(plan.images[alone.index].needed);
}

TEST(FramePlan, WhatIsLeftOutIsWrittenDownOnce) {
  Declared d;
  const ImageRef motion = d.image("motion"), out = d.image("out"), unread = d.image("unread"),
                 never = d.image("never");
  EXPECT_TRUE(d.graph.needed(true, {"lamps", "there is none"}));
  EXPECT_FALSE(d.graph.needed(false, {"motion", "nothing moves"}, {motion}));
  EXPECT_FALSE(d.graph.needed(false, {"motion", "asked again"}, {motion}));
  d.compute("makes three", {}, {motion, out, unread});
  d.compute("never runs", {out}, {never});
  d.compute("motion", {}, {d.image("in its place")});
  d.graph.want(out);
  ASSERT_EQ(d.graph.left_out().size(), 1u);
  EXPECT_EQ(d.graph.left_out()[0].why, "nothing moves");
  Names nobody_reads;
  for (const LeftOut& thing : unread_of(d)) nobody_reads.push_back(thing.what);
  EXPECT_EQ(nobody_reads, (Names{"unread", "never runs"})) << "the image of a pass that runs, and the pass";
}

TEST(FramePlan, EverythingIsKeptButOneThing) {
  for (const std::string but : {"", "motion", "unread", "never runs"}) {
    Declared d{.keeping = {.all = true, .but = but}};
    const ImageRef motion = d.image("of motion"), out = d.image("out"), unread = d.image("unread"),
                   never = d.image("never"), namesake = d.image("motion");
    EXPECT_EQ(d.graph.needed(false, {"motion", "nothing moves"}, {motion}), but != "motion");
    d.compute("makes four", {}, {motion, out, unread, namesake});
    d.compute("never runs", {out}, {never});
    d.graph.want(out);
    const FramePlan plan = cull(d.graph);
    EXPECT_TRUE(plan.images[namesake.index].live) << "what was asked for by name is that, and nothing else";
    EXPECT_EQ(plan.images[motion.index].live, but != "motion") << but;
    EXPECT_EQ(plan.images[unread.index].live, but != "unread") << but;
    EXPECT_EQ(plan.passes.size(), but == "never runs" ? 1u : 2u) << but;
    EXPECT_TRUE(plan.images[out.index].live);
  }
}

TEST(FramePlan, WhatIsOverwrittenUnseenIsNotMade) {
  Declared d;
  const ImageRef a = d.image("a");
  d.compute("unseen", {}, {a});
  d.compute("seen", {}, {a});
  d.graph.want(a);
  EXPECT_EQ(d.running(), Names{"seen"});
}

TEST(FramePlan, APatchNeedsWhatIsAroundIt) {
  for (const bool part : {false, true}) {
    Declared d;
    const ImageRef from = d.image("from"), to = d.image("to");
    d.compute("around", {}, {to});
    d.compute("source", {}, {from});
    CopyPass copy{.name = "copy", .from = from, .to = to};
    if (part) copy.part = VkRect2D{{0, 0}, {1, 1}};
    d.graph.copy(copy);
    d.graph.want(to);
    EXPECT_EQ(d.running(), (part ? Names{"around", "source", "copy"} : Names{"source", "copy"}));
  }
}

TEST(FramePlan, ReadBacksAreRoots) {
  Declared d;
  const ImageRef a = d.image("a");
  d.compute("makes a", {}, {a});
  d.graph.read_back(a, VK_IMAGE_ASPECT_COLOR_BIT);
  EXPECT_EQ(d.running(), (Names{"makes a", "read back a"}));
}

TEST(FramePlan, BarrierFromWriteToRead) {
  Declared d;
  const ImageRef a = d.image("a"), b = d.image("b");
  d.compute("writes", {}, {a});
  d.compute("reads", {a}, {b});
  d.graph.want(b);
  const FramePlan plan = d.planned();
  ASSERT_EQ(plan.passes[1].barriers.size(), 2u); // a is read, b is written for the first time
  const ImageBarrier& barrier = plan.passes[1].barriers[0];
  EXPECT_EQ(barrier.image, a);
  EXPECT_EQ(barrier.from, VK_IMAGE_LAYOUT_GENERAL);
  EXPECT_EQ(barrier.to, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  EXPECT_EQ(barrier.from_stages, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT);
  EXPECT_EQ(barrier.from_access, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
  EXPECT_EQ(barrier.to_stages, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT);
  EXPECT_EQ(barrier.to_access, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT);
}

TEST(FramePlan, SecondReadInTheSameStageNeedsNoBarrier) {
  Declared d;
  const ImageRef a = d.image("a"), b = d.image("b"), c = d.image("c");
  d.compute("writes", {}, {a});
  d.compute("reads", {a}, {b});
  d.compute("reads again", {a}, {c});
  d.graph.want(b);
  d.graph.want(c);
  const FramePlan plan = d.planned();
  for (const ImageBarrier& barrier : plan.passes[2].barriers) EXPECT_NE(barrier.image, a);
}

TEST(FramePlan, ReadInAnotherStageWaitsForTheWrite) {
  Declared d;
  const ImageRef a = d.image("a"), b = d.image("b"), c = d.image("c");
  d.compute("writes", {}, {a});
  d.compute("reads", {a}, {b});
  d.graph.pass({.name = "reads in fragments",
                .kind = PassKind::raster,
                .bindings = {sampled(1, a)},
                .attachments = {{c, VkClearValue{}}}});
  d.graph.want(b);
  d.graph.want(c);
  const FramePlan plan = d.planned();
  bool found = false;
  for (const ImageBarrier& barrier : plan.passes[2].barriers)
    if (barrier.image == a) {
      found = true;
      EXPECT_EQ(barrier.to_stages, VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT);
      EXPECT_NE(barrier.from_stages & VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, 0u);
      EXPECT_EQ(barrier.from, barrier.to);
    }
  EXPECT_TRUE(found);
}

TEST(FramePlan, WriteAfterReadWaitsForTheReaders) {
  Declared d;
  const ImageRef a = d.image("a"), b = d.image("b");
  d.compute("writes", {}, {a});
  d.compute("reads", {a}, {b});
  d.graph.pass({.name = "overwrites", .bindings = {sampled(1, b), storage_write(2, a)}});
  d.graph.want(a);
  const FramePlan plan = d.planned();
  bool found = false;
  for (const ImageBarrier& barrier : plan.passes[2].barriers)
    if (barrier.image == a) {
      found = true;
      EXPECT_NE(barrier.from_stages & VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, 0u);
      EXPECT_EQ(barrier.to_access, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
    }
  EXPECT_TRUE(found);
}

TEST(FramePlan, ContentOfThisFrameStartsUndefinedAndKeptContentDoesNot) {
  KeptImages kept;
  const ImageDesc desc{.name = "h", .format = colour_format, .extent = {8, 8}};
  const auto frame = [&](uint64_t number) {
    FrameGraph graph(kept, number);
    const History history = graph.history("h", desc, false);
    graph.pass(
        {.name = "resolve", .bindings = {sampled(1, history.previous), storage_write(2, history.next)}});
    FramePlan plan = cull(graph);
    std::vector<uint32_t> place{0, 1};
    std::vector<ImageState> states(2, {.layout = VK_IMAGE_LAYOUT_GENERAL});
    derive_barriers(graph, plan, place, states);
    note_kept(graph, plan);
    EXPECT_EQ(history.valid, number > 0);
    for (const ImageBarrier& barrier : plan.passes[0].barriers)
      EXPECT_EQ(barrier.from == VK_IMAGE_LAYOUT_UNDEFINED, barrier.image == history.next);
  };
  frame(0);
  frame(1);
  frame(2);
}

} // namespace
} // namespace unghost
