// Files that want to do harm, written by the test itself. Each is judged in a process of its own, by what it
// says, how long it took and how much memory it had.
#include <chrono>
#include <functional>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include "tests/scene/picture_files.h"

namespace unghost::test {
namespace {

#if defined(UNGHOST_MEMCHECK)
constexpr bool memory_tells = false; // valgrind's is not ours, and every instruction is its
constexpr double busiest_s = 19;
#elif defined(__SANITIZE_ADDRESS__)
constexpr bool memory_tells = false; // shadow memory and quarantine are not ours
constexpr double busiest_s = 4;      // the sanitizers make it two to four times as busy
#else
constexpr bool memory_tells = true;
constexpr double busiest_s = 1;
#endif

/// "loaded" and the warnings, or the sentence of the refusal.
std::string outcome_of(const Loaded& loaded) {
  if (const auto* refusal = std::get_if<Refusal>(&loaded)) return "refused: " + refusal->sentence();
  std::string said = "loaded";
  for (const std::string& warning : std::get<Scene>(loaded).warnings) said += " | " + warning;
  return said;
}

double seconds(const timeval& time) { return double(time.tv_sec) + double(time.tv_usec) * 1e-6; }

/// Loads in a forked child; fails where it crashes, is busy for more than a second or has more than 300 MB.
std::string judge(const std::filesystem::path& file) {
  int ends[2];
  if (pipe(ends) != 0) return "no pipe";
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child == 0) {
    alarm(20);
    const std::string said = outcome_of(load_scene(file));
    const ssize_t written = write(ends[1], said.data(), std::min<size_t>(said.size(), 4096));
    _exit(written < 0 ? 1 : 0);
  }
  close(ends[1]);
  std::string said(4096, '\0');
  const ssize_t got = read(ends[0], said.data(), said.size());
  said.resize(size_t(std::max<ssize_t>(got, 0)));
  close(ends[0]);
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << "it crashed or hung";
  const double busy = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  EXPECT_LT(busy, busiest_s);
  EXPECT_LT(took.count(), 20.0); // it waits for nothing; the rest is other work on this machine
  if (memory_tells) {
    EXPECT_LT(usage.ru_maxrss, 300 * 1024) << "kB";
  }
  return said;
}

void expect_refused(const std::filesystem::path& file, const std::string& word) {
  const std::string said = judge(file);
  EXPECT_TRUE(said.starts_with("refused: " + file.string() + ": ")) << said;
  EXPECT_NE(said.find(word), std::string::npos) << said;
}

void expect_checkerboard(const std::filesystem::path& file) {
  const std::string said = judge(file);
  EXPECT_TRUE(said.starts_with("loaded")) << said;
  EXPECT_NE(said.find("checkerboard"), std::string::npos) << said;
}

/// A triangle with a picture on it.
Document with_picture(const std::string& uri) {
  Document document;
  document.triangle()["material"] = 0;
  document.json["images"] = {{{"uri", uri}}};
  document.json["textures"] = {{{"source", 0}}};
  document.json["materials"] = {{{"emissiveTexture", {{"index", 0}}}}};
  return document;
}

/// A triangle whose vertices are said to be in the file `uri`.
Document with_buffer(const std::string& uri) {
  Document document;
  document.triangle();
  document.buffer.clear();
  document.json["buffers"] = {{{"uri", uri}, {"byteLength", 36}}};
  return document;
}

TEST(Hostile, a_buffer_outside_the_folder) {
  const TempFolder folder;
  for (const char* uri :
       {"../../../../../../../../etc/passwd", "%2e%2e/%2e%2e/%2e%2e/%2e%2e/etc/passwd", "a/../../passwd",
        "/etc/passwd", "%2Fetc%2Fpasswd", "..\\passwd", "x%00.bin", "%zz", ""}) {
    const auto file = folder.write("scene.gltf", with_buffer(uri).text());
    expect_refused(file, "/buffers/0/uri");
  }
  expect_refused(folder.write("scene.gltf", with_picture("../secret.png").text()),
                 "leaves the scene's folder");
}

TEST(Hostile, links_that_lead_out) {
  const TempFolder folder;
  std::filesystem::create_symlink("/etc/passwd", folder / "link.bin");
  std::filesystem::create_directory_symlink("/etc", folder / "linked");
  expect_refused(folder.write("scene.gltf", with_buffer("link.bin").text()), "leads out");
  expect_refused(folder.write("scene.gltf", with_buffer("linked/passwd").text()), "leads out");
  expect_refused(folder.write("scene.gltf", with_picture("link.bin").text()), "leads out");
}

TEST(Hostile, a_folder_named_as_a_picture) {
  const TempFolder folder;
  std::filesystem::create_directory(folder / "folder.png");
  expect_checkerboard(folder.write("scene.gltf", with_picture("folder.png").text()));
  expect_refused(folder.write("scene.gltf", with_buffer("folder.png").text()), "regular file");
}

TEST(Hostile, a_fifo) {
  const TempFolder folder;
  ASSERT_EQ(mkfifo((folder / "fifo").c_str(), 0600), 0);
  expect_checkerboard(folder.write("scene.gltf", with_picture("fifo").text()));
  expect_refused(folder.write("scene.gltf", with_buffer("fifo").text()), "regular file");
  expect_refused(folder / "fifo", "regular file");
}

TEST(Hostile, a_gif_that_says_it_is_a_png) {
  const TempFolder folder;
  folder.write("picture.png",
               std::string("GIF89a\1\0\1\0\x80\0\0\0\0\0\xff\xff\xff,\0\0\0\0\1\0\1\0\0\2\2D\1\0;", 35));
  expect_checkerboard(folder.write("scene.gltf", with_picture("picture.png").text()));
}

TEST(Hostile, a_png_bomb) {
  const TempFolder folder;
  folder.write("bomb.png", png_file({.width = 30000,
                                     .height = 30000,
                                     .colour_type = PNG_COLOR_TYPE_GRAY,
                                     .bits = 1,
                                     .rows = Bytes(size_t(3750) * 30000)}));
  expect_checkerboard(folder.write("scene.gltf", with_picture("bomb.png").text()));
}

TEST(Hostile, json_nested_200000_deep) {
  const TempFolder folder;
  const std::string deep(200000, '['), back(200000, ']');
  expect_refused(
      folder.write("scene.gltf", "{\"asset\":{\"version\":\"2.0\"},\"extras\":" + deep + back + "}"), "deep");
  expect_refused(folder.write("scene.gltf", "{\"a\":" + deep), "deep");
}

TEST(Hostile, a_mesh_that_is_not_there) {
  Document document;
  document.json["nodes"] = {{{"mesh", 7}}};
  const TempFolder folder;
  expect_refused(folder.write("scene.gltf", document.text()), "/nodes/0/mesh");
}

TEST(Hostile, a_node_that_is_its_own_child) {
  Document document;
  document.json["nodes"] = {{{"children", {0}}}};
  const TempFolder folder;
  expect_refused(folder.write("scene.gltf", document.text()), "own child");
}

TEST(Hostile, an_accessor_past_its_view) {
  const TempFolder folder;
  for (const auto& [field, value] : {std::pair<const char*, Json>{"count", 4},
                                     {"count", 9007199254740992},
                                     {"count", 18446744073709551615u},
                                     {"count", 1e300},
                                     {"count", -1},
                                     {"byteOffset", 4},
                                     {"byteOffset", 9007199254740991}}) {
    Document document;
    document.triangle();
    document.json["accessors"][0][field] = value;
    expect_refused(folder.write("scene.gltf", document.text()), "/accessors/0");
  }
  Document document;
  document.triangle();
  document.json["bufferViews"][0]["byteOffset"] = 9007199254740991;
  expect_refused(folder.write("scene.gltf", document.text()), "/bufferViews/0");
}

TEST(Hostile, an_https_uri) {
  const TempFolder folder;
  expect_refused(folder.write("scene.gltf", with_buffer("https://example.org/a.bin").text()), "scheme");
  expect_refused(folder.write("scene.gltf", with_picture("HTTPS://example.org/a.png").text()), "scheme");
  expect_refused(folder.write("scene.gltf", with_picture("file:///etc/passwd").text()), "scheme");
}

TEST(Hostile, indices_past_the_vertices_and_numbers_that_are_none) {
  const TempFolder folder;
  Document document;
  document.triangle()["indices"] = document.shorts({0, 1, 3});
  expect_refused(folder.write("scene.gltf", document.text()), "/meshes/0/primitives/0/indices");
  Document infinite;
  const int positions = infinite.floats({0, 0, 0, 1, INFINITY, 0, 0, 1, 0}, "VEC3");
  infinite.drawn({{"attributes", {{"POSITION", positions}}}});
  expect_refused(folder.write("scene.gltf", infinite.text()), "/accessors/0");
  expect_refused(folder.write("scene.gltf",
                              std::string(R"({"asset":{"version":"2.0"},"nodes":[{"scale":[1e999,1,1]}]})")),
                 "JSON");
  expect_refused(folder.write("scene.gltf",
                              std::string(R"({"asset":{"version":"2.0"},"nodes":[{"scale":[1e99,1,1]}]})")),
                 "/nodes/0/scale/0");
}

TEST(Hostile, a_small_file_that_asks_for_much) {
  const TempFolder folder;
  Document zeros; // a large accessor without a view, and many primitives that read it
  const int none = zeros.add("accessors", {{"componentType", 5126}, {"count", 20'000'000}, {"type", "VEC3"}});
  const int one = zeros.view(Bytes(16));
  zeros.json["accessors"][size_t(none)]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", one}, {"componentType", 5123}}},
      {"values", {{"bufferView", one}}}};
  for (int i = 0; i < 1000; ++i) zeros.drawn({{"attributes", {{"POSITION", none}}}});
  expect_refused(folder.write("scene.gltf", zeros.text()), "meshes together are larger");

