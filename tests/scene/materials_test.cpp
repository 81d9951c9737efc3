#include "tests/scene/gltf_document.h"

namespace unghost::test {
namespace {

/// A document with one material, which has two textures to name.
Document with_material(const Json& material) {
  Document document;
  document.json["materials"] = Json::array({material});
  document.json["images"] = {{{"name", "one"}, {"uri", "one.png"}}, {{"name", "two"}, {"uri", "two.png"}}};
  document.json["samplers"] = {{{"magFilter", 9728}, {"minFilter", 9984}, {"wrapS", 33071}, {"wrapT", 33648}},
                               {{"minFilter", 9729}}};
  document.json["textures"] = {{{"source", 0}, {"sampler", 0}}, {{"source", 1}, {"sampler", 1}}};
  return document;
}

Material material_of(const Json& material) { return scene_of(with_material(material)).materials.at(0); }

TEST(Materials, defaults_are_those_of_gltf) {
  const Material material = material_of(Json::object());
  EXPECT_EQ(material.base_colour, glm::vec4(1));
  EXPECT_EQ(material.metalness, 1);
  EXPECT_EQ(material.roughness, 1);
  EXPECT_EQ(material.emissive, glm::vec3(0));
  EXPECT_EQ(material.alpha_mode, AlphaMode::opaque);
  EXPECT_EQ(material.alpha_cutoff, 0.5f);
  EXPECT_FALSE(material.double_sided || material.unlit);
  EXPECT_EQ(material.base_colour_texture.image, -1);
}

TEST(Materials, every_core_property_is_read) {
  const Material material = material_of({{"name", "paint"},
                                         {"pbrMetallicRoughness",
                                          {{"baseColorFactor", {0.1, 0.2, 0.3, 0.4}},
                                           {"metallicFactor", 0.5},
                                           {"roughnessFactor", 0.6},
                                           {"baseColorTexture", {{"index", 0}}},
                                           {"metallicRoughnessTexture", {{"index", 1}, {"texCoord", 1}}}}},
                                         {"normalTexture", {{"index", 0}, {"scale", 0.7}}},
                                         {"occlusionTexture", {{"index", 1}, {"strength", 0.8}}},
                                         {"emissiveTexture", {{"index", 1}}},
                                         {"emissiveFactor", {0.25, 0.5, 1}},
                                         {"alphaMode", "MASK"},
                                         {"alphaCutoff", 0.9},
                                         {"doubleSided", true}});
  EXPECT_EQ(material.name, "paint");
  EXPECT_EQ(material.base_colour, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
  EXPECT_FLOAT_EQ(material.metalness, 0.5f);
  EXPECT_FLOAT_EQ(material.roughness, 0.6f);
  EXPECT_FLOAT_EQ(material.normal_scale, 0.7f);
  EXPECT_FLOAT_EQ(material.occlusion_strength, 0.8f);
  EXPECT_EQ(material.emissive, glm::vec3(0.25f, 0.5f, 1));
  EXPECT_EQ(material.alpha_mode, AlphaMode::mask);
  EXPECT_FLOAT_EQ(material.alpha_cutoff, 0.9f);
  EXPECT_TRUE(material.double_sided);
  EXPECT_EQ(material.base_colour_texture.image, 0);
  EXPECT_EQ(material.metallic_roughness_texture.image, 1);
  EXPECT_EQ(material.metallic_roughness_texture.uv_set, 1);
  EXPECT_EQ(material.normal_texture.image, 0);
  EXPECT_EQ(material.occlusion_texture.image, 1);
  EXPECT_EQ(material.emissive_texture.image, 1);
}

TEST(Materials, extensions_are_read) {
  const Json transform = {{"KHR_texture_transform", {{"offset", {0.5, 0}}, {"texCoord", 1}}}};
  const Material material =
      material_of({{"emissiveFactor", {1, 0.5, 0}},
                   {"extensions",
                    {{"KHR_materials_unlit", Json::object()},
                     {"KHR_materials_emissive_strength", {{"emissiveStrength", 10}}},
                     {"KHR_materials_clearcoat",
                      {{"clearcoatFactor", 0.75},
                       {"clearcoatRoughnessFactor", 0.25},
                       {"clearcoatTexture", {{"index", 1}, {"extensions", transform}}},
                       {"clearcoatRoughnessTexture", {{"index", 0}, {"texCoord", 1}}}}}}}});
  EXPECT_TRUE(material.unlit);
  EXPECT_EQ(material.emissive, glm::vec3(10, 5, 0));
  EXPECT_FLOAT_EQ(material.clearcoat, 0.75f);
  EXPECT_FLOAT_EQ(material.clearcoat_roughness, 0.25f);
  ASSERT_GE(material.clearcoat_texture.image, 0);
  EXPECT_EQ(material.clearcoat_texture.uv_set, 1);
  EXPECT_EQ(material.clearcoat_texture.transform[2], glm::vec2(0.5f, 0));
  ASSERT_GE(material.clearcoat_roughness_texture.image, 0);
  EXPECT_NE(material.clearcoat_texture.image, material.clearcoat_roughness_texture.image);
  EXPECT_EQ(material.clearcoat_roughness_texture.uv_set, 1);
}

TEST(Materials, samplers_are_read) {
  const Material material =
      material_of({{"emissiveTexture", {{"index", 0}}}, {"occlusionTexture", {{"index", 1}}}});
  const TextureUse &first = material.emissive_texture, &second = material.occlusion_texture;
  EXPECT_EQ(first.magnify, Filter::nearest);
  EXPECT_EQ(first.minify, Filter::nearest);
  EXPECT_TRUE(first.mipmapped);
  EXPECT_EQ(first.wrap_u, Wrap::clamp_to_edge);
  EXPECT_EQ(first.wrap_v, Wrap::mirrored_repeat);
  EXPECT_EQ(second.magnify, Filter::linear);
  EXPECT_FALSE(second.mipmapped);
  EXPECT_EQ(second.wrap_u, Wrap::repeat);
}

glm::vec2 moved(const Json& transform, glm::vec2 uv) {
  const Json use = {{"index", 0}, {"extensions", {{"KHR_texture_transform", transform}}}};
  return material_of({{"emissiveTexture", use}}).emissive_texture.transform * glm::vec3(uv, 1);
}

TEST(Materials, texture_transforms_scale_then_turn_then_move) {
  const auto expect = [](glm::vec2 a, glm::vec2 b) {
    EXPECT_NEAR(a.x, b.x, 1e-5);
    EXPECT_NEAR(a.y, b.y, 1e-5);
  };
  expect(moved({{"offset", {0.5, 0.25}}}, {1, 1}), {1.5f, 1.25f});
  expect(moved({{"scale", {2, 3}}}, {1, 1}), {2, 3});
  // A quarter turn takes u to -v and v to u: counter-clockwise where v points down.
  expect(moved({{"rotation", 1.5707963267948966}}, {1, 0}), {0, -1});
  expect(moved({{"rotation", 1.5707963267948966}}, {0, 1}), {1, 0});
  expect(moved({{"offset", {10, 20}}, {"rotation", 1.5707963267948966}, {"scale", {2, 3}}}, {1, 1}),
         {13, 18});
  // Khronos' TextureTransformTest: the tip of its arrow, at (.7778, .7778), belongs under the marker
  // "correct", which stands at (.421, 1.016) in the quad's coordinates, turned by 22.5 degrees.
  const glm::vec2 tip = moved({{"rotation", 0.39269908169872414}}, {0.420952f, 1.016267f});
  EXPECT_NEAR(tip.x, 0.7778, 1e-3);
  EXPECT_NEAR(tip.y, 0.7778, 1e-3);
}

TEST(Materials, unused_images_are_not_decoded_and_shared_ones_once) {
  const Scene scene =
      scene_of(with_material({{"emissiveTexture", {{"index", 1}}}, {"normalTexture", {{"index", 1}}}}));
  ASSERT_EQ(scene.images.size(), 1u);
  EXPECT_EQ(scene.images[0].name, "two");
  EXPECT_EQ(scene.warnings.size(), 1u); // two.png is missing; one.png was never looked for
}

TEST(Materials, what_is_not_known_is_said) {
  EXPECT_TRUE(warns_of(scene_of(with_material({{"alphaMode", "DITHER"}})), "DITHER"));
  EXPECT_TRUE(
      warns_of(scene_of(with_material({{"normalTexture", {{"index", 0}, {"texCoord", 2}}}})), "second set"));
}

TEST(Materials, extensions_that_are_required_are_refused_and_others_said) {
  Document document = with_material(Json::object());
  document.json["extensionsUsed"] = {"KHR_materials_sheen", "KHR_texture_transform"};
  const Scene scene = scene_of(document);
  EXPECT_EQ(scene.warnings.size(), 1u);
  EXPECT_TRUE(warns_of(scene, "KHR_materials_sheen"));
  document.json["extensionsRequired"] = {"KHR_texture_transform", "KHR_draco_mesh_compression"};
  const Refusal refusal = refusal_of(document);
  EXPECT_NE(refusal.why.find("KHR_draco_mesh_compression"), std::string::npos);
  EXPECT_EQ(refusal.pointer, "/extensionsRequired/1");
}

} // namespace
} // namespace unghost::test
