// The demo with --watch in a tree that its shaders are built in: sources that change under it.
#include "tests/window/watched_demo.h"

namespace unghost {
namespace {

namespace fs = std::filesystem;

class DemoShaders : public WatchedDemo {
protected:
  void SetUp() override {
    WatchedDemo::SetUp();
    if (IsSkipped()) return;
    fs::copy(UNGHOST_SHADER_SOURCES, sources, fs::copy_options::recursive);
    fs::permissions(compiler, fs::perms::owner_all);
    ASSERT_EQ(exit_of({"env", "-C", folder.path.string(), UNGHOST_CMAKE, "-S", sources.string(), "-B",
                       folder.path.string(), "-G", UNGHOST_GENERATOR, "-DGLSLANG=" + compiler.string()},
                      {}),
              0);
    ASSERT_EQ(exit_of({UNGHOST_CMAKE, "--build", folder.path.string()}), 0);
  }

  /// Changes a source: after `mark`, that is put in.
  void put(const std::string& name, const std::string& mark, const std::string& what) const {
    std::string source = content_of(sources / name);
    const size_t at = source.find(mark);
    ASSERT_NE(at, std::string::npos) << name;
    replace(sources / name, source.insert(at + mark.size(), what));
  }
  void darken() const { put("tonemap.comp", "* frame.exposure", " * 0.25"); }
  /// Without TAA no frame differs from the one before.
  Words still() const { return watching("off", "still"); }
  static void expect_darker(const Picture& now, const Picture& before) {
    ASSERT_EQ(now.size, before.size);
    EXPECT_NE(now.pixels, before.pixels);
    for (size_t i = 0; i < now.pixels.size(); ++i)
      for (size_t c = 0; c < 3; ++c) ASSERT_LE(now.pixels[i][c], before.pixels[i][c]) << i;
  }
  static std::string next_fault(DemoRun& run) { return run.expect_event("shader sources")["message"]; }
  /// Whether what is written below the picture has two lines, as only a compiler's words have here.
  static bool tells_much(const DemoRun& run) {
    const Picture picture = run.window().picture();
    size_t white = 0;
    for (int y = picture.size.height - 53; y < picture.size.height - 42; ++y)
      for (int x = 0; x < picture.size.width; ++x)
        white += picture.at({x, y}) == std::array<uint8_t, 3>{255, 255, 255};
    return white > 40;
  }
  void expect_compiling() const {
    ASSERT_TRUE(comes_true([&] { return fs::exists(begun); }));
  }