  Document again; // the same accessors over and over, in turns
  const int first = again.floats(std::vector<float>(300'000), "VEC3");
  const int second = again.floats(std::vector<float>(300'000), "VEC3"), few = again.shorts({0, 1, 2});
  Json primitives = Json::array();
  for (int i = 0; i < 2'000; ++i) {
    primitives.push_back({{"attributes", {{"POSITION", i % 2 ? first : second}}}, {"indices", few}});
  }
  again.json["meshes"] = {{{"primitives", primitives}}};
  expect_refused(folder.write("scene.gltf", again.text()), "more numbers");

  Document doubled; // thirty levels of nothing: not possible, since a node has one parent
  for (int i = 0; i < 30; ++i) doubled.add("nodes", {{"children", {i + 1, i + 1}}});
  doubled.add("nodes", Json::object());
  expect_refused(folder.write("scene.gltf", doubled.text()), "two parents");
}

TEST(Hostile, too_many_elements) {
  const TempFolder folder;
  std::string text = R"({"asset":{"version":"2.0"},"nodes":[{})";
  for (int i = 0; i < 1'000'001; ++i) text += ",{}";
  expect_refused(folder.write("scene.gltf", text + "]}"), "elements");
}

TEST(Hostile, glb_headers_that_lie) {
  const TempFolder folder;
  Document document;
  document.triangle();
  const Bytes whole = document.glb();
  for (const size_t at : {4, 8, 12, 16}) { // version, length, length and type of the first chunk
    for (const uint8_t value : {0, 1, 3, 255}) {
      Bytes lying = whole;
      if (lying[at] == value) continue;
      lying[at] = value;
      expect_refused(folder.write("scene.glb", lying), "");
    }
  }
  for (const size_t size : {4, 11, 12, 19, 20, 21, int(whole.size()) - 1}) {
    expect_refused(folder.write("scene.glb", Bytes(whole.begin(), whole.begin() + ptrdiff_t(size))), "");
  }
}

TEST(Hostile, versions_and_things_that_are_not_gltf) {
  const TempFolder folder;
  expect_refused(folder.write("scene.gltf", std::string(R"({"asset":{"version":"1.0"}})")), "glTF 1.0");
  expect_refused(folder.write("scene.gltf", std::string(R"({"asset":{"version":"2.0","minVersion":"2.1"}})")),
                 "2.1");
  expect_refused(folder.write("scene.gltf", std::string("{}")), "version");
  expect_refused(folder.write("scene.gltf", std::string("")), "empty");
  expect_refused(folder.write("scene.gltf", std::string("solid cube")), "neither");
  expect_refused(folder.write("scene.gltf", std::string("{\"asset\":{\"version\":\"2.0\"},\"x\":\"\xff\"}")),
                 "JSON");
  expect_refused(folder / "nothing.gltf", "No such file");
}

} // namespace
} // namespace unghost::test
