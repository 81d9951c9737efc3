// The parts of the report, each as HTML: empty where there is nothing to show.
#pragma once

#include <string>

#include "app/measure/report/case_charts.h"
#include "app/measure/report/report_page.h"

namespace unghost {

/// "asphalt, 640x360", and what else but the rig tells it from the others.
std::string case_group(const Measured& m, const Results& among);
/// "asphalt, pass, 640x360".
std::string case_name(const Measured& m, const Results& among);
/// A mode's mark and name.
std::string mode_html(const std::string& mode, const Looks& looks);

/// What was measured on what, and what to beware of.
std::string lead_section(const Results& results);
/// What to take from all of it.
std::string worth_section(const Results& results, const Looks& looks);
/// Which modes are worth their time, a line a figure.
std::string fronts_table(const Measured& m, const Looks& looks);
/// What has changed since other results.
std::string baseline_section(const Baseline& baseline, const Looks& looks);
/// Every mode in every stiff and extreme case.
std::string stability_section(const StabilityTable& table, const Looks& looks);
std::string modes_table(const Measured& m, const Looks& looks);
std::string paper_section(const Results& results, const PageNotes& notes);
/// Each mode's worst frame beside the aliased one; `id` is the case's.
std::string worst_frames(const Measured& m, const Looks& looks, const FindPicture& pictures,
                         const std::string& id);
/// All modes at one instant, from which the script makes the slider.
std::string instant_pictures(const Measured& m, const FindPicture& pictures);
std::string origin_section(const Results& results);

} // namespace unghost
