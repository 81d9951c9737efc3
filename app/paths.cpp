#include "app/paths.h"

#include "app/failure.h"

namespace unghost {
namespace {

namespace fs = std::filesystem;

fs::path find_folder(const fs::path& program, const char* name) {
  const fs::path beside = program / name, shared = program / ".." / "share" / "unghost" / name;
  std::error_code ignored;
  if (fs::is_directory(beside, ignored)) return beside;
  if (fs::is_directory(shared, ignored)) return shared.lexically_normal();
  throw Failure(Exit::failed, "the program's " + std::string(name) + " are neither in " + beside.string() +
                                  " nor in " + shared.lexically_normal().string() + "; build it again");
}

} // namespace

DataFolders find_data_folders() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path();
  return {.assets = find_folder(program, "assets"), .shaders = find_folder(program, "shaders")};
}

fs::path scene_file(std::string_view word, const fs::path& assets) {
  if (word.empty()) throw Failure(Exit::wrong_words, "the scene's name is empty");
  const bool plain = word.find_first_of("./") == std::string_view::npos;
  const fs::path shipped = assets / (std::string(word) + ".glb");
  std::error_code ignored;
  return plain && fs::exists(shipped, ignored) ? shipped : fs::path(word);
}

} // namespace unghost
