// Shaders with their specialization constants filled in before a driver sees them. Drivers do so themselves,
// but late: lavapipe takes a resolve with every answer in it through all of its passes first, and makes a
// pipeline in a third of the time of what is left when the answers are known.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace unghost {

/// The same module with specialization constants 0, 1, ... fixed to `constants` (32 bits each; not 0: true),
/// and without what can then not be reached or is not used. Throws std::runtime_error for what is no SPIR-V.
std::vector<uint32_t> specialized(std::span<const uint32_t> spirv, std::span<const uint32_t> constants);

} // namespace unghost
