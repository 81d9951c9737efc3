// Nothing is in the frame that the scene does not need, and nobody sees that it is not.
#include <algorithm>
#include <cstdlib>
#include <functional>

#include "renderer/view.h"
#include "tests/renderer/box_scene.h"
#include "tests/renderer/studio.h"

namespace unghost {
namespace {

constexpr uint64_t texel_bytes_at_most = 4096; // of an image of 1x1, which stands for one that is not made
constexpr int frames = 3;                      // from a cut: the first has no history

/// A frame of a run, and the picture that it shows.
struct Drawn {
  FrameResult frame;
  std::vector<uint8_t> display;
  std::vector<float> resolved;

  bool looks_like(const Drawn& other) const { return display == other.display && resolved == other.resolved; }
  std::vector<std::string> passes() const {
    std::vector<std::string> names;
    for (const PassReport& pass : frame.passes)
      if (!pass.name.starts_with("read back")) names.push_back(pass.name);
    return names;
  }
  /// Whether some image, or one that shares its memory, has that in its name; those of a texel stand for
  /// none.
  bool has_image(std::string_view name) const {
    return std::ranges::any_of(frame.images, [&](const UsedImage& image) {
      return image.bytes > texel_bytes_at_most && image.name.find(name) != std::string::npos;
    });
  }
  /// Of the images that this pass is the first to touch. Those of a whole frame may stay as they are without
  /// one: what comes later takes its memory.
  uint64_t bytes_of(std::string_view pass) const {
    const auto found = std::ranges::find(frame.passes, pass, &PassReport::name);
    return found == frame.passes.end() ? 0 : found->image_bytes;
  }
  /// The longest pipeline whose shader is named so.
  UsedPipeline pipeline(std::string_view shader) const {
    UsedPipeline longest;
    for (const PassReport& pass : frame.passes)
      for (const UsedPipeline& used : pass.pipelines)
        if (used.shader.find(shader) != std::string::npos && used.instructions > longest.instructions)
          longest = used;
    return longest;
  }
  std::string why_without(std::string_view what) const {
    const auto found = std::ranges::find(frame.left_out, what, &LeftOut::what);
    return found == frame.left_out.end() ? "" : found->why;
  }
};

class Needed : public StudioTest {
protected:
  using Change = std::function<void(FrameInput&)>;
  using Modes = std::vector<std::string_view>;

