#include <type_traits>
#include <vector>

#include "renderer/settings.h"

namespace unghost {
namespace {

template <auto... path> double read(const Settings& settings) { return double((settings.*....*path)); }

template <auto... path> void write(Settings& settings, double value) {
  auto& place = (settings.*....*path);
  place = static_cast<std::remove_reference_t<decltype(place)>>(value);
}

/// The row whose value lies at `path`, from Settings inwards: `setting<&Settings::taa, &TaaSettings::alpha>`.
template <auto... path> Setting setting(Setting row) {
  using Value = std::remove_cvref_t<decltype((std::declval<Settings&>().*....*path))>;
  row.read = &read<path...>;
  row.write = &write<path...>;
  row.per_mode = (std::is_same_v<decltype(path), TaaSettings Settings::*> || ...);
  if constexpr (std::is_enum_v<Value>) {
    row.kind = std::is_same_v<Value, Reject> ? SettingKind::flags : SettingKind::choice;
    row.answers = answers<Value>();
  }
  return row;
}

constexpr Condition keeps_history{[](const Settings& s) { return s.taa.policy.needs_history(); },
                                  "blend=current keeps no history"};
constexpr Condition jitters{[](const Settings& s) { return s.taa.policy.jitter != Jitter::none; },
                            "jitter=none does not move the samples"};
constexpr Condition tests_near_moving{[](const Settings& s) {
                                        return s.taa.policy.needs_history() &&
                                               has(s.taa.policy.reject, Reject::near_moving);
                                      },
                                      "nothing but reject=near-moving reads it"};

constexpr std::string_view px = "pixels", m = "metres", deg = "degrees", tour = "The Grand Tour Game";

template <auto member> constexpr auto policy = setting<&Settings::taa, &TaaSettings::policy, member>;
template <auto member> constexpr auto taa = setting<&Settings::taa, member>;
template <auto member> constexpr auto light = setting<&Settings::light, member>;
template <auto member> constexpr auto stage = setting<&Settings::stage, member>;

using Policy = TaaPolicy;
using Taa = TaaSettings;
using Light = LightSettings;

} // namespace

// name, unit, summary, source, low, high, when it has any effect
std::span<const Setting> settings_table() {
  // clang-format off
  static const std::vector<Setting> rows = {
    policy<&Policy::jitter>({"jitter", "", "Where in its pixel each frame takes its sample.", "Halton 1960"}),
    policy<&Policy::dilation>({"dilation", "", "Whose motion a pixel follows: its own or a neighbour's.", "Karis 2014", 0, 0, keeps_history}),
    policy<&Policy::history>({"history", "", "The filter that reads the history between its pixels.", "GDK sample", 0, 0, keeps_history}),
    policy<&Policy::rectify>({"rectify", "", "How the history is bounded by this frame's 3x3 neighbourhood.", "Lottes 2011", 0, 0, keeps_history}),
    policy<&Policy::reject>({"reject", "", "When the history is given up: 'nothing', or a list with commas.", tour, 0, 0, keeps_history}),
    policy<&Policy::blend>({"blend", "", "How the weight of the current frame is found."}),
    taa<&Taa::alpha>({"alpha", "", "The weight of the current frame.", "", 0, 1, keeps_history}),
    taa<&Taa::jitter_scale>({"jitter-scale", px, "The width of the square that the jitter fills.", "GDK sample", 0, 1, jitters}),
    taa<&Taa::motion_threshold_px>({"motion-threshold", "pixels a frame", "near-moving acts on what is faster.", tour, 0, 1000, tests_near_moving}),
    taa<&Taa::near_m>({"near", m, "near-moving gives up all history nearer than this.", tour, 0, 1e5f, tests_near_moving}),
    taa<&Taa::far_m>({"far", m, "near-moving keeps all history beyond this.", tour, 0, 1e5f, tests_near_moving}),
    light<&Light::sun_azimuth_deg>({"sun-azimuth", deg, "Where the sun stands, added to the rig's azimuth.", "", -360, 360}),
    light<&Light::sun_elevation_deg>({"sun-elevation", deg, "The sun's height over the horizon.", "", 3, 90}),
    light<&Light::sun_illuminance>({"sun", "", "Sunlight, as a share of a clear noon's.", "", 0, 100}),
    light<&Light::sky_luminance>({"sky", "", "Light of the sky, as a share of a clear sky's.", "", 0, 100}),
    light<&Light::exposure_ev>({"exposure", "EV", "Brightens the picture before the tone map; 1 doubles.", "", -16, 16}),
    stage<&StageSettings::stage>({"stage", "", "What surrounds a model that is no scene of its own."}),
    stage<&StageSettings::model_scale>({"model-scale", "", "Scales a foreign model; 0 finds it from the model's size.", "", 0, 1e5f}),
    stage<&StageSettings::model_yaw_deg>({"model-yaw", deg, "Turns a foreign model about the vertical axis.", "", -360, 360}),
    stage<&StageSettings::speed>({"speed", "", "Scales the motion of a rig.", "", 0, 10}),
    setting<&Settings::view>({"view", "", "What is drawn in place of the finished picture."}),
  };
  // clang-format on
  return rows;
}

} // namespace unghost
