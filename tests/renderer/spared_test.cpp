// What a frame spares itself inside of its passes: the same numbers come out where nothing is spared.
#include <algorithm>

#include "tests/renderer/studio.h"

namespace unghost {
namespace {

class Spared : public StudioTest {
protected:
  static FrameResult drawn(Renderer& renderer, const char* rig, int frame, const char* mode,
                           std::vector<Wanted> wanted, bool keeps_all = false) {
    FrameInput input = studio->frame(rig, frame, {run_of(mode)}, std::move(wanted));
    input.settings.keep_all = keeps_all;
    return renderer.render(input);
  }
  static bool is_left_out(const FrameResult& result, std::string_view what) {
    return std::ranges::find(result.left_out, what, &LeftOut::what) != result.left_out.end();
  }
};

TEST_F(Spared, ShadowsOfWhatMovedAreCoveredByWhatRests) {
  for (const char* rig : {"drive", "pass"}) {
    Renderer all(studio->device, studio->data.shaders, studio->staged.scene);
    size_t patched = 0;
    for (const int frame :
         {0, 1, 2, 3, 4, 9, 10, 11, 40, 41, 42}) { // also with gaps, over which things move far
      const FrameResult spared = drawn(studio->renderer, rig, frame, "off", {{Output::sun_visibility}});
      const FrameResult whole = drawn(all, rig, frame, "off", {{Output::sun_visibility}}, true);
      ASSERT_EQ(spared.delivered[0].image.values, whole.delivered[0].image.values) << rig << " " << frame;
      patched += is_left_out(spared, "shadows where nothing moved");
      EXPECT_FALSE(is_left_out(whole, "shadows where nothing moved"));
    }
    EXPECT_GT(patched, 3u) << rig;
  }
}

TEST_F(Spared, ShadowsThatNobodyReadForAWhileAreWhole) {
  Renderer all(studio->device, studio->data.shaders, studio->staged.scene);
  for (const int frame : {40, 41, 60, 61, 62}) { // few enough not to be forgotten
    const bool reads = frame != 60 && frame != 61;
    const Wanted wanted{reads ? Output::sun_visibility : Output::depth};
    const FrameResult spared = drawn(studio->renderer, "pass", frame, "off", {wanted});
    const FrameResult whole = drawn(all, "pass", frame, "off", {wanted}, true);
    ASSERT_EQ(spared.delivered[0].image.values, whole.delivered[0].image.values) << frame;
  }
}

TEST_F(Spared, MotionAndLightOfWhatIsHiddenAreNotSeen) {
  Renderer all(studio->device, studio->data.shaders, studio->staged.scene);
  for (const char* rig : {"drive", "pass", "rotate"})
    for (int frame = 0; frame < 3; ++frame) {
      const std::vector<Wanted> wanted{{Output::lit}, {Output::motion}};
      const FrameResult spared = drawn(studio->renderer, rig, frame, "blend", wanted);
      const FrameResult whole = drawn(all, rig, frame, "blend", wanted, true);
      EXPECT_EQ(is_left_out(spared, "emissive and motion of what has none"), true);
      for (size_t i = 0; i < wanted.size(); ++i)
        ASSERT_EQ(spared.delivered[i].image.values, whole.delivered[i].image.values) << rig << " " << frame;
    }
}

TEST_F(Spared, TagsAreThereForWhoeverAsks) {
  const auto tags = [&](const char* mode) {
    FloatImage image = drawn(studio->renderer, "drive", 0, mode, {{Output::tag}}).delivered[0].image;
    return image.values;
  };
  const std::vector<float> asked = tags("grand-tour");
  EXPECT_GT(std::ranges::count_if(asked, [](float tag) { return tag > 0; }), 100);
  EXPECT_EQ(tags("gdk-clamp"), asked) << "a mode without tags, whose readers they are not";
}

} // namespace
} // namespace unghost
