#include "app/demo/shader_build.h"

#include <fstream>
#include <sstream>
#include <string_view>
#include <utility>

#include "app/demo/demo_scene.h"

namespace unghost {
namespace {

namespace fs = std::filesystem;

constexpr const char* built_by =
    "built_by.txt"; // written beside the compiled shaders by their CMakeLists.txt

/// glslang's errors begin so, and ninja's lines about what has failed.
constexpr std::string_view error_mark = "ERROR: ", failed_mark = "FAILED: ";

std::string_view without_end(std::string_view line) {
  const size_t last = line.find_last_not_of(" \r");
  return line.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

/// Of "FAILED: shaders/light.comp.spv /tmp/build/shaders/light.comp.spv": "light.comp".
std::string source_of(std::string_view output) {
  return fs::path(output.substr(0, output.find(' '))).stem().string();
}

} // namespace

std::string first_error(const std::string& talk, const fs::path& sources) {
  const std::string folder = sources.string() + "/";
  std::istringstream lines(talk);
  std::string failed, last;
  for (std::string whole; std::getline(lines, whole);) {
    std::string_view line = without_end(whole);
    if (line.empty()) continue;
    last = line;
    if (line.starts_with(failed_mark)) failed = source_of(line.substr(failed_mark.size()));
    if (!line.starts_with(error_mark)) continue;
    line.remove_prefix(error_mark.size());
    if (line.starts_with(folder)) return std::string(line.substr(folder.size()));
    return (failed.empty() ? "" : failed + ": ") + std::string(line);
  }
  return "the shaders cannot be built: " + (last.empty() ? "CMake does not say why" : last);
}

std::optional<ShaderBuild::Tree> ShaderBuild::tree_of(const fs::path& shaders) {
  std::ifstream lines(shaders / built_by);
  std::string cmake, folder, sources;
  std::getline(lines, cmake), std::getline(lines, folder), std::getline(lines, sources);
  std::error_code none;
  if (!fs::equivalent(fs::path(folder) / "shaders", shaders, none) || !fs::is_directory(sources, none))
    return {};
  return Tree{.cmake = cmake, .folder = folder, .sources = sources};
}

ShaderBuild::ShaderBuild(Tree tree) : tree_(std::move(tree)) { watch_sources(); }

/// With their folders, in which what is named and was not there may appear.
void ShaderBuild::watch_sources() {
  std::vector<fs::path> found = {tree_.sources};
  std::error_code ended; // a folder that goes while it is read is one that has changed
  for (fs::recursive_directory_iterator at(tree_.sources, ended), end; !ended && at != end;
       at.increment(ended))
    found.push_back(at->path());
  watch_.add(found);
}

std::optional<ShaderBuild::Result> ShaderBuild::look(FileWatch::Time now) {
  if (watch_.changed(now)) {
    watch_sources();
    wanted_ = true;
  }
  if (process_)
    if (auto with = process_->ended()) return end(std::move(*with));
  return wanted_ && !process_ ? begin() : std::nullopt;
}

std::optional<ShaderBuild::Result> ShaderBuild::begin() {
  wanted_ = false;
  const auto fault = fault_of([&] {
    process_ = std::make_unique<BackgroundProcess>(std::vector<std::string>{
        tree_.cmake.string(), "--build", tree_.folder.string(), "--target", "shaders"});
  });
  if (!fault) return {};
  fault_ = *fault;
  return Result{.fault = fault_, .talk = fault_ + "\n"};
}

std::optional<ShaderBuild::Result> ShaderBuild::end(BackgroundProcess::End with) {
  process_.reset();
  const std::string before = std::exchange(fault_, with.done ? "" : first_error(with.talk, tree_.sources));
  if (before.empty() && fault_.empty()) return {};
  return Result{.fault = fault_, .talk = std::move(with.talk)};
}

} // namespace unghost
