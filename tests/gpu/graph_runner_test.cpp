// The graph on a device: contents, histories, times. Only clears and copies, so that no shader is needed.
#include <cstring>

#include <gtest/gtest.h>

#include "renderer/gpu/graph_runner.h"

namespace unghost {
namespace {

constexpr VkFormat format = VK_FORMAT_R32G32B32A32_SFLOAT;
constexpr VkExtent2D extent{5, 3};

class Runner : public testing::Test {
protected:
  void TearDown() override {
    for (const std::string& message : device.validation_messages()) ADD_FAILURE() << message;
  }
  static void clear(FrameGraph& graph, ImageRef image, float value) {
    const VkClearValue colour{.color = {.float32 = {value, value, value, value}}};
    graph.pass({.name = "clear " + graph.desc(image).name,
                .kind = PassKind::raster,
                .attachments = {{image, colour}},
                .record = [](PassCommands& commands) {
                  commands.begin_rendering();
                  commands.end_rendering();
                }});
  }
  static void copy(FrameGraph& graph, ImageRef from, ImageRef to, VkExtent2D size) {
    graph.pass({.name = "copy",
                .kind = PassKind::transfer,
                .transfers = {{from, Use::transfer_source}, {to, Use::transfer_destination}},
                .record = [=](PassCommands& commands) {
                  constexpr VkImageSubresourceLayers colour{VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
                  const VkImageCopy region{colour, {}, colour, {}, {size.width, size.height, 1}};
                  vkCmdCopyImage(commands.commands(), commands.image(from),
                                 VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, commands.image(to),
                                 VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
                }});
  }
  static float first(const std::vector<std::byte>& bytes) {
    float value = -1;
    std::memcpy(&value, bytes.data(), sizeof value);
    return value;
  }

  Device device{{.validate = true}};
  GraphRunner runner{device, "no shader is asked for"};
};

TEST_F(Runner, BringsBackWhatAPassWroteAndTimesItByName) {
  FrameGraph graph(runner.kept(), 0);
  const ImageRef image = graph.image({.name = "image", .format = format, .extent = extent});
  clear(graph, image, 0.25f);
  graph.read_back(image, VK_IMAGE_ASPECT_COLOR_BIT);
  const RunResult result = runner.run(graph);
  ASSERT_EQ(result.readbacks.size(), 1u);
  ASSERT_EQ(result.readbacks[0].size(), 5u * 3 * 16);
  for (size_t i = 0; i < 5 * 3 * 4; ++i) {
    float value = 0;
    std::memcpy(&value, result.readbacks[0].data() + 4 * i, 4);
    ASSERT_EQ(value, 0.25f);
  }
  ASSERT_EQ(result.passes.size(), 2u);
  EXPECT_EQ(result.passes[0].name, "clear image");
  EXPECT_GE(result.passes[0].ms, 0);
  EXPECT_GE(result.passes[0].image_bytes, 5u * 3 * 16);
}

TEST_F(Runner, NeutralImagesAreZero) {
  FrameGraph graph(runner.kept(), 0);
  const ImageRef out = graph.image({.name = "out", .format = format});
  copy(graph, graph.neutral(format), out, {1, 1});
  graph.read_back(out, VK_IMAGE_ASPECT_COLOR_BIT);
  EXPECT_EQ(first(runner.run(graph).readbacks[0]), 0.0f);
}

TEST_F(Runner, HistoriesBringLastFramesContent) {
  for (uint64_t frame = 0; frame < 5; ++frame) {
    const uint32_t width = frame < 3 ? 5 : 7; // frame 3 is a resize
    FrameGraph graph(runner.kept(), frame);
    const History history =
        graph.history("h", {.name = "h", .format = VK_FORMAT_R32_SFLOAT, .extent = {width, 3}}, false);
    const ImageRef source =
        graph.image({.name = "source", .format = VK_FORMAT_R32_SFLOAT, .extent = {width, 3}});
    const ImageRef seen = graph.image({.name = "seen", .format = VK_FORMAT_R32_SFLOAT, .extent = {width, 3}});
    clear(graph, source, float(frame) + 1);
    copy(graph, source, history.next, {width, 3});
    copy(graph, history.previous, seen, graph.desc(history.previous).extent);
    graph.read_back(seen, VK_IMAGE_ASPECT_COLOR_BIT);
    EXPECT_EQ(history.valid, frame != 0 && frame != 3);
    EXPECT_EQ(first(runner.run(graph).readbacks[0]), history.valid ? float(frame) : 0.0f);
  }
}

TEST_F(Runner, CachesKeepTheirContentOverAGap) {
  for (const uint64_t frame : {0u, 1u, 2u}) {
    FrameGraph graph(runner.kept(), frame);
    const Cache cache = graph.cache("c", {.name = "c", .format = format, .extent = extent}, 7);
    EXPECT_EQ(cache.valid, frame != 0);
    if (!cache.valid) {
      const ImageRef source = graph.image({.name = "source", .format = format, .extent = extent});
      clear(graph, source, 3);
      copy(graph, source, cache.image, extent);
    }
    if (frame != 1) graph.read_back(cache.image, VK_IMAGE_ASPECT_COLOR_BIT);
    const RunResult result = runner.run(graph);
    if (frame != 1) {
      EXPECT_EQ(first(result.readbacks[0]), 3.0f);
    }
  }
}

TEST_F(Runner, ImagesOfPassesThatDoNotOverlapShareMemory) {
  const auto bytes = [&](int images, uint64_t frame) {
    FrameGraph graph(runner.kept(), frame);
    for (int i = 0; i < images; ++i) {
      const ImageRef image = graph.image({.name = "image", .format = format, .extent = {640, 360}});
      clear(graph, image, float(i));
      graph.read_back(image, VK_IMAGE_ASPECT_COLOR_BIT);
    }
    return runner.run(graph).image_bytes;
  };
  const uint64_t one = bytes(1, 0);
  EXPECT_EQ(bytes(4, 1), one);
}

} // namespace
} // namespace unghost
