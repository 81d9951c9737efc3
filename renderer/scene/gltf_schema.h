// What we rely on in a glTF document, as tables: types, lengths, ranges, and what an index points into.
#pragma once

#include "renderer/scene/gltf_json.h"

namespace unghost::gltf {

/// Holds a document against the tables and throws Refused with the place that does not fit. Whole numbers
/// written as 3.0 become integers, which glTF allows and tinygltf does not read.
void check_schema(Json& document);

} // namespace unghost::gltf
