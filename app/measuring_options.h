// What measurements, sweeps and reports can be told.
#pragma once

#include "app/commands.h"

namespace CLI {
class App;
}

namespace unghost {

/// Those of the row's options that are of that kind.
void add_measuring(CLI::App& app, const CommandRow& row, CommandLine& line);

} // namespace unghost
