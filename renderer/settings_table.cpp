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

std::span<const Answer> no_or_yes() {
  static const Answer words[] = {{"0", 0}, {"1", 1}};
  return words;
}

/// The row whose value lies at `path`, from Settings inwards: `setting<&Settings::taa, &TaaSettings::alpha>`.
template <auto... path> Setting setting(Setting row) {
  using Value = std::remove_cvref_t<decltype((std::declval<Settings&>().*....*path))>;
  row.read = &read<path...>;
  row.write = &write<path...>;
  row.per_mode = (std::is_same_v<decltype(path), TaaSettings Settings::*> || ...);
  if constexpr (std::is_same_v<Value, bool>) {
    row.kind = SettingKind::choice;
    row.answers = no_or_yes();
  }
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
constexpr Condition rectifies{
    [](const Settings& s) { return s.taa.policy.needs_history() && s.taa.policy.rectify != Rectify::none; },
    "rectify=none bounds nothing"};
constexpr Condition overshoots{[](const Settings& s) {
                                 return s.taa.policy.needs_history() &&
                                        s.taa.policy.history >= HistoryFilter::catmull_rom;
                               },
                               "only the Catmull-Rom filters are cubics, and overshoot"};
constexpr Condition has_axes{
    [](const Settings& s) { return s.taa.policy.needs_history() && s.taa.policy.uses_dop(); },
    "only rectify=dop-clip and dop-variance have axes"};
constexpr Condition has_variance{
    [](const Settings& s) { return s.taa.policy.needs_history() && s.taa.policy.uses_variance(); },
    "no variance is taken"};

template <Reject test> constexpr bool tests(const Settings& s) { return s.taa.policy.rejects(test); }
constexpr Condition near_moving{tests<Reject::near_moving>, "nothing but reject=near-moving reads it"};
constexpr Condition asks_what_moves{tests<Reject::near_moving | Reject::moved_object>,
                                    "nothing but reject=near-moving and moved-object reads it"};
constexpr Condition by_speed{[](const Settings& s) { return s.taa.policy.blend == Blend::speed; },
                             "only blend=speed reads it"};
constexpr Condition centres_input{
    [](const Settings& s) { return s.taa.policy.needs_history() && s.taa.policy.input == Input::centred; },
    "only input=centred reads it"};
constexpr Condition knows_fast{
    [](const Settings& s) { return by_speed.met_by(s) || centres_input.met_by(s); },
    "only blend=speed and input=centred read it"};
constexpr Condition velocity{tests<Reject::velocity>, "nothing but reject=velocity reads it"};
constexpr Condition motion_length{tests<Reject::motion_length>, "nothing but reject=motion-length reads it"};
constexpr Condition speed{tests<Reject::speed>, "nothing but reject=speed reads it"};
constexpr Condition depth{tests<Reject::depth>, "nothing but reject=depth reads it"};

constexpr std::string_view px = "pixels", px_a_frame = "pixels a frame", m = "metres", deg = "degrees",
                           tour = "The Grand Tour Game", gdk = "GDK sample",
                           trail = "The quest for the Holy Trail";

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
    policy<&Policy::jitter>({"jitter", "", "Where in its pixel each frame takes its sample.", "Halton 1960; Roberts 2018; GDK sample"}),
    policy<&Policy::dilation>({"dilation", "", "Whose motion a pixel follows: its own or a neighbour's.", "Karis 2014", 0, 0, keeps_history}),
    policy<&Policy::history>({"history", "", "The filter that reads the history between its pixels.", gdk, 0, 0, keeps_history}),
    policy<&Policy::ringing>({"ringing", "", "Whether a sharp filter may overshoot the four nearest pixels.", "", 0, 0, overshoots}),
    policy<&Policy::space>({"space", "", "The colour space in which the history is bounded.", "Karis 2014", 0, 0, rectifies}),
    policy<&Policy::weighting>({"weighting", "", "What keeps bright pixels from flickering.", trail, 0, 0, keeps_history}),
    policy<&Policy::rectify>({"rectify", "", "How the history is bounded by this frame's 3x3 neighbourhood.", "Lottes 2011; Karis 2014; Salvi 2016; Ikkala et al. 2024", 0, 0, keeps_history}),
    policy<&Policy::where>({"where", "", "Which pixels are bounded: all, or those of which no cause is known: a coat of 0.1 or more or a roughness of 0.3 or less while anything moves or light changes, edges of what moves or of anything where the picture does, light that changed.", "", 0, 0, rectifies}),
    policy<&Policy::axes>({"axes", "", "The axes of the polytope.", "Ikkala et al. 2024", 0, 0, has_axes}),
    policy<&Policy::reject>({"reject", "", "When the history is given up: 'nothing', or a list with commas.", tour, 0, 0, keeps_history}),
    policy<&Policy::fill>({"fill", "", "What stands where the history was given up: the new frame, blurred or plain.", tour, 0, 0, keeps_history}),
    policy<&Policy::blend>({"blend", "", "How the weight of the current frame is found."}),
    policy<&Policy::input>({"input", "", "The new frame as it was sampled, or interpolated at each pixel's middle: wholly where the picture is fast.", "Karis 2014", 0, 0, keeps_history}),
    policy<&Policy::keeps>({"keeps", "", "What the next frame finds: the result, or the frame as it came in.", "Sousa 2011", 0, 0, keeps_history}),
    taa<&Taa::alpha>({"alpha", "", "The weight of the current frame.", "", 0, 1, keeps_history}),
    taa<&Taa::gamma>({"gamma", "", "How many standard deviations the variance's volume reaches.", "Salvi 2016", 0, 10, has_variance}),
    taa<&Taa::cubic>({"cubic", "", "How sharp the cubic is that reads the history; 0.5 is Catmull-Rom.", "Keys 1981", 0, 1, overshoots}),
    taa<&Taa::jitter_scale>({"jitter-scale", px, "The width of the square that the jitter fills.", gdk, 0, 1, jitters}),
    taa<&Taa::jitter_moving>({"jitter-moving", "", "The share of jitter-scale that is left while the camera moves, which itself brings surfaces to other places of their pixels.", "", 0, 1, jitters}),
    taa<&Taa::motion_threshold_px>({"motion-threshold", px_a_frame, "near-moving and moved-object act on what is faster.", tour, 0, 1000, asks_what_moves}),
    taa<&Taa::near_m>({"near", m, "near-moving gives up all history nearer than this; 0: the far end of what is tagged.", tour, 0, 1e5f, near_moving}),
    taa<&Taa::far_m>({"far", m, "near-moving keeps all history beyond this; 0: a vehicle's length beyond near.", tour, 0, 1e5f, near_moving}),
    taa<&Taa::velocity_min>({"velocity-min", "shares of the picture", "velocity overlooks a smaller difference.", trail, 0, 1, velocity}),
    taa<&Taa::velocity_slope>({"velocity-slope", "", "How fast velocity fades to the blurred picture beyond that.", trail, 0, 1000, velocity}),
    taa<&Taa::motion_length_px>({"motion-length", px_a_frame, "motion-length rejects where lengths differ by more.", "Sousa 2011", 0, 1000, motion_length}),
    taa<&Taa::speed_px>({"speed-limit", px_a_frame, "speed rejects what is or was faster.", "Wronski 2014", 0, 1000, speed}),
    taa<&Taa::depth_share>({"depth-share", "", "depth rejects where the distance differs by more than this share.", trail, 0, 10, depth}),
    taa<&Taa::fast_alpha>({"fast-alpha", "", "The weight of the current frame where the picture is fast.", "", 0, 1, by_speed}),
    taa<&Taa::fast_px>({"fast", px_a_frame, "What is as fast as this, or faster, counts as fast.", "", 0.01f, 1000, knows_fast}),
    taa<&Taa::centred_rest>({"centred-rest", "", "How much of input=centred is taken where the picture rests; where it is fast, all of it is.", "", 0, 1, centres_input}),
    taa<&Taa::zoom_weight>({"zoom-weight", "", "What each share by which a surface came nearer adds to the weight.", "", 0, 100, by_speed}),
    taa<&Taa::sharpen>({"sharpen", "", "Sharpens after the resolve; 2 is the GDK sample's.", gdk, 0, 10}),
    taa<&Taa::mip_bias>({"mip-bias", "levels", "Takes sharper levels of textures.", gdk, -2, 0}),
    taa<&Taa::texture_jitter>({"texture-jitter", "", "Whether textures move with the jitter.", trail, 0, 0, jitters}),
    taa<&Taa::resolver>({"resolver", "", "The fast implementation, or the plain one that it is measured by.", "", 0, 0, keeps_history}),
    taa<&Taa::store>({"store", "", "Dithered to half floats, or left to the device: what that costs, and what drifts without it.", "Roberts 2018", 0, 0, keeps_history}),
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
    setting<&Settings::keep_all>({"keep-all", "", "Draws and keeps everything, needed or not: what leaving out is measured against."}),
  };
  // clang-format on
  return rows;
}

} // namespace unghost