  const fs::path sources = folder.path / "sources", hold = folder.path / "hold",
                 begun = folder.path / "begun";
  /// The compiler, which waits for as long as there is a file `hold`, and says that it does.
  const fs::path compiler = folder.file(
      "glslang", "#!/bin/sh\nif [ -e " + hold.string() + " ]; then echo $$ > " + begun.string() +
                     ".new; mv " + begun.string() + ".new " + begun.string() + "; fi\nwhile [ -e " +
                     hold.string() + " ]; do sleep 0.02; done\nexec " + UNGHOST_GLSLANG + " \"$@\"\n");
};

TEST_F(DemoShaders, AChangedSourceDrawsAnotherPictureAndTheFirstOneTheFirst) {
  DemoRun run(*desk, still());
  stand_still(run);
  const Picture before = resting(run);
  const std::string source = content_of(sources / "tonemap.comp");
  darken();
  EXPECT_EQ(run.expect_event("shaders")["message"], "other shaders");
  expect_darker(resting(run), before);
  replace(sources / "tonemap.comp", source);
  EXPECT_EQ(run.expect_event("shaders")["message"], "other shaders");
  EXPECT_EQ(resting(run).pixels, before.pixels);
  EXPECT_EQ(run.talk(), "");
  EXPECT_EQ(run.leave(), 0) << run.talk();
}

TEST_F(DemoShaders, AnIncludeIsCompiledIntoAllThatNameIt) {
  DemoRun run(*desk, still());
  stand_still(run);
  const Picture before = resting(run);
  put("shared/tonemap.h", "display_from_linear(", "vec3 bright) { return bright * 0.0; }\nvec3 lighter(");
  EXPECT_EQ(run.expect_event("shaders")["message"], "other shaders");
  expect_darker(resting(run), before);
  EXPECT_EQ(run.leave(), 0) << run.talk();
}

TEST_F(DemoShaders, OneThatDoesNotCompileIsToldUntilItIsMendedAndTheOldOnesDraw) {
  DemoRun run(*desk, still());
  stand_still(run);
  const Picture before = resting(run);
  const std::string source = content_of(sources / "tonemap.comp");
  const auto line =
      std::count(source.begin(), source.begin() + ptrdiff_t(source.find("frame.exposure")), '\n') + 1;
  put("tonemap.comp", "* frame.exposure", " * nowhere");
  EXPECT_EQ(next_fault(run), "tonemap.comp:" + std::to_string(line) + ": 'nowhere' : undeclared identifier");
  EXPECT_EQ(resting(run).pixels, before.pixels);
  EXPECT_NE(run.talk().find("ERROR: " + sources.string() + "/tonemap.comp"), std::string::npos) << run.talk();
  EXPECT_NE(run.talk().find("No code generated"), std::string::npos) << "not in full: " << run.talk();
  run.press("u", "only the picture"); // and what is above it
  EXPECT_TRUE(comes_true([&] { return tells_much(run); }));
  run.press("Home", "camera"); // something else is said for a while
  EXPECT_TRUE(comes_true([&] { return !tells_much(run); }));
  EXPECT_TRUE(comes_true([&] { return tells_much(run); }));
  replace(sources / "tonemap.comp", source);
  EXPECT_EQ(next_fault(run), "the shaders compile again");
  EXPECT_EQ(run.expect_event("shaders")["message"], "other shaders");
  EXPECT_TRUE(comes_true([&] { return !tells_much(run); }));
  EXPECT_EQ(difference(resting(run), before), 0);
  EXPECT_EQ(run.leave(), 0) << run.talk();
}

TEST_F(DemoShaders, AnIncludeThatIsMissingHealsWhenItComes) {
  DemoRun run(*desk, still());
  put("tonemap.comp", "#include \"fullscreen.glsl\"\n", "#include \"later.glsl\"\n");
  const std::string fault = next_fault(run);
  EXPECT_TRUE(fault.starts_with("tonemap.comp:") && fault.ends_with("later.glsl")) << fault;
  folder.file("sources/later.glsl", "");
  EXPECT_EQ(next_fault(run), "the shaders compile again");
  EXPECT_EQ(run.leave(), 0) << run.talk();
}

TEST_F(DemoShaders, TheWindowGoesOnWhileTheyCompile) {
  DemoRun run(*desk, still());
  folder.file("hold", "");
  darken();
  expect_compiling();
  const uint64_t drawn = run.press("Tab", "movement")["drawn"];
  EXPECT_TRUE(comes_true([&] { return run.press("Tab", "movement")["drawn"] > drawn + 3; }));
  fs::remove(hold);
  EXPECT_EQ(run.expect_event("shaders")["message"], "other shaders");
  EXPECT_EQ(run.leave(), 0) << run.talk();
  EXPECT_EQ(run.talk(), "");
}

TEST_F(DemoShaders, NothingIsLeftOfACompilationWhenItIsClosed) {
  DemoRun run(*desk, still());
  folder.file("hold", "");
  darken();
  expect_compiling();
  const fs::path compiling = fs::path("/proc") / std::to_string(std::stoi(content_of(begun)));
  EXPECT_TRUE(fs::exists(compiling));
  EXPECT_EQ(run.leave(), 0) << run.talk();
  EXPECT_TRUE(comes_true([&] { return !fs::exists(compiling); }));
  EXPECT_EQ(run.talk(), "");
}

} // namespace
} // namespace unghost
