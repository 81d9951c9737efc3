#include "renderer/scene/gltf_lights.h"

#include <algorithm>

namespace unghost::gltf {

namespace {

constexpr double smallest_fov = 0.01, largest_fov = 3.0;   // radians
constexpr double smallest_near = 1e-4, largest_near = 1e4; // metres
constexpr double half_turn = 3.141592653589793;

Camera camera_of(const tinygltf::Camera& from, Warnings& warnings) {
  Camera camera{.name = from.name};
  if (from.type == "perspective") {
    camera.vertical_fov = float(std::clamp(from.perspective.yfov, smallest_fov, largest_fov));
    camera.near_plane = float(std::clamp(from.perspective.znear, smallest_near, largest_near));
  } else {
    warnings.say("orthographic cameras are not supported; a perspective one stands in for them");
  }
  return camera;
}

Light light_of(const tinygltf::Light& from, Warnings& warnings) {
  Light light{.name = from.name};
  if (from.color.size() == 3) light.intensity = {from.color[0], from.color[1], from.color[2]};
  light.intensity = glm::clamp(light.intensity * float(from.intensity), 0.0f, 1e30f);
  light.range = float(std::max(from.range, 0.0));
  if (from.type == "directional") {
    light.kind = LightKind::directional;
  } else if (from.type == "spot") {
    light.kind = LightKind::spot;
    light.outer_cone = float(std::clamp(from.spot.outerConeAngle, 1e-3, half_turn / 2));
    light.inner_cone = std::min(float(std::max(from.spot.innerConeAngle, 0.0)), light.outer_cone);
  } else if (from.type != "point") {
    warnings.say("lights of type '" + printable(from.type) + "' are not supported and left out");
    light.intensity = glm::vec3(0);
  }
  return light;
}

} // namespace

std::vector<Camera> read_cameras(const tinygltf::Model& model, Warnings& warnings) {
  std::vector<Camera> cameras;
  for (const tinygltf::Camera& camera : model.cameras) cameras.push_back(camera_of(camera, warnings));
  return cameras;
}

std::vector<Light> read_lights(const tinygltf::Model& model, Warnings& warnings) {
  std::vector<Light> lights;
  for (const tinygltf::Light& light : model.lights) lights.push_back(light_of(light, warnings));
  return lights;
}

} // namespace unghost::gltf
