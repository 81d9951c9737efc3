// The rows that gltf_schema.cpp walks: glTF 2.0 and the extensions we draw, as far as we rely on them.
#pragma once

#include <cfloat>
#include <climits>
#include <cstdint>
#include <span>
#include <string_view>

namespace unghost::gltf {

enum class Kind { any, flag, integer, number, text, index, indices_by_name, object };

struct Field {
  std::string_view name;
  Kind kind = Kind::any;
  double low = -FLT_MAX, high = FLT_MAX; // of a number
  std::string_view of = {};              // of an index: the collection it points into
  std::span<const Field> fields = {};    // of an object
  int least = -1, most = -1;             // an array of so many; -1: a single value
  bool required = false;
};

namespace schema {

constexpr double bytes = 9007199254740992.0; // 2^53, the largest whole number that JSON is sure to carry

constexpr Field any(std::string_view name) { return {.name = name}; }
constexpr Field flag(std::string_view name) { return {.name = name, .kind = Kind::flag}; }
constexpr Field text(std::string_view name) { return {.name = name, .kind = Kind::text}; }
constexpr Field number(std::string_view name) { return {.name = name, .kind = Kind::number}; }
constexpr Field numbers(std::string_view name, int least, int most) {
  return {.name = name, .kind = Kind::number, .least = least, .most = most};
}
constexpr Field integer(std::string_view name, double low, double high) {
  return {.name = name, .kind = Kind::integer, .low = low, .high = high};
}
constexpr Field index(std::string_view name, std::string_view of) {
  return {.name = name, .kind = Kind::index, .of = of};
}
constexpr Field by_name(std::string_view name, std::string_view of) {
  return {.name = name, .kind = Kind::indices_by_name, .of = of};
}
constexpr Field object(std::string_view name, std::span<const Field> fields) {
  return {.name = name, .kind = Kind::object, .fields = fields};
}
constexpr Field many(Field field) {
  field.least = 0, field.most = INT_MAX;
  return field;
}
constexpr Field need(Field field) {
  field.required = true;
  return field;
}

constexpr Field transform[] = {numbers("offset", 2, 2), number("rotation"), numbers("scale", 2, 2),
                               integer("texCoord", 0, INT_MAX)};
constexpr Field texture_use_extensions[] = {object("KHR_texture_transform", transform)};
constexpr Field texture_use[] = {need(index("index", "textures")), integer("texCoord", 0, INT_MAX),
                                 number("scale"), number("strength"),
                                 object("extensions", texture_use_extensions)};

constexpr Field metallic_roughness[] = {
    numbers("baseColorFactor", 4, 4), object("baseColorTexture", texture_use), number("metallicFactor"),
    number("roughnessFactor"), object("metallicRoughnessTexture", texture_use)};
constexpr Field clearcoat[] = {
    number("clearcoatFactor"), object("clearcoatTexture", texture_use), number("clearcoatRoughnessFactor"),
    object("clearcoatRoughnessTexture", texture_use), object("clearcoatNormalTexture", texture_use)};
constexpr Field emissive_strength[] = {number("emissiveStrength")};
constexpr Field material_extensions[] = {object("KHR_materials_clearcoat", clearcoat),
                                         object("KHR_materials_emissive_strength", emissive_strength),
                                         object("KHR_materials_unlit", {})};
constexpr Field material[] = {text("name"),
                              object("pbrMetallicRoughness", metallic_roughness),
                              object("normalTexture", texture_use),
                              object("occlusionTexture", texture_use),
                              object("emissiveTexture", texture_use),
                              numbers("emissiveFactor", 3, 3),
                              text("alphaMode"),
                              number("alphaCutoff"),
                              flag("doubleSided"),
                              object("extensions", material_extensions)};

constexpr Field other_source[] = {index("source", "images")};
constexpr Field texture_extensions[] = {object("EXT_texture_webp", other_source),
                                        object("KHR_texture_basisu", other_source)};
constexpr Field texture[] = {text("name"), index("sampler", "samplers"), index("source", "images"),
                             object("extensions", texture_extensions)};
constexpr Field sampler[] = {text("name"), integer("magFilter", 0, INT_MAX), integer("minFilter", 0, INT_MAX),
                             integer("wrapS", 0, INT_MAX), integer("wrapT", 0, INT_MAX)};
constexpr Field image[] = {text("name"), text("uri"), text("mimeType"), index("bufferView", "bufferViews"),
                           object("extensions", {})};

constexpr Field sparse_indices[] = {need(index("bufferView", "bufferViews")), integer("byteOffset", 0, bytes),
                                    need(integer("componentType", 0, INT_MAX))};
constexpr Field sparse_values[] = {need(index("bufferView", "bufferViews")), integer("byteOffset", 0, bytes)};
constexpr Field sparse[] = {need(integer("count", 1, bytes)), need(object("indices", sparse_indices)),
                            need(object("values", sparse_values))};
constexpr Field accessor[] = {text("name"),
                              index("bufferView", "bufferViews"),
                              integer("byteOffset", 0, bytes),
                              need(integer("componentType", 0, INT_MAX)),
                              flag("normalized"),
                              need(integer("count", 1, bytes)),
                              need(text("type")),
                              many(number("max")),
                              many(number("min")),
                              object("sparse", sparse)};
constexpr Field buffer_view[] = {text("name"),
                                 need(index("buffer", "buffers")),
                                 integer("byteOffset", 0, bytes),
                                 need(integer("byteLength", 1, bytes)),
                                 integer("byteStride", 1, 252),
                                 integer("target", 0, INT_MAX)};
constexpr Field buffer[] = {text("name"), text("uri"), need(integer("byteLength", 1, bytes))};

constexpr Field primitive[] = {need(by_name("attributes", "accessors")), index("indices", "accessors"),
                               index("material", "materials"), integer("mode", 0, 6),
                               many(by_name("targets", "accessors"))};
constexpr Field mesh[] = {text("name"), need(many(object("primitives", primitive))), many(number("weights"))};
constexpr Field light_use[] = {need(index("light", "KHR_lights_punctual"))};
constexpr Field node_extensions[] = {object("KHR_lights_punctual", light_use)};
constexpr Field node[] = {text("name"),
                          many(index("children", "nodes")),
                          index("mesh", "meshes"),
                          index("camera", "cameras"),
                          index("skin", "skins"),
                          numbers("matrix", 16, 16),
                          numbers("translation", 3, 3),
                          numbers("rotation", 4, 4),
                          numbers("scale", 3, 3),
                          many(number("weights")),
                          object("extensions", node_extensions)};
constexpr Field skin[] = {text("name"), index("inverseBindMatrices", "accessors"), index("skeleton", "nodes"),
                          need(many(index("joints", "nodes")))};

constexpr Field channel_target[] = {index("node", "nodes"), need(text("path"))};
constexpr Field channel[] = {need(integer("sampler", 0, INT_MAX)), need(object("target", channel_target))};
constexpr Field keys[] = {need(index("input", "accessors")), need(index("output", "accessors")),
                          text("interpolation")};
constexpr Field animation[] = {text("name"), need(many(object("channels", channel))),
                               need(many(object("samplers", keys)))};

constexpr Field perspective[] = {need(number("yfov")), need(number("znear")), number("zfar"),
                                 number("aspectRatio")};
constexpr Field orthographic[] = {need(number("xmag")), need(number("ymag")), need(number("zfar")),
                                  need(number("znear"))};
constexpr Field camera[] = {text("name"), need(text("type")), object("perspective", perspective),
                            object("orthographic", orthographic)};
constexpr Field spot[] = {number("innerConeAngle"), number("outerConeAngle")};
constexpr Field light[] = {text("name"),        need(text("type")), numbers("color", 3, 3),
                           number("intensity"), number("range"),    object("spot", spot)};
constexpr Field lights[] = {need(many(object("lights", light)))};
constexpr Field variant[] = {need(text("name"))};
constexpr Field variants[] = {many(object("variants", variant))};
constexpr Field root_extensions[] = {object("KHR_lights_punctual", lights),
                                     object("KHR_materials_variants", variants)};

constexpr Field scene[] = {text("name"), many(index("nodes", "nodes"))};
constexpr Field asset[] = {need(text("version")), text("minVersion"), text("generator"), text("copyright")};
constexpr Field root[] = {need(object("asset", asset)),
                          index("scene", "scenes"),
                          many(object("scenes", scene)),
                          many(object("nodes", node)),
                          many(object("meshes", mesh)),
                          many(object("materials", material)),
                          many(object("textures", texture)),
                          many(object("samplers", sampler)),
                          many(object("images", image)),
                          many(object("accessors", accessor)),
                          many(object("bufferViews", buffer_view)),
                          many(object("buffers", buffer)),
                          many(object("animations", animation)),
                          many(object("skins", skin)),
                          many(object("cameras", camera)),
                          many(text("extensionsUsed")),
                          many(text("extensionsRequired")),
                          object("extensions", root_extensions)};

} // namespace schema
} // namespace unghost::gltf
