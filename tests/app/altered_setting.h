// Settings other than they are, whichever they be.
#pragma once

#include "renderer/settings.h"

namespace unghost {

/// Another value that the setting can have.
inline void alter(const Setting& row, Settings& settings) {
  if (row.kind == SettingKind::number)
    row.write(settings, row.read(settings) == row.high ? row.low : (row.read(settings) + row.high) / 2);
  else
    row.write(settings, row.read(settings) == row.answers.back().value ? row.answers.front().value
                                                                       : row.answers.back().value);
}

} // namespace unghost
