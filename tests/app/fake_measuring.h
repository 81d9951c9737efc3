// Measurements out of nothing but their words, for tests of what is around measuring.
#pragma once

#include <chrono>
#include <thread>

#include "app/files.h"
#include "app/fingerprint.h"
#include "app/shards.h"

namespace unghost {

inline const Maker fake_maker{.version = "1", .build = "b", .device = "none", .driver = "none"};

/// Two modes, figures that follow from the words.
inline Measured fake_measured(const Words& words, const Maker& maker = fake_maker) {
  CommandLine line;
  {
    std::vector<const char*> pointers;
    for (const std::string& word : words) pointers.push_back(word.c_str());
    line = std::get<CommandLine>(parse_command_line(pointers));
  }
  Measured m{.version = maker.version,
             .build = maker.build,
             .device = maker.device,
             .driver = maker.driver,
             .validation = maker.validation,
             .inputs = maker.inputs,
             .scene = line.scene.value_or("asphalt"),
             .rig = line.rig.value_or("pass"),
             .width = line.size.value_or(PictureSize{}).width,
             .height = line.size.value_or(PictureSize{}).height,
             .seed = line.seed.value_or(1)};
  m.settings = nlohmann::json::object(), m.protocol = "custom";
  m.set = line.assignments, m.words = words;
  Fingerprint fingerprint;
  for (const std::string& word : words) fingerprint.add(word);
  for (const std::string& mode : line.modes) {
    fingerprint.add(mode);
    const double value = double(std::stoul(fingerprint.hex(4), nullptr, 16)) / 65536;
    m.modes.emplace_back(mode, nlohmann::json::object());
    MeasuredMode row{.mode = mode, .figures = {}, .samples = {}};
    for (const std::string& what : line.measure.what)
      row.figures[what] = value, row.samples[what] = {value, value};
    m.rows.push_back(std::move(row));
  }
  return m;
}

inline void write_json(const std::filesystem::path& file, const nlohmann::json& object) {
  const std::string text = object.dump(2) + "\n";
  write_file(file, bytes_of(text));
}

/// Takes a while, as measuring does, half of it with half a file written.
inline void fake_run(const Words& words, Console&) {
  const AskedWords asked = apart_from_output(words);
  const std::string text = measured_json(fake_measured(asked.words)).dump(2);
  const std::span<const uint8_t> bytes = bytes_of(text);
  NewFile file(asked.output);
  file.write(bytes.first(bytes.size() / 2));
  std::this_thread::sleep_for(std::chrono::milliseconds(10));
  file.write(bytes.subspan(bytes.size() / 2));
  file.commit();
}

inline Worker fake_worker() {
  return {.run = fake_run, .maker = [](const Words&) { return fake_maker; }};
}

} // namespace unghost
