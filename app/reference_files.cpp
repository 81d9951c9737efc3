#include "app/reference_files.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <memory>

#include <nlohmann/json.hpp>

#include "app/failure.h"
#include "app/files.h"
#include "app/fingerprint.h"
#include "app/maker.h"
#include "app/png_file.h"

namespace unghost {
namespace {

namespace fs = std::filesystem;

constexpr uintmax_t most_bytes = uintmax_t(1) << 30;

/// Nothing where there is no home.
fs::path cache_folder() {
  const char* cache = std::getenv("XDG_CACHE_HOME");
  const char* home = std::getenv("HOME");
  if (cache != nullptr && *cache == '/') return fs::path(cache) / "unghost" / "references";
  if (home != nullptr && *home == '/') return fs::path(home) / ".cache" / "unghost" / "references";
  return {};
}

std::string digest_of(const Image& picture) {
  Fingerprint fingerprint;
  fingerprint.add(picture.rgba);
  return fingerprint.hex(16);
}

/// The same for whatever draws the same picture, as text.
std::string key_of(const Film& film, const Shot& shot, const std::string& device, uint32_t frame,
                   uint32_t samples) {
  FrameInput input = at_rest(film, frame);
  input.modes = {{.name = "off", .taa = {}}};
  input.wanted = {{Output::display}};
  const Image aliased = film.draw(input).delivered.front().picture;
  nlohmann::json key = {{"build", build_of_program()},
                        {"device", device},
                        {"scene", shot.scene},
                        {"rig", shot.rig},
                        {"seed", shot.seed},
                        {"size", text_of(shot.size)},
                        {"settings", settings_json(shot.settings, SettingsPart::shared)},
                        {"frame", frame},
                        {"samples", samples},
                        {"aliased", digest_of(aliased)}};
  return key.dump(-1, ' ', true);
}

fs::path file_of(const fs::path& folder, const std::string& key) {
  Fingerprint fingerprint;
  fingerprint.add(key);
  return folder / (fingerprint.hex(16) + ".png");
}

std::optional<Image> find(const fs::path& folder, const std::string& key) {
  const fs::path file = file_of(folder, key);
  std::error_code missing;
  if (!fs::exists(file, missing)) return std::nullopt;
  try {
    const std::vector<uint8_t> bytes = read_file(file, most_bytes);
    if (text_in_png(bytes) != key) return std::nullopt;
    Image found = decode_png(bytes);
    fs::last_write_time(file, fs::file_time_type::clock::now(), missing); // was of use: stays longer
    return found;
  } catch (const std::exception&) { // broken: is drawn again
    return std::nullopt;
  }
}

void drop_oldest(const fs::path& folder) {
  struct File {
    fs::path path;
    uintmax_t bytes;
    fs::file_time_type used;
  };
  std::vector<File> files;
  uintmax_t bytes = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    files.push_back({entry.path(), entry.file_size(), entry.last_write_time()});
    bytes += files.back().bytes;
  }
  std::ranges::sort(files, {}, &File::used);
  for (size_t i = 0; i < files.size() && bytes > most_bytes; ++i) {
    fs::remove(files[i].path);
    bytes -= files[i].bytes;
  }
}

void keep(const fs::path& folder, const std::string& key, const Image& reference) {
  try {
    fs::create_directories(folder);
    write_file(file_of(folder, key), encode_png(reference, key));
    drop_oldest(folder);
  } catch (const std::exception&) { // no room for it: the figures are there all the same
  }
}

} // namespace

ReferenceCache reference_files(const Film& film, const Shot& shot, const std::string& device) {
  const fs::path folder = cache_folder();
  if (folder.empty()) return {};
  const auto keys = std::make_shared<std::map<std::pair<uint32_t, uint32_t>, std::string>>();
  const auto key = [&film, &shot, device, keys](uint32_t frame, uint32_t samples) {
    std::string& known = (*keys)[{frame, samples}]; // it takes drawing a frame
    if (known.empty()) known = key_of(film, shot, device, frame, samples);
    return known;
  };
  return {.find = [=](uint32_t frame, uint32_t samples) { return find(folder, key(frame, samples)); },
          .keep = [=](uint32_t frame, uint32_t samples,
                      const Image& reference) { keep(folder, key(frame, samples), reference); }};
}

} // namespace unghost
