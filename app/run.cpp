#include "app/run.h"

#include <array>
#include <cstdlib>
#include <new>
#include <string>

#include "app/commands.h"
#include "app/failure.h"
#include "app/interruption.h"
#include "app/version.h"
#include "renderer/gpu/device.h"
#include "renderer/settings.h"

namespace unghost {
namespace {

Exit exit_of(GpuFault fault) {
  switch (fault) {
  case GpuFault::no_device:
    return Exit::no_device;
  case GpuFault::lost:
  case GpuFault::out_of_memory:
    return Exit::device_lost_or_memory;
  case GpuFault::other:
    break;
  }
  return Exit::failed;
}

void say_version(std::ostream& out) {
  out << "unghost " UNGHOST_VERSION "\n";
  try {
    for (const DeviceFacts& device : list_devices())
      out << device.name << ", " << device.driver << ", Vulkan " << device.api_version << "\n";
  } catch (const GpuError& error) {
    out << error.what() << "\n";
  }
}

bool has_display() {
  const auto names = [](const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && *value != 0;
  };
  return names("DISPLAY") || names("WAYLAND_DISPLAY");
}

Exit run_words(std::span<const char* const> words, std::ostream& out, std::ostream& err, bool terminal) {
  const auto parsed = parse_command_line(words);
  if (const auto* help = std::get_if<HelpText>(&parsed)) {
    out << help->text;
    return Exit::done;
  }
  if (std::holds_alternative<VersionAsked>(parsed)) {
    say_version(out);
    return Exit::done;
  }
  const CommandLine& line = std::get<CommandLine>(parsed);
  if (!line.command) {
    if (has_display()) return run_words(std::array{default_command.data()}, out, err, terminal);
    err << help_text() << "There is no display for the window, which is what no words ask for.\n";
    return Exit::wrong_words;
  }
  Console console{.out = out, .err = err, .quiet = line.quiet, .verbose = line.verbose, .terminal = terminal};
  line.command->run(line, console);
  return Exit::done;
}

} // namespace

int run(std::span<const char* const> words, std::ostream& out, std::ostream& err, bool terminal) {
  const auto fail = [&err](Exit exit, const std::string& sentence) {
    err << "unghost: " << sentence << "\n";
    return int(exit);
  };
  try {
    const Exit exit = run_words(words, out, err, terminal);
    if (!out.flush()) throw Failure(Exit::failed, "cannot write to standard output");
    return int(exit);
  } catch (const Interrupted& interrupted) {
    err << "unghost: interrupted\n";
    return 128 + interrupted.signal;
  } catch (const Failure& failure) {
    return fail(failure.exit, failure.what());
  } catch (const GpuError& error) {
    return fail(exit_of(error.fault), error.what());
  } catch (const WrongWords& error) {
    return fail(Exit::wrong_words, error.what());
  } catch (const SettingError& error) {
    return fail(Exit::wrong_words, error.what());
  } catch (const std::bad_alloc&) {
    err << "unghost: out of memory; something smaller may do\n"; // without a string to make
    return int(Exit::device_lost_or_memory);
  } catch (const std::exception& error) {
    return fail(Exit::failed, error.what());
  }
}

} // namespace unghost
