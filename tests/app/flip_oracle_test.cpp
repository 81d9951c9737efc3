// The program's FLIP, the plain one of flip_oracle.h, and what the metric's authors' program says agree.
#include "tests/app/flip_oracle.h"

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <random>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/files.h"
#include "app/measure/flip.h"
#include "renderer/scene/gltf_pictures.h"

namespace unghost {
namespace {

constexpr double mean_tolerance = 1e-4, pixel_tolerance = 1e-3;

template <class Of> Image drawn(uint32_t width, uint32_t height, const Of& of) {
  Image picture{.name = {}, .width = width, .height = height, .rgba = {}};
  for (uint32_t y = 0; y < height; ++y)
    for (uint32_t x = 0; x < width; ++x) {
      const glm::u8vec3 c = of(x, y);
      picture.rgba.insert(picture.rgba.end(), {c.x, c.y, c.z, 255});
    }
  return picture;
}

Image noise(uint32_t width, uint32_t height, uint32_t seed) {
  std::mt19937 random(seed);
  return drawn(width, height, [&](uint32_t, uint32_t) {
    const uint32_t bits = random();
    return glm::u8vec3(bits, bits >> 8, bits >> 16);
  });
}

/// Slanted edges, thin lines, saturated colours and a ramp; `shift` moves all by pixels.
Image scene(uint32_t width, uint32_t height, uint32_t shift) {
  return drawn(width, height, [&](uint32_t across, uint32_t y) {
    const uint32_t x = across + shift;
    if ((2 * x + y) % 23 == 0) return glm::u8vec3(255);
    if (x > 2 * y) return glm::u8vec3(250, 5 * y, 20);
    return x % 17 < 8 ? glm::u8vec3(10, 40, 255) : glm::u8vec3(4 * x, 4 * x, 3 * y);
  });
}

template <class Errors>
void expect_agreement(const std::vector<double>& oracle, const Errors& errors, const std::string& what) {
  ASSERT_EQ(oracle.size(), errors.size()) << what;
  double most = 0, total = 0;
  for (size_t i = 0; i < oracle.size(); ++i) {
    most = std::max(most, std::abs(oracle[i] - double(errors[i])));
    total += oracle[i] - double(errors[i]);
  }
  EXPECT_LT(most, pixel_tolerance) << what;
  EXPECT_LT(std::abs(total / double(oracle.size())), mean_tolerance) << what;
}

void expect_agreement(const Image& a, const Image& b, double ppd) {
  const FlipOptions options{.pixels_per_degree = ppd};
  const SeenPicture reference = seen(a, options), test = seen(b, options);
  const std::string what =
      std::to_string(a.width) + "x" + std::to_string(a.height) + " at " + std::to_string(ppd);
  const std::vector<double> errors = oracle_flip(a, b, ppd);
  expect_agreement(errors, flip(reference, test, options).values, what);
  EXPECT_NEAR(flip_oracle::sum_of(errors) / double(errors.size()), mean_flip(reference, test, options),
              mean_tolerance)
      << what;
}

TEST(FlipOracle, AgreesWithTheProgram) {
  for (const double ppd : {1.0, 20.0, 67.02064, 120.0}) {
    expect_agreement(noise(40, 30, 1), noise(40, 30, 2), ppd);
    expect_agreement(scene(40, 30, 0), scene(40, 30, 1), ppd);
    expect_agreement(scene(17, 50, 0), noise(17, 50, 3), ppd);
    expect_agreement(scene(61, 9, 0), scene(61, 9, 5), ppd);
    expect_agreement(noise(1, 1, 4), noise(1, 1, 5), ppd);
  }
  expect_agreement(scene(40, 150, 0), scene(40, 150, 3), 67.02064);
}

TEST(FlipOracle, AgreesWithTheAuthors) {
  const char* name = std::getenv("UNGHOST_FLIP");
  if (name == nullptr) GTEST_SKIP() << "UNGHOST_FLIP does not name a folder of pairs with their errors";
  const std::filesystem::path folder = name;
  const auto read = [&](const nlohmann::json& file) {
    gltf::PictureBounds bounds{.side = 1024, .bytes_left = 1 << 26};
    return gltf::decode_png(read_file(folder / file.get<std::string>(), 1 << 26), bounds);
  };
  const auto cases = nlohmann::json::parse(std::ifstream(folder / "expected.json")).at("cases");
  size_t compared = 0;
  for (const nlohmann::json& one : cases) {
    const size_t pixels = one.at("width").get<size_t>() * one.at("height").get<size_t>();
    if (one.at("kind") != "LDR-FLIP" || pixels > 20'000) continue; // the oracle is slow
    const std::vector<uint8_t> bytes =
        read_file(folder / one.at("error_map_f32").get<std::string>(), 1 << 26);
    ASSERT_EQ(bytes.size(), pixels * sizeof(float));
    std::vector<float> expected(pixels);
    std::memcpy(expected.data(), bytes.data(), bytes.size());
    expect_agreement(
        oracle_flip(read(one.at("reference")), read(one.at("test")), one.at("ppd").get<double>()), expected,
        one.at("name").get<std::string>());
    ++compared;
  }
  EXPECT_GE(compared, 8u);
}

} // namespace
} // namespace unghost
