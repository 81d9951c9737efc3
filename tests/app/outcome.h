// What a run of the whole program in this process came to.
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "app/run.h"

namespace unghost {

using Words = std::vector<std::string>;

struct Outcome {
  int exit;
  std::string out, err;
};

inline Outcome outcome(const Words& words) {
  std::vector<const char*> pointers;
  for (const std::string& word : words) pointers.push_back(word.c_str());
  std::ostringstream out, err;
  const int exit = run(pointers, out, err);
  return {exit, out.str(), err.str()};
}

} // namespace unghost
