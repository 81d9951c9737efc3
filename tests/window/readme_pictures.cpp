// Makes the README's pictures of the window: `readme_pictures FOLDER`, where `unghost` lies beside it.
#include <cstdio>
#include <fstream>
#include <thread>

#include "app/files.h"
#include "app/png_file.h"
#include "tests/app/own_copy.h"
#include "tests/window/demo_run.h"

namespace unghost {
namespace {

namespace fs = std::filesystem;

constexpr Size size{960, 540};
constexpr std::chrono::seconds settles{6}; // histories, charts, and the times of the panel

void save(const DemoRun& run, const fs::path& file) {
  std::this_thread::sleep_for(settles);
  const Picture picture = run.window().picture();
  Image image{.name = {}, .width = uint32_t(size.width), .height = uint32_t(size.height), .rgba = {}};
  for (const auto& [red, green, blue] : picture.pixels)
    image.rgba.insert(image.rgba.end(), {red, green, blue, 255});
  write_file(file, encode_png(image, "{}"));
}

/// A key, and what the program does at it.
using Keys = std::vector<std::pair<std::string, std::string>>;

/// A window that is kept as `config` says, after these keys.
void take(const char* config, const Keys& keys, const fs::path& file) {
  const Desk desk(size);
  const fs::path folder = desk.home() / "config" / "unghost";
  fs::create_directories(folder);
  std::ofstream(folder / "config.json") << config;
  DemoRun run(desk, {(folder_of_this_program() / "unghost").string(), "demo", "--json", "--rig", "drive",
                     "--size", "960x540"});
  for (const auto& [key, action] : keys) run.press(key, action);
  save(run, file);
  run.leave();
}

void take_all(const fs::path& folder) {
  take(R"({"shown": "blend", "compared": ["unghost"]})", {}, folder / "window.png");
  take(R"({"shown": "blend", "compared": ["unghost"], "magnified": [0.5, 0.78], "panel": false})",
       {{"b", "comparison"}, {"v", "magnifier"}}, folder / "split.png");
}

} // namespace
} // namespace unghost

int main(int count, char** words) {
  if (count != 2) return std::fputs("readme_pictures FOLDER\n", stderr), 2;
  if (const std::string why = unghost::Desk::missing(); !why.empty())
    return std::fprintf(stderr, "%s\n", why.c_str()), 1;
  unghost::take_all(words[1]);
}
