// Devices that are lost or full, by a layer between the program and the driver: see tests/fault_layer.
#include "tests/program/program.h"

namespace unghost {
namespace {

namespace fs = std::filesystem;

constexpr const char* plan = R"({"rigs": ["drive"], "sizes": ["64x36"], "seeds": [1, 2],
  "modes": ["blend"], "what": ["ghosting"], "frames": 18})";

class DeviceFaults : public ProgramTest {
protected:
  static Words faulty(const std::string& faults) {
    return {"env", "VK_ADD_LAYER_PATH=" + (folder_of_this_program() / "fault_layer").string(),
            "VK_INSTANCE_LAYERS=VK_LAYER_UNGHOST_faults", "FAULTS=" + faults};
  }
  /// How often the program asks the device to work for these words.
  size_t submissions(const Words& words) const {
    const Ended ended = run(words, faulty("count"));
    EXPECT_EQ(ended.exit, 0) << ended.talk;
    const size_t said = ended.talk.rfind("submissions: "); // of the last device, with those before it
    return said == std::string::npos ? 0 : std::stoul(ended.talk.substr(said + 13));
  }
  std::vector<fs::path> files_in(const std::string& name) const {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(at(name)))
      if (entry.is_regular_file()) files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
  }
};

TEST_F(DeviceFaults, AreFiveASentenceAndNoPicture) {
  const size_t all = submissions(small_capture + Words{at("whole.png")});
  ASSERT_GT(all, 3u) << "the layer is not there";
  const std::string whole = content_of(at("whole.png"));
  const std::vector<std::pair<std::string, Words>> cases = {
      {"submit=1", {"the device was lost"}},
      {"submit=" + std::to_string(all), {"the device was lost"}},
      {"wait=2", {"the device was lost"}},
      {"memory=1000", {"out of memory", "--size"}},
      {"memory=1000000", {"out of memory", "--size"}},
  };
  for (const auto& [faults, said] : cases) {
    const Ended fresh = run(small_capture + Words{at("a.png")}, faulty(faults));
    EXPECT_EQ(fresh.exit, 5) << faults << fresh.talk;
    expect_sentence(fresh, said);
    EXPECT_FALSE(fs::exists(at("a.png"))) << faults;
    EXPECT_EQ(folder_.count(), 1u) << faults << ": nothing half";
  }
  const Ended over = run(small_capture + Words{at("whole.png")}, faulty("submit=3"));
  EXPECT_EQ(over.exit, 5);
  EXPECT_EQ(content_of(at("whole.png")), whole) << "what was there stays";
}

TEST_F(DeviceFaults, InTheMiddleOfASweepLeaveShardsThatTheNextRunKeeps) {
  folder_.file("plan.json", plan);
  const Words sweep = {"sweep", "plan.json", "-q", "-o"};
  const size_t all = submissions(sweep + Words{"serial"});
  ASSERT_EQ(files_in("serial").size(), 2u);
  const Ended lost = run(sweep + Words{"shards"}, faulty("submit=" + std::to_string(all)));
  EXPECT_EQ(lost.exit, 5) << lost.talk;
  expect_sentence(lost, {"the device was lost"});
  const std::vector<fs::path> left = files_in("shards");
  ASSERT_EQ(left.size(), 1u);
  const auto written = fs::last_write_time(left.front());
  EXPECT_EQ(run(sweep + Words{"shards"}).exit, 0);
  EXPECT_EQ(fs::last_write_time(left.front()), written);
  for (const fs::path& shard : files_in("serial"))
    EXPECT_EQ(content_of(folder_.path / "shards" / shard.filename()), content_of(shard));
}

TEST_F(DeviceFaults, InAReportLeaveTheOldPage) {
  fs::create_directory(at("r"));
  folder_.file("r/index.html", "what was there before");
  const Ended lost = run({"report", "--modes", "blend", "--rig", "drive", "--size", "48x32", "-q", "-o", "r"},
                         faulty("submit=9"));
  EXPECT_EQ(lost.exit, 5) << lost.talk;
  expect_sentence(lost, {"the device was lost"});
  EXPECT_EQ(content_of(at("r/index.html")), "what was there before");
  EXPECT_EQ(files_in("r").size(), 1u);
}

} // namespace
} // namespace unghost
