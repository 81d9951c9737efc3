#include "app/demo/shader_build.h"

#include <functional>
#include <thread>

#include <gtest/gtest.h>

#include "app/failure.h"
#include "tests/app/scratch_folder.h"

namespace unghost {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

/// As long as nothing is wrong it takes no time.
bool comes_true(const std::function<bool()>& condition) {
  for (int i = 0; i < 3000; ++i, std::this_thread::sleep_for(10ms))
    if (condition()) return true;
  return false;
}

/// In a tree whose CMake is a script of the test's.
class ShaderBuildTest : public testing::Test {
protected:
  void SetUp() override {
    fs::create_directory(sources);
    fs::create_directory(shaders);
    say(folder.path);
  }
  void say(const fs::path& tree) const {
    folder.file("shaders/built_by.txt",
                (folder.path / "cmake").string() + "\n" + tree.string() + "\n" + sources.string() + "\n");
  }
  void cmake(const std::string& script) const {
    fs::permissions(folder.file("cmake", "#!/bin/sh\n" + script), fs::perms::owner_all);
  }
  /// Two looks later; what came of a build that ended.
  static std::optional<ShaderBuild::Result> look_twice(ShaderBuild& build, FileWatch::Time& now) {
    build.look(now += 1s);
    return build.look(now += 1s);
  }
  std::optional<ShaderBuild::Result> end_of(ShaderBuild& build) {
    std::optional<ShaderBuild::Result> result;
    EXPECT_TRUE(comes_true([&] { return (result = build.look(now)) || !build.running(); }));
    return result;
  }

  ScratchFolder folder;
  const fs::path sources = folder.path / "sources", shaders = folder.path / "shaders";
  FileWatch::Time now{1h};
};

TEST_F(ShaderBuildTest, IsOfTheTreeThatTheShadersLieIn) {
  const auto tree = ShaderBuild::tree_of(shaders);
  ASSERT_TRUE(tree);
  EXPECT_EQ(tree->sources, sources);
  EXPECT_FALSE(ShaderBuild::tree_of(folder.path)) << "none is named there";
  say(folder.path / "elsewhere");
  EXPECT_FALSE(ShaderBuild::tree_of(shaders)) << "they were copied";
  say(folder.path);
  fs::remove(sources);
  EXPECT_FALSE(ShaderBuild::tree_of(shaders)) << "the sources are gone";
}

TEST_F(ShaderBuildTest, WhatChangesWhileOneRunsIsBuiltAfterIt) {
  cmake("echo \"$@\" >> " + (folder.path / "words").string() + "\nwhile [ -e " +
        (folder.path / "hold").string() + " ]; do sleep 0.01; done\n");
  folder.file("hold", "");
  ShaderBuild build(*ShaderBuild::tree_of(shaders));
  folder.file("sources/a.comp", "1");
  EXPECT_FALSE(look_twice(build, now));
  EXPECT_TRUE(build.running());
  folder.file("sources/a.comp", "22");
  EXPECT_FALSE(look_twice(build, now));
  fs::remove(folder.path / "hold");
  EXPECT_FALSE(end_of(build)) << "there is nothing to say";
  build.look(now);
  EXPECT_TRUE(build.running());
  end_of(build);
  build.look(now += 1s);
  EXPECT_FALSE(build.running());
  const std::string words = "--build " + folder.path.string() + " --target shaders\n";
  std::ifstream stream(folder.path / "words");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), words + words);
}

TEST_F(ShaderBuildTest, AFaultLastsUntilOneSucceeds) {
  cmake("echo 'ERROR: " + (sources / "a.comp").string() + ":3: no'; echo more >&2; exit 1\n");
  ShaderBuild build(*ShaderBuild::tree_of(shaders));
  for (const char* content : {"1", "22"}) {
    folder.file("sources/a.comp", content);
    look_twice(build, now);
    const auto result = end_of(build);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->fault, "a.comp:3: no");
    EXPECT_TRUE(result->talk.ends_with("a.comp:3: no\nmore\n")) << result->talk;
    EXPECT_EQ(build.fault(), result->fault);
  }
  cmake("exit 0\n");
  folder.file("sources/a.comp", "333");
  look_twice(build, now);
  const auto mended = end_of(build);
  ASSERT_TRUE(mended);
  EXPECT_EQ(mended->fault, "");
  EXPECT_EQ(build.fault(), "");
}

TEST_F(ShaderBuildTest, ACompilerThatIsNotThereIsToldInASentence) {
  ShaderBuild build(*ShaderBuild::tree_of(shaders));
  folder.file("sources/a.comp", "1");
  const auto result = look_twice(build, now);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->fault, "cannot run " + (folder.path / "cmake").string() + ": No such file or directory");
  EXPECT_FALSE(build.running());
}

TEST_F(ShaderBuildTest, WhoSaysVeryMuchEnds) {
  cmake("head -c 3000000 /dev/zero; exit 1\n");
  ShaderBuild build(*ShaderBuild::tree_of(shaders));
  folder.file("sources/a.comp", "1");
  look_twice(build, now);
  const auto result = end_of(build);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->talk.size(), size_t(1) << 20);
}

TEST(ShaderErrors, TheFirstOneIsToldWithoutItsFolder) {
  const std::string talk =
      "[1/2] Generating shaders/a.comp.spv\nFAILED: shaders/a.comp.spv /b/shaders/a.comp.spv \n"
      "cd /b && glslangValidator -o a.comp.spv /s/a.comp\n";
  EXPECT_EQ(
      first_error(talk + "WARNING: /s/a.comp:1: odd\nERROR: /s/shared/b.h:7: 'x' : undeclared identifier \n"
                         "ERROR: 1 compilation errors.  No code generated.\n",
                  "/s"),
      "shared/b.h:7: 'x' : undeclared identifier");
  EXPECT_EQ(first_error(talk + "ERROR: Linking compute stage: Missing entry point\n", "/s"),
            "a.comp: Linking compute stage: Missing entry point");
}

TEST(ShaderErrors, WhatIsNoErrorOfASourceIsTheLastThingThatWasSaid) {
  EXPECT_EQ(first_error("one\nninja: error: loading 'build.ninja': No such file or directory\n\n", "/s"),
            "the shaders cannot be built: ninja: error: loading 'build.ninja': No such file or directory");
  EXPECT_EQ(first_error("", "/s"), "the shaders cannot be built: CMake does not say why");
}

} // namespace
} // namespace unghost
