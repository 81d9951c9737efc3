// Results as a full run has them, made up: every mode, three rigs, figures that are plausible and the same
// each time.
#pragma once

#include <cmath>
#include <numeric>
#include <random>

#include "app/measure/quantile.h"
#include "app/measure/report/report_page.h"
#include "renderer/settings.h"
#include "renderer/taa_modes.h"

namespace unghost {

class ReportSample {
public:
  explicit ReportSample(std::vector<std::string> rigs = {"pass", "drive", "rotate"}) {
    results.protocol = "quick";
    for (const std::string& rig : rigs) results.scenes.push_back(measured(rig));
  }
  Results results;

  /// Drawn on the spot: stripes that differ by mode, so that FLIP finds something.
  static std::optional<Image> picture(const KeptFrame&, const std::string& file) {
    Image image{.name = {}, .width = 96, .height = 54, .rgba = {}};
    const auto shift = uint32_t(std::hash<std::string>()(file) % 7);
    for (uint32_t y = 0; y < image.height; ++y)
      for (uint32_t x = 0; x < image.width; ++x) {
        const auto value = uint8_t((x + y + shift) % 16 < 8 ? 60 + x : 200 - y);
        image.rgba.insert(image.rgba.end(), {value, uint8_t(value / 2 + shift), uint8_t(255 - value), 255});
      }
    return image;
  }

private:
  // a measured order of magnitude for each: adds ms, ghosting, shimmer, error, trail
  struct Typical {
    std::string_view mode;
    double ms, ghosting, shimmer, error, trail;
  };
  static constexpr Typical typical[] = {{"off", 0, 0, .0402, .0713, 0},
                                        {"blend", .061, .0981, .0042, .0894, .961},
                                        {"gdk-clamp", .072, .0483, .0121, .0532, .167},
                                        {"gdk-clip", .079, .0465, .0124, .0521, .135},
                                        {"gdk-variance", .083, .0421, .0152, .0493, .121},
                                        {"uncharted", .118, .0402, .0118, .0447, .092},
                                        {"grand-tour", .127, .0391, .0119, .0451, .092},
                                        {"crytek-2x", .131, .0212, .0283, .0588, .064},
                                        {"ac4", .136, .0194, .0291, .0603, .058},
                                        {"holy-trail", .149, .0431, .0115, .0462, .117},
                                        {"rgb", .116, .0413, .0111, .0441, .104},
                                        {"ycocg", .119, .0352, .0118, .0419, .076},
                                        {"rgb-var", .121, .0361, .0122, .0428, .073},
                                        {"ycocg-var", .124, .0312, .0138, .0409, .049},
                                        {"dop32", .171, .0334, .0127, .0401, .064},
                                        {"dop32-var", .186, .0287, .0146, .0396, .041},
                                        {"dop16-opt", .142, .0318, .0131, .0404, .049},
                                        {"unghost", .161, .0152, .0094, .0301, .012},
                                        {"unghost-safe", .172, .0148, .0104, .0305, .008},
                                        {"unghost-lite", .139, .0155, .0109, .0362, .014}};

  std::mt19937 random_{7};
  double near(double value, double share) {
    return value * (1 + share * (2 * double(random_() % 10001) / 10000 - 1));
  }

  MeasuredMode row_of(const TaaMode& mode) {
    MeasuredMode row{.mode = std::string(mode.name), .figures = {}, .samples = {}};
    for (const Typical& one : typical) {
      if (one.mode != mode.name) continue;
      const double trail = near(one.trail, .2), ms = near(one.ms, .06);
      row.figures = {{"ghosting", near(one.ghosting, .08)},
                     {"shimmer", near(one.shimmer, .05)},
                     {"error", near(one.error, .06)},
                     {"flicker", near(one.shimmer * .8 + .004, .1)},
                     {"trail", trail},
                     {"trail_surface", trail * .7},
                     {"trail_shadow", trail * 1.5},
                     {"added_ms", ms}};
      if (ms == 0) continue;
      for (int round = 0; round < 101; ++round)
        row.samples["added_ms"].push_back(ms * (1 + .015 * std::pow(double(random_() % 1000) / 400, 2)));
      row.figures["added_ms"] = quantile(row.samples["added_ms"], 0.5);
      row.figures["p05"] = quantile(row.samples["added_ms"], 0.05);
      row.figures["p95"] = quantile(row.samples["added_ms"], 0.95);
      row.figures["over_copy"] = ms / .05, row.figures["over_naive"] = .4 + near(.1, .5);
    }
    return row;
  }

  Convergence convergence(const std::vector<MeasuredMode>& rows) {
    Convergence found;
    for (uint32_t n = 1; n <= 256; n *= 2) found.frames.push_back(n);
    const auto curve = [&](const char* kind, const std::string& name, double floor, double power) {
      ConvergenceCurve line{.kind = kind, .name = name, .error = {}};
      for (const uint32_t n : found.frames)
        line.error.push_back(near(.07 * std::pow(n, -power) + floor, .02));
      found.curves.push_back(line);
    };
    for (const MeasuredMode& row : rows)
      if (row.mode != "off") curve("mode", row.mode, row.figures.at("shimmer") * .8, .7);
    for (const auto& [name, floor] : std::map<std::string, double>{
             {"halton-8", .011}, {"halton-16", .009}, {"r2-10", .01}, {"two-samples", .024}, {"none", .06}})
      curve("jitter", name, floor, .75);
    curve("supersampling", "", 0, .85);
    return found;
  }

  Measured measured(const std::string& rig) {
    Measured m;
    m.version = "0.1.0", m.build = "release, 0123abc", m.device = "An Imagined GPU 9000",
    m.driver = "imagined 1.2.3";
    m.scene = "asphalt", m.rig = rig, m.width = 640, m.height = 360;
    m.frames = 200, m.fill = 100, m.samples = 64, m.error_frames = {110, 130, 150, 170};
    m.settings = {{"render", {{"exposure", 1.0}, {"shadow-size", 2048}}}, {"sharpen", 0.0}};
    m.timing = Timing{.host = "workbench",
                      .rig = rig,
                      .rounds = 101,
                      .copy_ms = .051,
                      .motion_ms = .083,
                      .geometry_ms = .62};
    for (const TaaMode& mode : taa_modes()) {
      m.modes.emplace_back(mode.name, settings_json(settings_for_mode(mode.name), SettingsPart::per_mode));
      m.rows.push_back(row_of(mode));
    }
    for (const uint32_t samples : {1, 2, 4, 8, 16})
      m.supersampled.push_back({.samples = samples,
                                .figures = {{"error", .0713 * std::pow(samples, -.62)},
                                            {"shimmer", .0402 * std::pow(samples, -.6)},
                                            {"flicker", .036 * std::pow(samples, -.6)}}});
    m.convergence = convergence(m.rows);
    for (const MeasuredMode& row : m.rows) {
      if (row.mode != "off")
        m.kept.push_back(
            {"ghosting", row.mode, 143, row.figures.at("ghosting") * 1.3, row.mode + ".png", "off.png"});
      m.kept.push_back({"error", row.mode, 130, row.figures.at("error"), row.mode + ".png", "dop32-var.png"});
    }
    return m;
  }
};

} // namespace unghost
