#include "renderer/scene/gltf_accessors.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace unghost::gltf {

namespace {

// Read from accessors that were read before: 8 numbers of a million vertices.
constexpr uint64_t most_repeated_numbers = 8'000'000;

uint64_t size_of(Component component) {
  switch (component) {
  case Component::i8:
  case Component::u8:
    return 1;
  case Component::i16:
  case Component::u16:
    return 2;
  case Component::u32:
  case Component::f32:
    return 4;
  }
  return 4;
}

/// Bytes of an element, and from one to the next where they are packed. The columns of a matrix begin at
/// multiples of four; what is behind the last one need not be there.
struct Extent {
  uint64_t size, stride;
};

Extent extent_of(const Accessor& accessor) {
  const uint64_t component = size_of(accessor.component);
  if (!accessor.is_matrix)
    return {component * uint64_t(accessor.components), component * uint64_t(accessor.components)};
  const uint64_t side = accessor.components == 4 ? 2 : accessor.components == 9 ? 3 : 4;
  const uint64_t column = (side * component + 3) / 4 * 4;
  return {column * (side - 1) + side * component, column * side};
}

template <class T> T load(const uint8_t* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

/// Normalised integers become -1..1 or 0..1 by the equations of glTF 2.0, section 3.6.2.2.
template <class T> float as_float(const uint8_t* at, bool normalized) {
  const auto value = float(load<T>(at));
  return normalized ? std::max(value / float(std::numeric_limits<T>::max()), -1.0f) : value;
}

float float_at(const uint8_t* at, Component component, bool normalized) {
  switch (component) {
  case Component::i8:
    return as_float<int8_t>(at, normalized);
  case Component::u8:
    return as_float<uint8_t>(at, normalized);
  case Component::i16:
    return as_float<int16_t>(at, normalized);
  case Component::u16:
    return as_float<uint16_t>(at, normalized);
  case Component::u32:
    return as_float<uint32_t>(at, normalized);
  case Component::f32:
    return load<float>(at);
  }
  return 0;
}

uint32_t index_at(const uint8_t* at, Component component) {
  switch (component) {
  case Component::u8:
    return *at;
  case Component::u16:
    return load<uint16_t>(at);
  default:
    return load<uint32_t>(at);
  }
}

Component component_of(const Json& json, const std::string& pointer) {
  const int64_t number = json.at("componentType").get<int64_t>();
  for (const Component known :
       {Component::i8, Component::u8, Component::i16, Component::u16, Component::u32, Component::f32}) {
    if (number == int64_t(known)) return known;
  }
  refuse("there is no component type " + std::to_string(number), pointer + "/componentType");
}

Component index_component_of(const Json& json, const std::string& pointer) {
  const Component component = component_of(json, pointer);
  if (component == Component::u8 || component == Component::u16 || component == Component::u32)
    return component;
  refuse("indices are unsigned integers", pointer + "/componentType");
}

uint64_t offset_of(const Json& json) { return json.value("byteOffset", uint64_t(0)); }

void set_type(Accessor& accessor, const std::string& type, const std::string& pointer) {
  constexpr struct {
    const char* name;
    int components;
    bool is_matrix;
  } types[] = {{"SCALAR", 1, false}, {"VEC2", 2, false}, {"VEC3", 3, false}, {"VEC4", 4, false},
               {"MAT2", 4, true},    {"MAT3", 9, true},  {"MAT4", 16, true}};
  for (const auto& known : types) {
    if (type != known.name) continue;
    accessor.components = known.components, accessor.is_matrix = known.is_matrix;
    return;
  }
  refuse("there is no accessor type '" + printable(type) + "'", pointer + "/type");
}

} // namespace

Accessors::Accessors(const Json& document, const Container& container, Folder& folder,
                     const LoadLimits& limits)
    : numbers_left_(limits.geometry_bytes / sizeof(float)), repeats_left_(most_repeated_numbers) {
  load_buffers(document, container, folder, limits);
  check_views(document);
  const auto accessors = document.find("accessors");
  if (accessors == document.end()) return;
  accessors_.reserve(accessors->size());
  for (size_t i = 0; i < accessors->size(); ++i) check_accessor((*accessors)[i], i, limits);
}

void Accessors::check_views(const Json& document) {
  const auto views = document.find("bufferViews");
  if (views == document.end()) return;
  for (size_t i = 0; i < views->size(); ++i) {
    const Json& json = (*views)[i];
    const View view{json.at("buffer").get<size_t>(), offset_of(json), json.at("byteLength").get<uint64_t>(),
                    json.value("byteStride", uint64_t(0))};
    const uint64_t length = buffer_lengths_[view.buffer];
    if (view.offset > length || view.length > length - view.offset) {
      refuse("reaches past the end of its buffer of " + std::to_string(length) + " bytes",
             pointer_to("bufferViews", i));
    }
    views_.push_back(view);
  }
}

void Accessors::check_fits(const Span& span, uint64_t size, uint64_t packed,
                           const std::string& pointer) const {
  const auto [view, offset, count] = span;
  const View& in = views_[view];
  const uint64_t stride = in.stride ? in.stride : packed;
  if (stride < size) refuse("its elements are larger than the stride of its view", pointer);
  if (offset > in.length || size > in.length - offset || count - 1 > (in.length - offset - size) / stride) {
    refuse("reaches past the end of its view of " + std::to_string(in.length) + " bytes", pointer);
  }
}

void Accessors::check_accessor(const Json& json, size_t index, const LoadLimits& limits) {
  const std::string pointer = pointer_to("accessors", index);
  Accessor accessor;
  accessor.offset = offset_of(json);
  accessor.count = json.at("count").get<uint64_t>();
  accessor.component = component_of(json, pointer);
  accessor.normalized = json.value("normalized", false);
  set_type(accessor, json.at("type").get_ref<const std::string&>(), pointer);
  if (accessor.count > limits.geometry_bytes / (4 * uint64_t(accessor.components))) {
    refuse("has " + std::to_string(accessor.count) + " elements, more than is read", pointer + "/count");
  }
  if (json.contains("bufferView")) {
    accessor.view = json.at("bufferView").get<size_t>();
    const Extent extent = extent_of(accessor);
    check_fits({*accessor.view, accessor.offset, accessor.count}, extent.size, extent.stride, pointer);
  }
  if (json.contains("sparse")) {
    check_sparse(json.at("sparse"), accessor, accessor.sparse.emplace(), pointer + "/sparse");
  }
  accessors_.push_back(accessor);
}

void Accessors::check_sparse(const Json& json, const Accessor& accessor, SparsePart& sparse,
                             const std::string& pointer) const {
  const Json &indices = json.at("indices"), &values = json.at("values");
  sparse = {.count = json.at("count").get<uint64_t>(),
            .index_view = indices.at("bufferView").get<size_t>(),
            .value_view = values.at("bufferView").get<size_t>(),
            .index_offset = offset_of(indices),
            .value_offset = offset_of(values),
            .index_component = index_component_of(indices, pointer + "/indices")};
  if (sparse.count > accessor.count) refuse("has more elements than its accessor", pointer + "/count");
  const uint64_t index_size = size_of(sparse.index_component);
  check_fits({sparse.index_view, sparse.index_offset, sparse.count}, index_size, index_size,
             pointer + "/indices");
  const Extent extent = extent_of(accessor);
  check_fits({sparse.value_view, sparse.value_offset, sparse.count}, extent.size, extent.stride,
             pointer + "/values");
}

bool Accessors::has_data(size_t index) const {
  const Accessor& accessor = accessors_[index];
  const auto is_there = [&](size_t view) { return buffers_[views_[view].buffer].bytes.has_value(); };
  if (accessor.view && !is_there(*accessor.view)) return false;
  if (!accessor.sparse) return accessor.view.has_value();
  return is_there(accessor.sparse->index_view) && is_there(accessor.sparse->value_view);
}

std::span<const uint8_t> Accessors::bytes_of_view(size_t view, const std::string& pointer) const {
  const View& in = views_[view];
  const Buffer& buffer = buffers_[in.buffer];
  if (!buffer.bytes) refuse("its buffer has no data", pointer);
  return buffer.bytes->subspan(in.offset, in.length);
}

std::vector<uint32_t> Accessors::sparse_places(const Accessor& accessor, const std::string& pointer) const {
  const SparsePart& sparse = *accessor.sparse;
  const std::span<const uint8_t> bytes = bytes_of_view(sparse.index_view, pointer);
  const uint64_t size = size_of(sparse.index_component);
  const uint64_t stride = views_[sparse.index_view].stride ? views_[sparse.index_view].stride : size;
  std::vector<uint32_t> places;
  places.reserve(sparse.count);
  for (uint64_t i = 0; i < sparse.count; ++i) {
    const uint32_t place = index_at(&bytes[sparse.index_offset + i * stride], sparse.index_component);
    if (place >= accessor.count || (i > 0 && place <= places.back())) {
      refuse("its sparse indices do not ascend within the accessor", pointer + "/sparse/indices");
    }
    places.push_back(place);
  }
  return places;
}

void Accessors::charge(size_t index, const std::string& pointer) const {
  was_read_.resize(accessors_.size(), false);
  const uint64_t numbers = accessors_[index].count * uint64_t(accessors_[index].components);
  const uint64_t repeats = was_read_[index] ? numbers : 0;
  if (numbers > numbers_left_ || repeats > repeats_left_) {
    refuse("the document reads more numbers than are allowed", pointer);
  }
  numbers_left_ -= numbers, repeats_left_ -= repeats;
  was_read_[index] = true;
}

template <class Out, class Convert> std::vector<Out> Accessors::read(size_t index, Convert convert) const {
  const Accessor& accessor = accessors_[index];
  const std::string pointer = pointer_to("accessors", index);
  if (accessor.is_matrix) refuse("is a matrix where none is expected", pointer + "/type");
  charge(index, pointer);
  const uint64_t width = uint64_t(accessor.components), size = size_of(accessor.component);
  std::vector<Out> out(accessor.count * width, Out{0});
  // check_fits has seen that all of `count` elements are there.
  const auto copy = [&](size_t view, uint64_t offset, uint64_t count, const uint32_t* places) {
    const uint8_t* bytes = bytes_of_view(view, pointer).data() + offset;
    const uint64_t stride = views_[view].stride ? views_[view].stride : width * size;
    for (uint64_t i = 0; i < count; ++i) {
      Out* to = out.data() + (places ? places[i] : i) * width;
      for (uint64_t c = 0; c < width; ++c) to[c] = convert(bytes + i * stride + c * size, accessor);
    }
  };
  if (accessor.view) copy(*accessor.view, accessor.offset, accessor.count, nullptr);
  if (accessor.sparse) {
    const std::vector<uint32_t> places = sparse_places(accessor, pointer);
    copy(accessor.sparse->value_view, accessor.sparse->value_offset, places.size(), places.data());
  }
  return out;
}

std::vector<float> Accessors::read_floats(size_t index) const {
  std::vector<float> out = read<float>(index, [](const uint8_t* at, const Accessor& from) {
    return float_at(at, from.component, from.normalized);
  });
  for (const float value : out) {
    if (!std::isfinite(value)) refuse("holds a number that is not finite", pointer_to("accessors", index));
  }
  return out;
}

std::vector<uint32_t> Accessors::read_indices(size_t index) const {
  const Accessor& accessor = accessors_[index];
  const bool is_unsigned = accessor.component == Component::u8 || accessor.component == Component::u16 ||
                           accessor.component == Component::u32;
  if (!is_unsigned || accessor.components != 1) {
    refuse("indices are single unsigned integers", pointer_to("accessors", index));
  }
  return read<uint32_t>(index,
                        [](const uint8_t* at, const Accessor& from) { return index_at(at, from.component); });
}

} // namespace unghost::gltf
