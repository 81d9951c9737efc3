// What a row does not use is not in its pipeline.
#include <fstream>
#include <set>

#include "renderer/gpu/shader_contents.h"
#include "renderer/gpu/specialize.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/workgroup.h"
#include "tests/renderer/resolve_bench.h"
#include "tests/renderer/studio.h"

namespace unghost {
namespace {

constexpr uint32_t glsl_log = 28;

std::vector<uint32_t> words_of(const std::filesystem::path& file) {
  std::vector<uint32_t> words(std::filesystem::file_size(file) / 4);
  std::ifstream(file, std::ios::binary)
      .read(reinterpret_cast<char*>(words.data()), std::streamsize(words.size() * 4));
  return words;
}

class Pipelines : public ResolveBenchTest {
protected:
  /// What each of the runs is specialized to in a frame that has a history.
  std::vector<ShaderContents> specialize(const std::vector<ModeRun>& runs, bool first_frame = false) {
    bench.resolve(Inputs(), runs, true);
    if (!first_frame) bench.resolve(Inputs(), runs, false);
    std::vector<ShaderContents> results;
    for (const UsedPipeline& used : bench.ran()) {
      const std::vector<uint32_t> words = words_of(bench.shader_file(used.shader));
      results.push_back(contents_of(specialized(words, used.constants)));
      EXPECT_EQ(results.back().instructions, used.instructions) << "what the frame says of itself";
      EXPECT_EQ(uint32_t(results.back().fetches()), used.fetches);
    }
    return results;
  }
};

std::vector<ModeRun> rows_with_history() {
  std::vector<ModeRun> runs;
  for (const TaaMode& mode : taa_modes())
    if (mode.settings.policy.needs_history()) runs.push_back(run_of(mode.name));
  return runs;
}

/// A row, and one answer changed.
ModeRun changed(const char* mode, auto TaaPolicy::*column, auto answer) {
  ModeRun run = run_of(mode);
  run.taa.policy.*column = answer;
  return run;
}

std::set<uint32_t> keys_of(const std::map<uint32_t, int>& counts) {
  std::set<uint32_t> keys;
  for (const auto& [key, count] : counts) keys.insert(key);
  return keys;
}

std::set<uint32_t> reads_of(const TaaPolicy& policy) {
  std::set<uint32_t> reads{TAA_COLOUR, TAA_MOTION, TAA_PREVIOUS};
  const auto add = [&](bool needed, std::initializer_list<uint32_t> bindings) {
    if (needed) reads.insert(bindings);
  };
  const bool keyed = policy.needs_key(), edges = policy.dilation == Dilation::depth_edges && !keyed;
  add(keyed, {TAA_KEY});
  add((policy.dilation == Dilation::closest_depth && !keyed) || edges || policy.needs_tags() ||
          policy.rejects(Reject::depth | Reject::near_moving),
      {TAA_DEPTH});
  add(policy.needs_previous_objects() || edges, {TAA_OBJECT});
  add(policy.blend == Blend::counting, {TAA_PREVIOUS_COUNT});
  add(policy.needs_previous_motion(), {TAA_PREVIOUS_MOTION});
  add(policy.needs_previous_depth(), {TAA_PREVIOUS_DEPTH, TAA_EXPECTED_DEPTH});
  add(policy.needs_previous_objects(), {TAA_PREVIOUS_OBJECT});
  return reads;
}

std::set<uint32_t> writes_of(const TaaPolicy& policy) {
  std::set<uint32_t> writes{TAA_OUT};
  const auto add = [&](bool needed, uint32_t binding) {
    if (needed) writes.insert(binding);
  };
  add(policy.keeps == Keeps::input, TAA_INPUT_OUT);
  add(policy.blend == Blend::counting, TAA_COUNT_OUT);
  add(policy.needs_previous_motion(), TAA_MOTION_OUT);
  add(policy.needs_previous_depth(), TAA_DEPTH_OUT);
  add(policy.needs_previous_objects(), TAA_OBJECT_OUT);
  return writes;
}

TEST_F(Pipelines, HoldWhatTheirRowAsksForAndNothingElse) {
  std::vector<ModeRun> runs = rows_with_history();
  const auto add = [&](const char* name, const char* mode, auto column, auto answer) {
    runs.push_back(changed(mode, column, answer));
    runs.back().name = name;
  };
  add("object", "rgb", &TaaPolicy::reject, Reject::object);
  add("depth", "rgb", &TaaPolicy::reject, Reject::depth);
  add("counting", "rgb", &TaaPolicy::blend, Blend::counting);
  add("edges", "rgb", &TaaPolicy::dilation, Dilation::depth_edges);
  add("log", "rgb", &TaaPolicy::weighting, Weighting::log);
  add("undilated", "grand-tour", &TaaPolicy::dilation, Dilation::centre);
  add("accepting", "uncharted", &TaaPolicy::reject, Reject::off_screen);
  const std::vector<ShaderContents> pipelines = specialize(runs);
  ASSERT_EQ(pipelines.size(), runs.size());
  std::map<std::string, ShaderContents> of;
  for (size_t i = 0; i < runs.size(); ++i) {
    EXPECT_EQ(keys_of(pipelines[i].reads), reads_of(runs[i].taa.policy)) << runs[i].name;
    EXPECT_EQ(keys_of(pipelines[i].writes), writes_of(runs[i].taa.policy)) << runs[i].name;
    EXPECT_EQ(pipelines[i].functions.contains(glsl_log), runs[i].name == "log") << runs[i].name;
    of[runs[i].name] = pipelines[i];
  }
  const std::pair<const char*, const char*> less_and_more[] = {
      {"blend", "gdk-clamp"}, {"gdk-clamp", "rgb"},       {"rgb", "ycocg"},           {"rgb", "dop16-opt"},
      {"dop16-opt", "dop32"}, {"accepting", "uncharted"}, {"uncharted", "grand-tour"}};
  for (const auto& [less, more] : less_and_more)
    EXPECT_LT(of[less].instructions, of[more].instructions) << less << " " << more;
  // no neighbour's depth without dilation, no neighbour's colour without bounds
  EXPECT_LE(of["undilated"].reads.at(TAA_DEPTH), int(TAA_ROWS));
  EXPECT_GT(of["grand-tour"].reads.at(TAA_DEPTH), of["undilated"].reads.at(TAA_DEPTH));
  EXPECT_LE(of["blend"].reads.at(TAA_COLOUR), int(TAA_ROWS));
  EXPECT_GT(of["gdk-clamp"].reads.at(TAA_COLOUR), of["blend"].reads.at(TAA_COLOUR));
}

TEST_F(Pipelines, ReadNothingButTheFrameWhereThereIsNoHistory) {
  for (const ShaderContents& pipeline : specialize({run_of("blend"), run_of("dop32")}, true)) {
    EXPECT_EQ(keys_of(pipeline.reads), std::set<uint32_t>{TAA_COLOUR});
    EXPECT_EQ(keys_of(pipeline.writes), std::set<uint32_t>{TAA_OUT});
  }
}

} // namespace
} // namespace unghost
