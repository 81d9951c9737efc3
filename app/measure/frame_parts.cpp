#include "app/measure/frame_parts.h"

#include <algorithm>
#include <cassert>

namespace unghost {
namespace {

double total_ms(const FrameResult& result) {
  double sum = 0;
  for (const PassReport& pass : result.passes) sum += pass.ms;
  return sum;
}

/// The pass of the other frame that does the very same; what it takes longer there is noise.
bool does_the_same(const PassReport& pass, const FrameResult& other) {
  const auto found = std::ranges::find(other.passes, pass.name, &PassReport::name);
  return found != other.passes.end() && found->pipelines == pass.pipelines;
}

/// Of the passes that differ.
double difference_ms(const FrameResult& more, const FrameResult& less) {
  double sum = 0;
  for (const PassReport& pass : more.passes)
    if (!does_the_same(pass, less)) sum += pass.ms;
  for (const PassReport& pass : less.passes)
    if (!does_the_same(pass, more)) sum -= pass.ms;
  return sum;
}

/// The passes of `less` do what those of `more` do, if there are any of that name.
bool is_part_of(const FrameResult& less, const FrameResult& more) {
  return std::ranges::all_of(less.passes, [&](const PassReport& pass) { return does_the_same(pass, more); });
}

/// What one frame keeps for the next, as the shadows of what rests, is made in some frames only: one that did
/// make it does so each time that it is timed.
bool kept_something(const FrameResult& frame, const FrameResult& again) {
  return frame.passes.size() != again.passes.size();
}

/// Everything but one thing: how it is drawn, and one such frame.
struct AllBut {
  FrameInput input;
  FrameResult frame;
};

} // namespace

FrameParts take_apart(const Film& film, const ModeRun& mode, uint32_t frame, uint32_t rounds) {
  FrameParts parts;
  FrameInput lean;
  for (uint32_t index = 0; index <= frame; ++index) {
    lean = film.at(index);
    lean.modes = {mode}, lean.shown = true;
    parts.frame = film.draw(lean);
  }
  lean.keeps_nothing = kept_something(parts.frame, film.draw(lean));
  FrameInput everything = lean;
  everything.settings.keep_all = true;
  parts.everything = film.draw(everything); // each first frame of its kind compiles, and is not timed
  std::vector<AllBut> all_but;
  for (const LeftOut& thing : parts.frame.left_out) {
    AllBut& other = all_but.emplace_back(everything);
    other.input.left_out = thing.what;
    other.frame = film.draw(other.input);
    parts.savings.push_back(
        {.thing = thing, .bytes = int64_t(parts.everything.image_bytes) - int64_t(other.frame.image_bytes)});
  }
  parts.pass_ms.resize(parts.frame.passes.size());
  for (uint32_t round = 0; round < rounds; ++round) {
    const FrameResult one = film.draw(lean), all = film.draw(everything);
    parts.frame_ms.push_back(total_ms(one)), parts.everything_ms.push_back(total_ms(all));
    assert(!kept_something(parts.frame, one));
    for (size_t pass = 0; pass < one.passes.size(); ++pass)
      parts.pass_ms[pass].push_back(one.passes[pass].ms);
    for (size_t i = 0; i < all_but.size(); ++i) {
      AllBut& other = all_but[i];
      // where only passes are missing, their own times say all
      if (!is_part_of(other.frame, all)) other.frame = film.draw(other.input);
      parts.savings[i].ms.push_back(difference_ms(all, other.frame));
    }
  }
  return parts;
}

} // namespace unghost
