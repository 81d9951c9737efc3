// What measures: which build of the program on which device. Measurements of one maker are alike to the bit.
#pragma once

#include <filesystem>
#include <string>

namespace unghost {

struct Maker {
  std::string version, build, device, driver;
  std::string inputs; // of the words: as Measured has it
  bool validation = false;

  bool operator==(const Maker&) const = default;
};

/// This program on the device of that name or index, without inputs. Throws GpuError where there is none.
Maker this_maker(const std::string& device);
/// 16 digits of the bytes of the scene's file and of `settings`, which may be empty.
std::string inputs_of(const std::string& scene, const std::filesystem::path& settings);
/// Of this machine.
std::string host_name();
/// 16 digits that differ between builds: of the bytes of the program and of its shaders.
const std::string& build_of_program();

} // namespace unghost
