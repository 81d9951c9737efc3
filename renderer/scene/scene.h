// A scene as plain data: what a glTF file says, checked, with no trace of glTF's encodings left and no Vulkan
// yet. Conventions: right-handed, y up, metres, colours linear unless a name says sRGB. Indices are -1 where
// absent.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace unghost {

/// An axis-aligned box; empty while `low > high`.
struct Bounds {
  glm::vec3 low{std::numeric_limits<float>::max()};
  glm::vec3 high{std::numeric_limits<float>::lowest()};

  bool empty() const { return low.x > high.x; }
  void add(glm::vec3 p) { low = glm::min(low, p), high = glm::max(high, p); }
};

/// One vertex as the vertex shader reads it. Normal and tangent have length 1; tangent.w is the bitangent's
/// sign.
struct Vertex {
  glm::vec3 position{0};
  glm::vec3 normal{0, 1, 0};
  glm::vec4 tangent{1, 0, 0, 1};
  glm::vec2 uv0{0};
  glm::vec2 uv1{0};
  glm::vec4 colour{1}; // linear, multiplies the base colour
};

/// An image as decoded: 8 bits a channel, RGBA, rows from the top.
struct Image {
  std::string name;
  uint32_t width = 0, height = 0;
  std::vector<uint8_t> rgba;
};

enum class Filter { nearest, linear };
enum class Wrap { repeat, mirrored_repeat, clamp_to_edge };

/// Where a material reads an image: `uv' = transform * (uv, 1)` of the chosen uv set (KHR_texture_transform).
struct TextureUse {
  int image = -1;
  int uv_set = 0;
  glm::mat3x2 transform{1, 0, 0, 1, 0, 0}; // columns: x axis, y axis, offset
  Filter magnify = Filter::linear, minify = Filter::linear;
  bool mipmapped = true;
  Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
};

enum class AlphaMode { opaque, mask, blend };

/// Metallic-roughness with KHR_materials_clearcoat, _unlit and _emissive_strength (already in `emissive`).
struct Material {
  std::string name;
  glm::vec4 base_colour{1};
  float metalness = 1, roughness = 1;
  glm::vec3 emissive{0};
  float clearcoat = 0, clearcoat_roughness = 0;
  float normal_scale = 1, occlusion_strength = 1;
  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;
  bool double_sided = false, unlit = false;
  TextureUse base_colour_texture;         // sRGB
  TextureUse metallic_roughness_texture;  // g roughness, b metalness
  TextureUse normal_texture;              // tangent space
  TextureUse occlusion_texture;           // r
  TextureUse emissive_texture;            // sRGB
  TextureUse clearcoat_texture;           // r
  TextureUse clearcoat_roughness_texture; // g
};

/// Every texture of a material, in the order of the TEXTURE_ numbers that shaders know them by.
inline constexpr TextureUse Material::*material_textures[] = {&Material::base_colour_texture,
                                                              &Material::metallic_roughness_texture,
                                                              &Material::normal_texture,
                                                              &Material::occlusion_texture,
                                                              &Material::emissive_texture,
                                                              &Material::clearcoat_texture,
                                                              &Material::clearcoat_roughness_texture};

/// A triangle list in Scene::indices, `first_index` on; its indices count from `first_vertex`.
struct Primitive {
  uint32_t first_index = 0, index_count = 0;
  uint32_t first_vertex = 0, vertex_count = 0;
  int material = 0;
  Bounds bounds;
};

struct Mesh {
  std::string name;
  std::vector<Primitive> primitives;
};

struct Trs {
  glm::vec3 translation{0};
  glm::quat rotation{1, 0, 0, 0};
  glm::vec3 scale{1};
};

/// What a node's `extras.wheel` says, or what is found from a name: it spins about local x, steers about
/// local y.
struct Wheel {
  float radius = 0; // metres, in the space of the node's parent
  bool steers = false;
};

struct Node {
  std::string name;
  int parent = -1; // always smaller than the node's own index
  Trs local;
  std::optional<glm::mat4> matrix; // instead of `local`, where the file gives a matrix; never animated
  int mesh = -1, camera = -1, light = -1;
  uint8_t tag = 0; // 0: the world; 1 to 255: tagged (`extras.tag`), inherited by children
  std::optional<Wheel> wheel;
};

struct Camera {
  std::string name;
  float vertical_fov = 0.8f; // radians
  float near_plane = 0.1f;   // metres; the far plane is infinite
};

enum class LightKind { directional, point, spot };

/// KHR_lights_punctual: shines along the node's -z. Candela for point and spot, lux for directional.
struct Light {
  std::string name;
  LightKind kind = LightKind::point;
  glm::vec3 intensity{1};                           // colour times intensity
  float range = 0;                                  // metres; 0: infinite
  float inner_cone = 0, outer_cone = 0.7853981634f; // radians
};

enum class Interpolation { step, linear, cubic_spline };
enum class Channel { translation, rotation, scale };

/// Key frames of one property of one node. Cubic splines hold three values a key: in-tangent, value,
/// out-tangent.
struct AnimationTrack {
  int node = -1;
  Channel channel = Channel::translation;
  Interpolation interpolation = Interpolation::linear;
  std::vector<float> times;      // seconds, ascending
  std::vector<glm::vec4> values; // xyz, or a quaternion as xyzw
};

struct Animation {
  std::string name;
  float duration = 0; // seconds, the last key of all tracks
  std::vector<AnimationTrack> tracks;
};

/// A road that closes on itself, from the scene's `extras.track`: a circle in the plane y = 0 through the
/// origin, which it leaves towards +z, curving to the left (+x).
struct Track {
  float radius = 0; // metres
};

struct Scene {
  std::string name;
  std::vector<Vertex> vertices;
  std::vector<uint32_t> indices;
  std::vector<Image> images;
  std::vector<Material> materials; // at least one: what a primitive without a material gets
  std::vector<Mesh> meshes;
  std::vector<Node> nodes; // parents before children
  std::vector<Camera> cameras;
  std::vector<Light> lights;
  std::vector<Animation> animations;
  int vehicle = -1; // the node that a rig moves: `extras.vehicle`
  std::optional<Track> track;
  std::vector<std::string> warnings;        // what the file asks for and is not drawn, each said once
  std::vector<std::filesystem::path> files; // that it was read from, or that were not there
};

} // namespace unghost
