// Sources of shaders that a person changes while the program runs: they are compiled as the build does it,
// and while the window goes on.
#pragma once

#include <memory>

#include "app/demo/background_process.h"
#include "app/demo/file_watch.h"

namespace unghost {

class ShaderBuild {
public:
  /// The tree that the shaders were built in.
  struct Tree {
    std::filesystem::path cmake, folder, sources;
  };
  /// Of the folder with the compiled ones; nothing where that does not lie in its tree, or the sources are
  /// gone.
  static std::optional<Tree> tree_of(const std::filesystem::path& shaders);

  explicit ShaderBuild(Tree tree);

  /// What came of one that has ended.
  struct Result {
    std::string fault; // in a sentence; empty where the sources compile
    std::string talk;  // of the compiler, in full
  };
  /// Begins one where sources have changed; waits for nothing. Says where one has failed, and where one has
  /// not after that: those who want what was compiled watch its folder.
  std::optional<Result> look(FileWatch::Time now);
  bool running() const { return process_ != nullptr; }
  /// Why the sources do not compile, since that is known; empty where they do.
  const std::string& fault() const { return fault_; }

private:
  void watch_sources();
  std::optional<Result> begin();
  std::optional<Result> end(BackgroundProcess::End with);

  Tree tree_;
  FileWatch watch_;
  bool wanted_ = false; // once what runs has ended
  std::unique_ptr<BackgroundProcess> process_;
  std::string fault_;
};

/// The first error in what a build has said, without the folder of the sources:
/// "tonemap.comp:31: 'light' : undeclared identifier".
std::string first_error(const std::string& talk, const std::filesystem::path& sources);

} // namespace unghost
