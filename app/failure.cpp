#include "app/failure.h"

#include <ostream>

namespace unghost {

void report_validation(std::ostream& to, const std::vector<std::string>& messages) {
  for (const std::string& message : messages) to << message << "\n";
  if (!messages.empty())
    throw Failure(Exit::failed,
                  "the validation layer has " + std::to_string(messages.size()) + " complaints");
}

} // namespace unghost
