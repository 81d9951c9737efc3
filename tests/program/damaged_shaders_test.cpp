// A program whose shaders are missing or damaged on the disk.
#include <random>

#include "tests/program/program.h"

namespace unghost {
namespace {

namespace fs = std::filesystem;

class DamagedShaders : public ProgramTest {
protected:
  void SetUp() override {
    fs::copy(folder_of_this_program() / "shaders", folder_.path / "shaders");
    copy_program(folder_.path);
  }

  Ended capture() const {
    const std::string talk = (talk_.path / "talk").string();
    const int exit = wait_for(
        start(unvalidated + Words{at("unghost")} + small_capture + Words{at("a.png")}, folder_.path, talk));
    return {exit, content_of(talk)};
  }
  void expect_refused(const fs::path& file, const std::string& content) const {
    std::ofstream(file, std::ios::binary) << content;
    const Ended ended = capture();
    EXPECT_EQ(ended.exit, 1) << ended.talk;
    expect_sentence(ended, {file.string(), "build again"});
    EXPECT_FALSE(fs::exists(at("a.png")));
  }
};

TEST_F(DamagedShaders, AreOneAndASentenceWithTheFile) {
  ASSERT_EQ(capture().exit, 0);
  fs::remove(at("a.png"));
  const fs::path file = folder_.path / "shaders" / "tonemap.comp.spv";
  const std::string whole = content_of(file);
  ASSERT_GT(whole.size(), 400u);
  std::mt19937 random(1);
  std::string noise = whole.substr(0, 20), flipped = whole;
  while (noise.size() < whole.size()) noise += char(random());
  flipped[whole.size() / 2] = char(flipped[whole.size() / 2] ^ 4);
  for (const std::string& content : {std::string(), whole.substr(0, 8), whole.substr(0, whole.size() / 8 * 4),
                                     whole.substr(0, whole.size() - 2), noise.substr(20), noise, flipped})
    expect_refused(file, content);
  fs::remove(file);
  const Ended missing = capture();
  EXPECT_EQ(missing.exit, 1) << missing.talk;
  expect_sentence(missing, {file.string(), "missing", "build again"});
  std::ofstream(file, std::ios::binary) << whole;
  EXPECT_EQ(capture().exit, 0);
}

TEST_F(DamagedShaders, AndSoIsTheListOfThem) {
  expect_refused(folder_.path / "shaders" / "sums.txt", "");
  fs::remove_all(folder_.path / "shaders");
  const Ended none = capture();
  EXPECT_EQ(none.exit, 1) << none.talk;
  expect_sentence(none, {at("shaders"), "build it again"});
}

} // namespace
} // namespace unghost
