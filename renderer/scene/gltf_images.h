// The pictures that materials use, each decoded once.
#pragma once

#include <vector>

#include "renderer/scene/gltf_accessors.h"
#include "renderer/scene/gltf_pictures.h"
#include "renderer/scene/scene.h"

namespace unghost::gltf {

class Images {
public:
  struct Sources {
    const Json& document;
    Folder& folder;
    const Accessors& accessors;
    Warnings& warnings;
  };

  /// Looks at every URI, also of images that nothing uses. Throws Refused where one points out of the folder.
  Images(const Sources& from, const LoadLimits& limits);

  /// Where `image` of the document, or -1 for a texture without one, stands in take(). What cannot be read or
  /// decoded is a checkerboard and a warning.
  int use(int image);

  std::vector<Image> take() { return std::move(decoded_); }

private:
  Image decode(int image);
  std::vector<uint8_t> bytes_of(const Json& json, int image);

  Sources from_;
  PictureBounds bounds_;
  std::vector<int> places_; // in decoded_, of each image of the document; -1: not used yet
  int without_source_ = -1;
  std::vector<Image> decoded_;
};

} // namespace unghost::gltf
