#include "renderer/scene/gltf_extras.h"

#include <cfloat>
#include <cmath>

namespace unghost::gltf {

namespace {

using tinygltf::Value;

const Value* find(const Value& object, const char* key) {
  return object.IsObject() && object.Has(key) ? &object.Get(key) : nullptr;
}

/// A length in metres, larger than zero; 0 where `object` has none.
float radius_of(const Value& object) {
  const Value* radius = find(object, "radius");
  const double metres = radius && radius->IsNumber() ? radius->GetNumberAsDouble() : 0;
  return metres > 0 && metres <= FLT_MAX ? float(metres) : 0;
}

void read_tag(Node& node, const Value& tag, Warnings& warnings) {
  const double number = tag.IsNumber() ? tag.GetNumberAsDouble() : 0;
  if (number >= 1 && number <= 255 && number == std::floor(number)) {
    node.tag = uint8_t(number);
  } else {
    warnings.say("extras.tag is a whole number from 1 to 255; another one is ignored");
  }
}

void read_wheel(Node& node, const Value& wheel, Warnings& warnings) {
  const float radius = radius_of(wheel);
  const Value* steers = find(wheel, "steers");
  if (radius == 0 || (steers && !steers->IsBool())) {
    warnings.say("extras.wheel is {\"radius\": metres, \"steers\": true or false}; another one is ignored");
    return;
  }
  node.wheel = Wheel{radius, steers && steers->Get<bool>()};
}

} // namespace

bool read_extras(Node& node, const Value& extras, Warnings& warnings) {
  if (const Value* tag = find(extras, "tag")) read_tag(node, *tag, warnings);
  if (const Value* wheel = find(extras, "wheel")) read_wheel(node, *wheel, warnings);
  const Value* vehicle = find(extras, "vehicle");
  if (!vehicle) return false;
  if (!vehicle->IsBool()) warnings.say("extras.vehicle is true or false; another one is ignored");
  return vehicle->IsBool() && vehicle->Get<bool>();
}

std::optional<Track> track_of(const Value& extras, Warnings& warnings) {
  const Value* track = find(extras, "track");
  if (!track) return std::nullopt;
  const float radius = radius_of(*track);
  if (radius > 0) return Track{radius};
  warnings.say("extras.track is {\"radius\": metres}; another one is ignored");
  return std::nullopt;
}

} // namespace unghost::gltf
