// Supersampled frames that were drawn before, kept in the user's cache.
#pragma once

#include "app/measure/supersampling.h"
#include "app/shot.h"

namespace unghost {

/// `device`: its name and driver. Found again only by the same program, device, scene, rig, seed, settings,
/// size, instant and number of samples; and only where an aliased frame at that instant has the same bytes as
/// then. What cannot be read is drawn again, what cannot be written is not kept; at most a gigabyte stays.
ReferenceCache reference_files(const Film& film, const Shot& shot, const std::string& device);

} // namespace unghost
