// A shot of what the demo recorded.
#pragma once

#include "app/shot.h"

namespace unghost {

/// The recording that the words name, under the modes that they name, if any, and with what --set and --view
/// say in place of what was recorded. Throws WrongWords and SettingError for words that it leaves no room
/// for, and Failure(input_refused) for what is wrong with it.
Shot replayed_shot(const CommandLine& line);

} // namespace unghost
