#include "renderer/scene/gltf_folder.h"
#include "renderer/scene/gltf_report.h"
#include "tests/scene/gltf_document.h"

namespace unghost::test {
namespace {

TEST(Limits, names_cannot_speak_to_a_terminal) {
  Document document;
  document.json["extensionsRequired"] = {"EVIL\x1b[2J" + std::string(5000, 'x')};
  const Refusal refusal = refusal_of(document);
  EXPECT_EQ(refusal.why.find('\x1b'), std::string::npos);
  EXPECT_LT(refusal.why.size(), 200u);
}

TEST(Limits, folders_are_kept_to_without_openat2_too) {
  const TempFolder folder;
  std::filesystem::create_directory(folder / "inside");
  folder.write("inside/file", std::string("abc"));
  std::filesystem::create_symlink("/etc/passwd", folder / "link");
  std::filesystem::create_symlink("inside/file", folder / "good");
  for (const auto confine : {gltf::Folder::Confine::by_kernel, gltf::Folder::Confine::by_path}) {
    gltf::Folder files(folder / "", LoadLimits{}, confine);
    EXPECT_EQ(files.read("inside/file", "").size(), 3u);
    EXPECT_EQ(files.read("good", "").size(), 3u);
    EXPECT_THROW(files.read("link", ""), gltf::Refused);
    EXPECT_THROW(files.read("inside", ""), gltf::FileProblem);
    EXPECT_THROW(files.read("missing", ""), gltf::FileProblem);
  }
}

TEST(Limits, files_larger_than_allowed) {
  const TempFolder folder;
  Document document;
  document.triangle();
  const auto file = folder.write("scene.gltf", document.text());
  EXPECT_NE(refusal_of(load_scene(file, {.file_bytes = 100})).why.find("100 are allowed"), std::string::npos);
  const std::string geometry = refusal_of(load_scene(file, {.geometry_bytes = 200})).why;
  EXPECT_NE(geometry.find("larger than 200 bytes"), std::string::npos) << geometry;
}

} // namespace
} // namespace unghost::test
