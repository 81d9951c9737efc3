// The demo's frames: what they are made from, when they are drawn, and when what was drawn stays.
#include <algorithm>
#include <thread>

#include "app/demo/demo.h"
#include "app/demo/render_scale.h"
#include "app/measure/quantile.h"

namespace unghost {
namespace {

constexpr double idle_seconds = 0.05;

} // namespace

Moment Demo::next_moment() {
  if (replay_) return replayed_moment();
  const ScreenCell cell = cells_of(place().screen, shown().size()).front();
  const auto drawn_of = [&](int shown_px) {
    return std::max(1u, uint32_t(std::lround(shown_px * state_.render_scale)));
  };
  return {.rig = state_.rig,
          .rig_frame = state_.rig_frame,
          .camera = state_.camera,
          .index = drawn_,
          .size = {.width = drawn_of(cell.picture.width), .height = drawn_of(cell.picture.height)},
          .cut = !last_ || state_.requests.drop_history || last_rig_ != state_.rig};
}

FrameInput Demo::next_frame(const Moment& moment) {
  context_.stage = state_.settings.stage, context_.light = state_.settings.light, context_.seed = state_.seed;
  std::vector<ModeRun> modes;
  for (const size_t mode : shown()) modes.push_back(state_.modes[mode]);
  const Instant now = instant_of(moment, context_);
  FrameInput input = frame_input(moment, now, last_.value_or(now), state_.settings, std::move(modes));
  input.screen = place().screen;
  facts_.picture_width = input.width, facts_.picture_height = input.height;
  input.probe = probe(input.modes.size());
  return input;
}

/// The next one follows it.
void Demo::go_on_after(const Moment& moment, const Instant& now) {
  last_ = now;
  last_rig_ = state_.rig;
  state_.rig_frame_shown = moment.rig_frame;
  state_.rig_frame += state_.moving;
  state_.requests.drop_history = false;
  ++drawn_;
  follow_replay();
}

std::optional<ProbeInput> Demo::probe(size_t modes) const {
  if (!state_.picked) return {};
  const glm::ivec2 pixel = pixel_of(*state_.picked, {facts_.picture_width, facts_.picture_height});
  const size_t mode = state_.picked->mode;
  return ProbeInput{.mode = mode < modes ? mode : 0, .x = uint32_t(pixel.x), .y = uint32_t(pixel.y)};
}

void Demo::look_for_rest() { stillness_.emplace(!renderer_->scene().animations.empty()); }

/// What was drawn last, under the bar and the magnifier of now.
void Demo::show_what_rests() {
  probe_what_rests();
  renderer_->show_again(place().screen, swapchain_);
  std::this_thread::sleep_for(std::chrono::duration<double>(idle_seconds));
}

/// No frame brings it.
void Demo::probe_what_rests() {
  const std::optional<ProbeInput> asked = probe(shown().size());
  if (!asked || asked == probed_) return;
  facts_.pixel = renderer_->probe_again(*asked);
  probed_ = asked;
}

bool Demo::fit_window() {
  const VkExtent2D wanted = window_.pixels(), is = swapchain_.extent();
  if (wanted.width == 0 || wanted.height == 0) return false;
  if (wanted.width == is.width && wanted.height == is.height) return true;
  swapchain_.resize(wanted);
  gui_.window_changed(swapchain_);
  return swapchain_.extent().width > 0;
}

void Demo::note(const FrameResult& result) {
  if (result.probe) facts_.pixel = result.probe;
  facts_.frame = result;
  if (line_.timings) times_.note(result);
  double sum = 0;
  for (const PassReport& pass : result.passes) sum += pass.ms;
  facts_.gpu_ms.push_back(float(sum));
  if (facts_.gpu_ms.size() > charted_frames) facts_.gpu_ms.pop_front();
  hold_frame_time();
}

/// By the render scale, where a person wants it.
void Demo::hold_frame_time() {
  if (!state_.frame_ms || drawn_ % frames_between_scales != 0) return;
  const size_t looked_at = std::min<size_t>(facts_.gpu_ms.size(), frames_between_scales / 2);
  const std::vector<double> last(facts_.gpu_ms.end() - ptrdiff_t(looked_at), facts_.gpu_ms.end());
  state_.render_scale = next_scale(state_.render_scale, quantile(last, 0.5), *state_.frame_ms);
}

void Demo::draw() {
  if (!fit_window()) {
    std::this_thread::sleep_for(std::chrono::duration<double>(idle_seconds));
    return;
  }
  swapchain_.picture_x = uint32_t(place().at.x);
  if (!state_.picked) facts_.pixel.reset();
  const bool goes_on = !state_.paused || state_.requests.step;
  if (!goes_on && last_) return show_what_rests();
  state_.requests.step = false;
  const Moment moment = next_moment();
  const FrameInput input = next_frame(moment);
  facts_.rests = stillness_->frames_left(input) == 0 && renderer_->has_shown() && !replay_;
  if (facts_.rests) {
    go_on_after(moment, input.now); // what stays stands for a frame that looks the same
    return show_what_rests();
  }
  probed_.reset();
  const uint64_t before = renderer_->frames();
  const std::optional<FrameResult> result = renderer_->show(input, swapchain_);
  if (renderer_->frames() > before) {
    record(moment);
    go_on_after(moment, input.now);
  } else { // the window has changed
    look_for_rest();
  }
  if (result) note(*result);
}

} // namespace unghost
