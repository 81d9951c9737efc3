// Settings that are damaged, and variables that are nonsense.
#include <random>

#include <sys/stat.h>

#include "tests/program/program.h"

namespace unghost {
namespace {

namespace fs = std::filesystem;

class DamagedSettings : public ProgramTest {
protected:
  std::string noise(size_t count) const {
    std::mt19937 random(7);
    std::string bytes;
    while (bytes.size() < count) bytes += char(random());
    return bytes;
  }
};

TEST_F(DamagedSettings, OfSettingsAreThreeAndASentenceWithTheFile) {
  const std::string picture = undisturbed(small_capture, "a.png");
  constexpr size_t deep = 1'000'000;
  std::string nested = "{\"alpha\": ";
  for (size_t i = 0; i < deep; ++i) nested += "{\"a\":";
  nested += "1" + std::string(deep + 1, '}');
  std::string carried = picture; // a picture whose settings are damaged
  carried[carried.find("\"settings\"") + 3] ^= 1;
  const std::pair<const char*, std::string> files[] = {
      {"empty", ""},
      {"half", R"({"alpha": 0.)"},
      {"noise", noise(5000)},
      {"nothing", std::string(100, '\0')},
      {"brackets", std::string(deep, '[')},
      {"deep", nested},
      {"large-number", R"({"alpha": 1e999})"},
      {"another-kind", R"({"alpha": {"of": ["a", null]}})"},
      {"half-a-picture", picture.substr(0, 60)},
      {"picture", carried},
  };
  for (const auto& [name, content] : files) {
    folder_.file(name, content);
    const Ended ended = run(small_capture + Words{at("b.png"), "--settings", at(name)});
    EXPECT_EQ(ended.exit, 3) << name << ended.talk;
    expect_sentence(ended, {at(name)});
    EXPECT_LT(ended.talk.size(), 400u) << name;
  }
  ASSERT_EQ(mkfifo(at("pipe").c_str(), 0600), 0);
  EXPECT_EQ(run(small_capture + Words{at("b.png"), "--settings", at("pipe")}).exit, 3)
      << "and it does not hang";
  EXPECT_EQ(run(small_capture + Words{at("b.png"), "--settings", at("")}).exit, 3);
  EXPECT_FALSE(fs::exists(at("b.png")));
}

TEST_F(DamagedSettings, VariablesThatAreNonsenseAreTwo) {
  for (const char* value : {"", "yes", "2"}) {
    const Ended ended = run({"modes"}, {"env", std::string("UNGHOST_VALIDATE=") + value});
    EXPECT_EQ(ended.exit, 2) << value;
    expect_sentence(ended, {"UNGHOST_VALIDATE is 0 or 1"});
  }
}

} // namespace
} // namespace unghost
