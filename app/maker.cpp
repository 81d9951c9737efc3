#include "app/maker.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include <unistd.h>

#include "app/files.h"
#include "app/fingerprint.h"
#include "app/paths.h"
#include "app/version.h"
#include "renderer/gpu/device.h"

namespace unghost {
namespace {

constexpr size_t largest_file = size_t(2) << 30; // a sanitized program has 100 MB

std::string fingerprint_of_program() {
  std::vector<std::filesystem::path> files = {"/proc/self/exe"};
  for (const auto& entry : std::filesystem::directory_iterator(find_data_folders().shaders))
    if (entry.path().extension() == ".spv") files.push_back(entry.path());
  std::ranges::sort(files);
  Fingerprint fingerprint;
  for (const auto& file : files) {
    fingerprint.add(file.filename().string());
    fingerprint.add(read_file(file, largest_file));
  }
  return fingerprint.hex(16);
}

} // namespace

const std::string& build_of_program() {
  static const std::string build = fingerprint_of_program();
  return build;
}

std::string host_name() {
  char name[256] = {};
  return gethostname(name, sizeof name - 1) == 0 ? name : "unknown";
}

Maker this_maker(const std::string& device) {
  const std::vector<DeviceFacts> all = list_devices();
  const DeviceFacts& facts = all[chosen_device(all, device)];
  return {.version = UNGHOST_VERSION,
          .build = build_of_program(),
          .device = facts.name,
          .driver = facts.driver,
          .inputs = {}};
}

std::string inputs_of(const std::string& scene, const std::filesystem::path& settings) {
  Fingerprint fingerprint;
  fingerprint.add(read_file(scene_file(scene, find_data_folders().assets), largest_file));
  if (!settings.empty()) fingerprint.add(read_file(settings, largest_file));
  return fingerprint.hex(16);
}

} // namespace unghost