  Renderer renderer_of(Scene scene) const { return {studio->device, studio->data.shaders, std::move(scene)}; }
  /// The last of some frames. `change` has the last word on each.
  Drawn draw(Renderer& renderer, const char* rig, const Modes& modes, const Change& change = {}) const {
    Drawn drawn;
    for (int index = 0; index < frames; ++index) {
      FrameInput input = studio->frame(rig, index, {}, {});
      input.width = 160, input.height = 90;
      for (size_t mode = 0; mode < modes.size(); ++mode) {
        input.modes.push_back(run_of(modes[mode]));
        input.wanted.insert(input.wanted.end(), {{Output::display, mode}, {Output::resolved, mode}});
      }
      if (change) change(input);
      drawn.frame = renderer.render(input);
    }
    for (const Delivered& delivered : drawn.frame.delivered) {
      const std::vector<uint8_t>& bytes = delivered.picture.rgba;
      const std::vector<float>& values = delivered.image.values;
      drawn.display.insert(drawn.display.end(), bytes.begin(), bytes.end());
      drawn.resolved.insert(drawn.resolved.end(), values.begin(), values.end());
    }
    return drawn;
  }
  /// The same with everything but one thing kept.
  Drawn draw_all(Renderer& renderer, const char* rig, const Modes& modes, const Change& change = {},
                 const std::string& but = {}) const {
    return draw(renderer, rig, modes, [&](FrameInput& input) {
      if (change) change(input);
      input.settings.keep_all = true, input.left_out = but;
    });
  }
  /// Both are the same to the bit, or whatever it is that changes a bit is named. Returns the lean one.
  Drawn expect_same(Renderer& renderer, const char* rig, const Modes& modes,
                    const Change& change = {}) const {
    SCOPED_TRACE(std::string(modes.front()) + " on " + rig);
    const Drawn lean = draw(renderer, rig, modes, change), all = draw_all(renderer, rig, modes, change);
    EXPECT_LT(lean.frame.image_bytes, all.frame.image_bytes);
    EXPECT_TRUE(all.frame.left_out.empty()) << all.frame.left_out.front().what;
    if (lean.looks_like(all)) return lean;
    ADD_FAILURE() << "keeping everything changes the picture";
    for (const LeftOut& thing : lean.frame.left_out)
      if (draw_all(renderer, rig, modes, change, thing.what).looks_like(lean))
        ADD_FAILURE() << "and keeping all but '" << thing.what << "' does not";
    return lean;
  }
  static void without_sun(FrameInput& input) { input.settings.light.sun_illuminance = 0; }
  /// The other way, and on.
  static void turn(FrameInput& input, double radians) {
    const glm::dquat now = input.now.camera;
    input.now.camera = now * glm::angleAxis(3 + radians * double(input.index), glm::dvec3(0, 1, 0));
    input.before.camera = now * glm::angleAxis(3 + radians * (double(input.index) - 1), glm::dvec3(0, 1, 0));
  }
};

class KeptAll : public Needed {};

using Names = std::vector<std::string>;

TEST_F(Needed, WhatRestsHasNoMotion) {
  const Drawn still = expect_same(studio->renderer, "still", {"gdk-clamp"});
  const Drawn moves = draw(studio->renderer, "drive", {"gdk-clamp"});
  EXPECT_TRUE(moves.has_image("object motion"));
  EXPECT_FALSE(still.has_image("motion")) << "neither that of objects nor any";
  EXPECT_EQ(std::ranges::count(still.passes(), "motion"), 0);
  const Drawn with_it = draw_all(studio->renderer, "still", {"gdk-clamp"}),
              without = draw_all(studio->renderer, "still", {"gdk-clamp"}, {}, "object motion");
  EXPECT_GE(with_it.bytes_of("g-buffer"), without.bytes_of("g-buffer") + 160 * 90 * 16);
  EXPECT_LT(still.pipeline("taa.comp").instructions, moves.pipeline("taa.comp").instructions);
  EXPECT_LT(still.pipeline("taa.comp").fetches, moves.pipeline("taa.comp").fetches);
  for (const PassReport& pass : still.frame.passes)
    for (const UsedPipeline& used : pass.pipelines)
      EXPECT_TRUE(used.shader.find("gbuffer") == std::string::npos || used.constants.at(1) == 0)
          << "a pipeline for what moves";
}

TEST_F(Needed, WithoutTagsThereIsNoTagHistory) {
  Scene scene = studio->staged.scene;
  for (Node& node : scene.nodes) node.tag = 0;
  Renderer untagged = renderer_of(std::move(scene));
  const Drawn without = expect_same(untagged, "drive", {"uncharted"}),
              with = draw(studio->renderer, "drive", {"uncharted"});
  EXPECT_EQ(without.why_without("tags"), "no object is tagged");
  EXPECT_EQ(with.why_without("tags"), "");
  EXPECT_LE(without.frame.image_bytes, with.frame.image_bytes + texel_bytes_at_most);
  EXPECT_LT(without.pipeline("taa.comp").instructions, with.pipeline("taa.comp").instructions);
  EXPECT_LT(without.pipeline("motion.comp").fetches, with.pipeline("motion.comp").fetches);
  EXPECT_EQ(draw(studio->renderer, "drive", {"rgb"}).why_without("tags"), "this mode asks for none");
}

TEST_F(Needed, ARowWithoutDilationReadsNoNeighboursDepth) {
  const Drawn centre = expect_same(studio->renderer, "drive", {"gdk-clamp"}),
              dilated = draw(studio->renderer, "drive", {"uncharted"});
  EXPECT_FALSE(centre.has_image("depth copy"));
  EXPECT_TRUE(dilated.has_image("depth copy"));
  const Drawn all = draw_all(studio->renderer, "drive", {"gdk-clamp"}),
              without = draw_all(studio->renderer, "drive", {"gdk-clamp"}, {}, "depth of neighbours");
  EXPECT_TRUE(without.looks_like(all));
  EXPECT_LT(without.pipeline("taa.comp").instructions, all.pipeline("taa.comp").instructions);
  EXPECT_LT(without.pipeline("taa.comp").fetches, all.pipeline("taa.comp").fetches);
  EXPECT_LE(without.frame.image_bytes, all.frame.image_bytes);
}

TEST_F(Needed, WithoutASunThereIsNoShadowMap) {
  const Drawn dark = expect_same(studio->renderer, "pass", {"gdk-clamp"}, without_sun),
              lit = draw(studio->renderer, "pass", {"gdk-clamp"});
  EXPECT_FALSE(dark.has_image("shadows"));
  EXPECT_EQ(dark.why_without("shadow map"), "the sun does not shine");
  EXPECT_LE(dark.frame.image_bytes + (16u << 20), lit.frame.image_bytes);
  EXPECT_LT(dark.pipeline("light.comp").instructions, lit.pipeline("light.comp").instructions);
  EXPECT_LT(dark.pipeline("light.comp").fetches, lit.pipeline("light.comp").fetches);
  for (const View view : {View::colour, View::light_channel})
    expect_same(studio->renderer, "drive", {"unghost"}, [&](FrameInput& input) {
      without_sun(input);
      input.settings.view = view;
    });
  expect_same(studio->renderer, "pass", {"off"}, [](FrameInput& input) {
    without_sun(input);
    input.settings.view = View::shadow; // which it still throws
  });
}

TEST_F(Needed, LightThatStaysIsNotFollowed) {
  const Drawn stays = expect_same(studio->renderer, "rotate", {"unghost"}),
              changes = expect_same(studio->renderer, "pass", {"unghost"});
  EXPECT_EQ(stays.why_without("light of the history"), "no light changes");
  EXPECT_EQ(changes.why_without("light of the history"), "");
  EXPECT_LT(stays.pipeline("taa.comp").instructions, changes.pipeline("taa.comp").instructions);
  Renderer unlit = renderer_of(box_of({.unlit = true}));
  EXPECT_EQ(expect_same(unlit, "rotate", {"unghost"}).why_without("light of the history"), "nothing is lit");
}

TEST_F(Needed, WhereAllRestsNothingIsBounded) {
  const auto why = [&](const Drawn& drawn) { return drawn.why_without("bounds of what is not known"); };
  EXPECT_EQ(why(expect_same(studio->renderer, "still", {"unghost"})), "nothing moves and no light changes");
  EXPECT_EQ(why(expect_same(studio->renderer, "rotate", {"unghost"})), "");
  EXPECT_EQ(why(expect_same(studio->renderer, "pass", {"unghost"})), "") << "a car drives by";
  EXPECT_EQ(why(expect_same(studio->renderer, "still", {"unghost-safe"})), "") << "which bounds all";
  const Drawn all = draw_all(studio->renderer, "still", {"unghost"}),
              without = draw_all(studio->renderer, "still", {"unghost"}, {}, "bounds of what is not known");
  EXPECT_LT(without.pipeline("taa.comp").instructions, all.pipeline("taa.comp").instructions);
}

TEST_F(Needed, OffHasNoHistoryNoJitterAndNoMotion) {
  const Drawn off = expect_same(studio->renderer, "drive", {"off"});
  EXPECT_FALSE(off.has_image("history") || off.has_image("motion,") || off.has_image("depth copy"));
  for (const std::string& name : off.passes())
    EXPECT_FALSE(name == "motion" || name.starts_with("taa")) << name;
  EXPECT_EQ(off.why_without("history"), "this mode keeps none");
  EXPECT_EQ(off.pipeline("taa").instructions, 0u);
  EXPECT_LT(off.frame.image_bytes, draw(studio->renderer, "drive", {"blend"}).frame.image_bytes);
  for (uint64_t index = 0; index < 4; ++index)
    EXPECT_EQ(jitter_offset(run_of("off").taa.policy.jitter, index), glm::dvec2(0));
}

TEST_F(Needed, WhatIsUnlitHasNoBrdf) {
  Renderer unlit = renderer_of(box_of({.base_colour = {0.8f, 0.2f, 0.1f, 1}, .unlit = true})),
           lit = renderer_of(box_of({.base_colour = {0.8f, 0.2f, 0.1f, 1}}));
  const Drawn plain = expect_same(unlit, "still", {"gdk-clamp"}),
              shaded = expect_same(lit, "still", {"gdk-clamp"}),
              all = draw_all(unlit, "still", {"gdk-clamp"});
  for (const char* image : {"albedo", "normal", "material", "shadows"})
    EXPECT_FALSE(plain.has_image(image)) << image;
  EXPECT_LE(3 * plain.frame.image_bytes, all.frame.image_bytes);
  EXPECT_LT(2 * plain.pipeline("light.comp").instructions, shaded.pipeline("light.comp").instructions);
  EXPECT_EQ(plain.pipeline("light.comp").fetches, 2u) << "depth, and its own colour";
  EXPECT_EQ(plain.passes(), (Names{"g-buffer", "light", "taa gdk-clamp", "tone map"}));
  EXPECT_EQ(plain.why_without("light on surfaces"), "every material is unlit");
  EXPECT_NE(plain.display, shaded.display);
}

TEST_F(Needed, AnEmptyViewIsASkyAndNothingElse) {
  Renderer box = renderer_of(box_of({.emissive = {1, 1, 1}}));
  const auto away = [](FrameInput& input) { turn(input, 0); };
  const Drawn sky = expect_same(box, "still", {"off"}, away), seen = draw(box, "still", {"off"});
  EXPECT_EQ(sky.passes(), (Names{"light", "tone map"}));
  EXPECT_EQ(sky.pipeline("light.comp").fetches, 0u);
  EXPECT_EQ(sky.why_without("g-buffer"), "nothing is in view");
  EXPECT_LT(sky.pipeline("light.comp").instructions, seen.pipeline("light.comp").instructions);
  EXPECT_LT(2 * sky.frame.image_bytes, seen.frame.image_bytes);
  const Drawn turning =
      expect_same(box, "still", {"grand-tour"}, [](FrameInput& input) { turn(input, 0.01); });
  EXPECT_EQ(turning.passes(), (Names{"light", "motion", "taa grand-tour", "tone map"}));
}

TEST_F(KeptAll, EveryModeLooksTheSame) {
  Modes all;
  for (const TaaMode& mode : taa_modes()) all.push_back(mode.name);
  expect_same(studio->renderer, "drive", all);
}

TEST_F(KeptAll, EveryRigAndViewLooksTheSame) {
  for (const Rig& rig : rigs()) expect_same(studio->renderer, std::string(rig.name).c_str(), {"uncharted"});
  for (const Answer& view : answers<View>())
    expect_same(studio->renderer, "drive", {"off", "grand-tour"},
                [&](FrameInput& input) { input.settings.view = View(view.value); });
}

TEST_F(KeptAll, TheNaiveResolveAndWhatNoRowHasLookTheSame) {
  expect_same(studio->renderer, "drive", {"grand-tour"},
              [](FrameInput& input) { input.modes[0].taa.resolver = Resolver::naive; });
  expect_same(studio->renderer, "still", {"rgb"}, [](FrameInput& input) {
    input.modes[0].taa.policy.dilation = Dilation::depth_edges;
    input.modes[0].taa.policy.reject = Reject::depth | Reject::object;
    input.modes[0].taa.policy.blend = Blend::counting;
  });
}

// The first frame's motion is none, and what it leaves of its keys the next one's motion reads.
TEST_F(KeptAll, KnownCausesLookTheSame) {
  for (const char* rig : {"still", "drive", "pass"})
    expect_same(studio->renderer, rig, {"rgb", "rgb"}, [](FrameInput& input) {
      input.modes = {run_of("unghost"), run_of("unghost-safe")};
    });
}

TEST_F(KeptAll, MasksLampsAndWhatShinesLookTheSame) {
  Material masked{.base_colour = {0.8f, 0.8f, 0.8f, 0.6f}, .alpha_mode = AlphaMode::mask};
  Material glass{.base_colour = {0.8f, 0.8f, 0.8f, 0.2f}}; // opaque, whatever its alpha
  Material shining{.emissive = {2, 1, 0.5f}};
  for (const Material& material : {masked, glass, shining}) {
    Renderer renderer = renderer_of(box_of(material));
    for (const char* rig : {"still", "rotate"}) expect_same(renderer, rig, {"grand-tour"});
  }
  Scene lamps = box_of({});
  lamps.lights.push_back({.intensity = {40, 30, 20}});
  lamps.nodes.push_back({.name = "lamp", .parent = 0, .light = 0});
  lamps.nodes.back().local.translation = {1, 3, 2};
  Renderer renderer = renderer_of(std::move(lamps));
  EXPECT_EQ(expect_same(renderer, "rotate", {"gdk-clamp"}).why_without("lamps"), "");
}

TEST_F(KeptAll, ModelsOfOthersLookTheSame) {
  const char* folder = std::getenv("UNGHOST_MODELS");
  if (folder == nullptr) GTEST_SKIP() << "UNGHOST_MODELS does not name a folder of models";
  for (const char* model : {"Box/Box.glb", "blender-io-01_alpha_mask/01_alpha_mask.gltf", "Lights/Lights.glb",
                            "BoxTextured/BoxTextured.gltf", "CesiumMilkTruck/CesiumMilkTruck.glb"}) {
    SCOPED_TRACE(model);
    Staged staged = build_stage(std::filesystem::path(folder) / "valid" / model,
                                studio->data.assets / "asphalt.glb", {.stage = Stage::none});
    Renderer renderer = renderer_of(std::move(staged.scene));
    expect_same(renderer, "rotate", {"uncharted"}, [](FrameInput& input) { input.now.animation_s += 0.25; });
  }
}

} // namespace
} // namespace unghost
