// What the row `unghost` is made of, part by part: a report measures it without each (--ablation), and
// explains them.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace unghost {

constexpr std::string_view ablated_row = "unghost";

/// A part, and the settings by which the row does without it.
struct Part {
  std::string_view change;   // as in a name of a row with settings of its own: reject=off-screen+visibility
  std::string_view name;     // of the row without it: "without moved objects"
  std::string_view sentence; // what it is, and what it is for
};
std::span<const Part> parts();

/// "unghost:ringing=kept".
std::string name_without(const Part& part);
/// The part that the row of this name goes without; nothing for any other name.
const Part* find_part(std::string_view name);

/// What the row does, as HTML, and the parts that these names of rows go without; empty where it is none.
std::string parts_explained(std::span<const std::string> names);

} // namespace unghost
