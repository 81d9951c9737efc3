// What a report measures.
#pragma once

#include "app/command_line.h"
#include "app/sweep_plan.h"

namespace unghost {

/// One a rig and size, and one a size for run times. Throws WrongWords and SettingError where the words are
/// wrong.
std::vector<Job> report_jobs(const CommandLine& line);

} // namespace unghost
