#include "renderer/scene/gltf_schema.h"

#include <cmath>

#include "renderer/scene/gltf_schema_tables.h"

namespace unghost::gltf {

namespace {

/// Where the walk stands; written out only when there is something to refuse.
struct Place {
  const Place* up = nullptr;
  std::string_view key;
  size_t item = SIZE_MAX; // an array's item, where it is not SIZE_MAX

  std::string pointer() const {
    if (!up) return {};
    return up->pointer() + "/" + (item == SIZE_MAX ? printable(key) : std::to_string(item));
  }
};

class Walk {
public:
  explicit Walk(Json& document) : document_(document) {}

  void object(Json& value, std::span<const Field> fields, const Place& place) const;

private:
  void field(Json& value, const Field& field, const Place& place) const;
  void single(Json& value, const Field& field, const Place& place) const;
  void whole(Json& value, const Field& field, const Place& place) const;
  void by_name(Json& value, const Field& field, const Place& place) const;
  size_t size_of(std::string_view collection) const;

  Json& document_;
};

size_t Walk::size_of(std::string_view collection) const {
  if (collection == "KHR_lights_punctual") {
    const Json::json_pointer at("/extensions/KHR_lights_punctual/lights");
    return document_.contains(at) && document_[at].is_array() ? document_[at].size() : 0;
  }
  const auto it = document_.find(collection);
  return it == document_.end() || !it->is_array() ? 0 : it->size();
}

void Walk::whole(Json& value, const Field& field, const Place& place) const {
  if (!value.is_number()) refuse("is not a whole number", place.pointer());
  const double number = value.get<double>();
  if (number != std::floor(number)) refuse("is not a whole number", place.pointer());
  const double high = field.kind == Kind::integer ? field.high : double(INT_MAX);
  const double low = field.kind == Kind::integer ? field.low : 0;
  if (number < low || number > high) refuse(value.dump() + " is out of range", place.pointer());
  value = int64_t(number);
  if (field.kind == Kind::integer) return;
  const size_t size = size_of(field.of);
  if (size_t(number) >= size) {
    refuse("there is no " + value.dump() + " among " + std::to_string(size) + " " + std::string(field.of),
           place.pointer());
  }
}

void Walk::by_name(Json& value, const Field& field, const Place& place) const {
  if (!value.is_object()) refuse("is not an object", place.pointer());
  const Field index{.name = {}, .kind = Kind::index, .of = field.of};
  for (auto& [name, item] : value.items()) whole(item, index, Place{&place, name});
}

void Walk::single(Json& value, const Field& field, const Place& place) const {
  switch (field.kind) {
  case Kind::any:
    break;
  case Kind::flag:
    if (!value.is_boolean()) refuse("is neither true nor false", place.pointer());
    break;
  case Kind::text:
    if (!value.is_string()) refuse("is not a string", place.pointer());
    break;
  case Kind::number:
    if (!value.is_number()) refuse("is not a number", place.pointer());
    if (std::abs(value.get<double>()) > FLT_MAX) refuse("is too large", place.pointer());
    break;
  case Kind::integer:
  case Kind::index:
    whole(value, field, place);
    break;
  case Kind::indices_by_name:
    by_name(value, field, place);
    break;
  case Kind::object:
    object(value, field.fields, place);
    break;
  }
}

void Walk::field(Json& value, const Field& field, const Place& place) const {
  if (field.most < 0) return single(value, field, place);
  if (!value.is_array()) refuse("is not an array", place.pointer());
  if (value.size() < size_t(field.least) || value.size() > size_t(field.most)) {
    refuse("has " + std::to_string(value.size()) + " items", place.pointer());
  }
  for (size_t i = 0; i < value.size(); ++i) single(value[i], field, Place{&place, {}, i});
}

void Walk::object(Json& value, std::span<const Field> fields, const Place& place) const {
  if (!value.is_object()) refuse("is not an object", place.pointer());
  for (const Field& row : fields) {
    const Place here{&place, row.name};
    const auto it = value.find(row.name);
    if (it != value.end()) {
      field(*it, row, here);
    } else if (row.required) {
      refuse("is missing", here.pointer());
    }
  }
}

} // namespace

void check_schema(Json& document) { Walk(document).object(document, schema::root, Place{}); }

} // namespace unghost::gltf
