#include "assets/generator/materials.h"

#include "assets/generator/textures.h"

namespace unghost::author {

using glm::dvec3;
using nlohmann::json;

namespace {

struct Surface {
  glm::dvec3 colour;
  double metalness, roughness;
};

json surface(const char* name, const Surface& s) {
  return {{"name", name},
          {"pbrMetallicRoughness",
           {{"baseColorFactor", {s.colour.x, s.colour.y, s.colour.z, 1.0}},
            {"metallicFactor", s.metalness},
            {"roughnessFactor", s.roughness}}}};
}

json coated(json material, double coat_roughness) {
  material["extensions"]["KHR_materials_clearcoat"] = {{"clearcoatFactor", 1.0},
                                                       {"clearcoatRoughnessFactor", coat_roughness}};
  return material;
}

json glowing(json material, double r, double g, double b) {
  material["emissiveFactor"] = {r, g, b};
  return material;
}

} // namespace

CarMaterials add_car_materials(Glb& glb) {
  CarMaterials m;
  m.paint = glb.add_material(coated(surface("paint", {{0.80, 0.045, 0.012}, 0.72, 0.36}), 0.03));
  m.glass = glb.add_material(surface("glass", {{0.010, 0.013, 0.015}, 0, 0.03}));
  m.chrome = glb.add_material(surface("chrome", {{0.82, 0.82, 0.84}, 1, 0.08}));
  m.gloss_black = glb.add_material(surface("gloss black", {{0.008, 0.008, 0.009}, 0, 0.12}));
  m.plastic = glb.add_material(surface("plastic", {{0.022, 0.022, 0.024}, 0, 0.62}));
  m.rubber = glb.add_material(surface("rubber", {{0.019, 0.019, 0.020}, 0, 0.90}));
  m.alloy = glb.add_material(surface("alloy", {{0.56, 0.57, 0.60}, 1, 0.26}));
  m.steel = glb.add_material(surface("brake disc", {{0.42, 0.41, 0.40}, 1, 0.38}));
  m.caliper = glb.add_material(coated(surface("caliper", {{0.85, 0.55, 0.02}, 0, 0.40}), 0.08));
  m.lamp = glb.add_material(glowing(surface("headlight", {{0.9, 0.9, 0.92}, 0, 0.10}), 0.85, 0.92, 1.0));
  m.tail_lamp =
      glb.add_material(glowing(surface("tail light", {{0.50, 0.006, 0.008}, 0, 0.08}), 0.90, 0.012, 0.016));
  m.indicator = glb.add_material(glowing(surface("indicator", {{0.75, 0.22, 0.01}, 0, 0.12}), 0.10, 0.03, 0));
  m.plate = glb.add_material(surface("number plate", {{0.80, 0.80, 0.76}, 0, 0.45}));
  return m;
}

WorldMaterials add_world_materials(Glb& glb) {
  const auto texture = [&](const char* name, const std::vector<uint8_t>& png) {
    return json{{"index", glb.add_texture(name, png)}};
  };
  const auto textured = [](json material, const json& colour) {
    material["pbrMetallicRoughness"]["baseColorTexture"] = colour;
    return material;
  };
  const auto bumpy = [](json material, json normal, double scale) {
    normal["scale"] = scale;
    material["normalTexture"] = std::move(normal);
    return material;
  };
  const json asphalt = texture("asphalt", asphalt_colour_png()),
             relief = texture("asphalt relief", asphalt_normal_png());
  const json paint = texture("road paint", road_paint_png()), grass = texture("grass", grass_png());
  const json leaves = texture("leaves", leaves_png());
  const dvec3 white(1);
  WorldMaterials m;
  m.asphalt = glb.add_material(bumpy(textured(surface("asphalt", {white, 0, 0.86}), asphalt), relief, 1));
  m.road_paint =
      glb.add_material(bumpy(textured(surface("road paint", {white, 0, 0.60}), paint), relief, 0.6));
  m.tar = glb.add_material(bumpy(surface("tar", {{0.016, 0.016, 0.017}, 0, 0.48}), relief, 0.4));
  m.gravel =
      glb.add_material(bumpy(textured(surface("gravel", {{1.0, 0.86, 0.66}, 0, 0.95}), asphalt), relief, 1));
  m.grass = glb.add_material(textured(surface("grass", {white, 0, 0.95}), grass));
  m.kerb_red = glb.add_material(surface("kerb red", {{0.62, 0.030, 0.022}, 0, 0.55}));
  m.kerb_white = glb.add_material(surface("kerb white", {{0.72, 0.71, 0.68}, 0, 0.55}));
  m.galvanised = glb.add_material(surface("galvanised steel", {{0.55, 0.57, 0.58}, 0.9, 0.42}));
  m.post = glb.add_material(surface("post", {{0.30, 0.31, 0.32}, 0.6, 0.55}));
  m.dark = glb.add_material(surface("dark board", {{0.018, 0.020, 0.024}, 0, 0.5}));
  m.reflector =
      glb.add_material(glowing(surface("reflector", {{0.70, 0.02, 0.015}, 0, 0.2}), 0.25, 0.008, 0.005));
  m.rubber = glb.add_material(surface("old rubber", {{0.024, 0.024, 0.025}, 0, 0.92}));
  json leafy = textured(surface("leaves", {white, 0, 0.75}), leaves);
  leafy["alphaMode"] = "MASK";
  leafy["alphaCutoff"] = 0.42;
  leafy["doubleSided"] = true;
  m.leaves = glb.add_material(std::move(leafy));
  m.bark = glb.add_material(surface("bark", {{0.085, 0.062, 0.045}, 0, 0.92}));
  return m;
}

} // namespace unghost::author
