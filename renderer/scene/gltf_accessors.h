// Buffers, views and accessors of a glTF document: every extent checked in 64 bits, every number read in one
// place.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "renderer/scene/gltf_container.h"
#include "renderer/scene/gltf_folder.h"
#include "renderer/scene/gltf_json.h"

namespace unghost::gltf {

/// glTF's componentType.
enum class Component { i8 = 5120, u8 = 5121, i16 = 5122, u16 = 5123, u32 = 5125, f32 = 5126 };

struct SparsePart {
  uint64_t count = 0;
  size_t index_view = 0, value_view = 0;
  uint64_t index_offset = 0, value_offset = 0;
  Component index_component = Component::u16;
};

struct Accessor {
  std::optional<size_t> view; // without one: zeros
  uint64_t offset = 0, count = 0;
  Component component = Component::f32;
  int components = 1; // 1 to 4, or 4, 9, 16 for a matrix
  bool is_matrix = false, normalized = false;
  std::optional<SparsePart> sparse;
};

/// What a buffer holds; nothing where the document leaves it to an extension or to whoever reads it.
struct Buffer {
  std::vector<uint8_t> owned;
  std::optional<std::span<const uint8_t>> bytes;
};

class Accessors {
public:
  /// Loads the buffers and checks the extents of all views and accessors. Throws Refused. `container` must
  /// outlive it.
  Accessors(const Json& document, const Container& container, Folder& folder, const LoadLimits& limits);

  const Accessor& operator[](size_t accessor) const { return accessors_[accessor]; }

  /// Whether anything but zeros can be read: false for an accessor without a view, or with a buffer without
  /// bytes.
  bool has_data(size_t accessor) const;
  /// All numbers of an accessor, `components` to an element, normalised where it says so, finite. Throws
  /// Refused.
  std::vector<float> read_floats(size_t accessor) const;
  /// An accessor of unsigned integers. Throws Refused.
  std::vector<uint32_t> read_indices(size_t accessor) const;
  /// The bytes of a view. Throws Refused where its buffer has none.
  std::span<const uint8_t> bytes_of_view(size_t view, const std::string& pointer) const;

private:
  struct View {
    size_t buffer = 0;
    uint64_t offset = 0, length = 0, stride = 0; // stride 0: tightly packed
  };
  struct Span {
    size_t view;
    uint64_t offset, count;
  };

  void load_buffers(const Json& document, const Container& container, Folder& folder,
                    const LoadLimits& limits);
  void check_views(const Json& document);
  void check_accessor(const Json& json, size_t index, const LoadLimits& limits);
  void check_sparse(const Json& json, const Accessor& accessor, SparsePart& sparse,
                    const std::string& pointer) const;
  void check_fits(const Span& span, uint64_t size, uint64_t packed, const std::string& pointer) const;
  template <class Out, class Convert> std::vector<Out> read(size_t accessor, Convert convert) const;
  std::vector<uint32_t> sparse_places(const Accessor& accessor, const std::string& pointer) const;
  void charge(size_t accessor, const std::string& pointer) const;

  std::vector<Buffer> buffers_;
  std::vector<uint64_t> buffer_lengths_; // as the document says
  std::vector<View> views_;
  std::vector<Accessor> accessors_;
  // A small file may ask for much by asking again and again.
  mutable uint64_t numbers_left_, repeats_left_;
  mutable std::vector<bool> was_read_;
};

} // namespace unghost::gltf
