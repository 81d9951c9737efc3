#include "assets/generator/author.h"

#include "assets/generator/car.h"
#include "assets/generator/track.h"

namespace unghost::author {

using glm::dvec3;

namespace {

// A camera on the inside of the road, ahead of the car, looking back at it.
void add_camera(Glb& glb) {
  const int camera = glb.add_camera({{"name", "front quarter"},
                                     {"type", "perspective"},
                                     {"perspective", {{"yfov", 0.60}, {"znear", 0.1}}}});
  const dvec3 eye(4.6, 1.45, 6.0), target(0, 0.55, 0.1);
  const dvec3 back = glm::normalize(eye - target), right = glm::normalize(glm::cross(dvec3(0, 1, 0), back));
  glb.add_node(
      "camera", -1,
      {.translation = eye, .rotation = glm::quat_cast(glm::dmat3(right, glm::cross(back, right), back))},
      {{"camera", camera}});
}

} // namespace

std::vector<uint8_t> author_asphalt() {
  Glb glb;
  add_car(glb);
  add_camera(glb);
  const WorldMaterials materials = add_world_materials(glb);
  add_road(glb, materials);
  add_terrain(glb, materials);
  add_barriers(glb, materials);
  add_roadside(glb, materials);
  add_trees(glb, materials);
  return glb.finish("asphalt", {{"track", {{"radius", Track::radius}}}});
}

} // namespace unghost::author
