#include "app/commands.h"

namespace unghost {

std::span<const CommandRow> commands() {
  static constexpr CommandRow rows[] = {
      {"demo", "Open a window in which the car drives, and switch every resolve",
       drawing | one_mode | watched | replayed, demo},
      {"capture", "Render without a window and write a picture",
       drawing | one_mode | picture | frames_out | replayed, capture},
      {"compare", "Draw modes beside one another, from the same frames",
       drawing | many_modes | picture | crops | replayed, compare},
      {"measure", "Say in figures how much each mode ghosts, shimmers, errs and costs",
       drawing | many_modes | figures | figures_out, measure},
      {"report", "Measure everything there is and write one page of it",
       drawing | many_modes | timed | report_choice, report},
      {"stability", "Put every mode through stiff and extreme cases; exit 1 where a bound is broken",
       many_modes | endurance | figures_out | device, stability},
      {"bench", "Say in milliseconds and ratios what each mode adds to a frame",
       drawing | many_modes | timed | rounds_only, bench},
      {"explain", "Say what a frame is made of, what it was made without and why, and what that saved",
       drawing | one_mode | anatomy, explain},
      {"flip", "Say how different two pictures look (FLIP), and draw where", two_pictures | picture,
       flip_command},
      {"sweep", "Measure all that a plan asks for, or list it as commands", sweep_plan, sweep},
      {"job", "Measure what one line of a list of commands says", job_list, job},
      {"merge", "Join measurements into one file of results", shard_list, merge},
      {"axes", "Find axes of polytopes that fit tightly around colours", drawing | axis_search, axes},
      {"modes", "List the temporal resolves", 0, list_modes},
      {"rigs", "List the ways in which camera and vehicle move", 0, list_rigs},
      {"keys", "List what keys and gamepad do in the demo", 0, list_keys},
      {"views", "List what can be drawn in place of the picture", 0, list_views},
      {"settings", "List every setting with its range", 0, list_settings},
      {"info", "Say which version, devices and folders there are", device, info},
  };
  return rows;
}

} // namespace unghost
