#include "renderer/scene/gltf_animations.h"

#include <algorithm>

namespace unghost::gltf {

namespace {

std::optional<Channel> channel_of(const std::string& path, Warnings& warnings) {
  if (path == "translation") return Channel::translation;
  if (path == "rotation") return Channel::rotation;
  if (path == "scale") return Channel::scale;
  const bool is_weights = path == "weights";
  warnings.say(is_weights ? "animated morph weights are not supported and left out"
                          : "animations of '" + printable(path) + "' are not supported and left out");
  return std::nullopt;
}

class Reader {
public:
  Reader(const Scene& scene, const tinygltf::Model& model, const Accessors& accessors, Warnings& warnings)
      : scene_(scene), model_(model), accessors_(accessors), warnings_(warnings) {}

  Animation animation(size_t index, const std::vector<int>& places);

private:
  AnimationTrack track(const tinygltf::AnimationSampler& from, Channel channel,
                       const std::string& pointer) const;
  std::vector<float> times(size_t accessor, const std::string& pointer) const;
  Interpolation interpolation(const std::string& name, const std::string& pointer) const;

  const Scene& scene_;
  const tinygltf::Model& model_;
  const Accessors& accessors_;
  Warnings& warnings_;
};

std::vector<float> Reader::times(size_t accessor, const std::string& pointer) const {
  if (accessors_[accessor].components != 1 || accessors_[accessor].component != Component::f32) {
    refuse("times of key frames are single floats", pointer + "/input");
  }
  std::vector<float> times = accessors_.read_floats(accessor);
  if (times.front() < 0 || !std::is_sorted(times.begin(), times.end())) {
    refuse("times of key frames do not ascend from zero", pointer + "/input");
  }
  return times;
}

Interpolation Reader::interpolation(const std::string& name, const std::string& pointer) const {
  if (name.empty() || name == "LINEAR") return Interpolation::linear;
  if (name == "STEP") return Interpolation::step;
  if (name == "CUBICSPLINE") return Interpolation::cubic_spline;
  refuse("there is no interpolation '" + printable(name) + "'", pointer + "/interpolation");
}

AnimationTrack Reader::track(const tinygltf::AnimationSampler& from, Channel channel,
                             const std::string& pointer) const {
  const auto output = size_t(from.output);
  const int width = channel == Channel::rotation ? 4 : 3;
  AnimationTrack track{.channel = channel,
                       .interpolation = interpolation(from.interpolation, pointer),
                       .times = times(size_t(from.input), pointer),
                       .values = {}};
  const uint64_t values_a_key = track.interpolation == Interpolation::cubic_spline ? 3 : 1;
  const Accessor& values = accessors_[output];
  const bool is_integer = values.component != Component::f32;
  if (values.components != width || (is_integer && !(values.normalized && channel == Channel::rotation))) {
    refuse("key frames of this kind are of another type", pointer + "/output");
  }
  if (values.count != track.times.size() * values_a_key) {
    refuse("has " + std::to_string(values.count) + " values for " + std::to_string(track.times.size()) +
               " keys",
           pointer + "/output");
  }
  const std::vector<float> numbers = accessors_.read_floats(output);
  track.values.resize(values.count, glm::vec4(0));
  for (size_t i = 0; i < numbers.size(); ++i)
    track.values[i / size_t(width)][int(i % size_t(width))] = numbers[i];
  if (channel != Channel::rotation || values_a_key == 3) return track;
  for (glm::vec4& value : track.values) {
    const double length = glm::length(glm::dvec4(value));
    value = length > 0 ? glm::vec4(glm::dvec4(value) / length) : glm::vec4(0, 0, 0, 1);
  }
  return track;
}

Animation Reader::animation(size_t index, const std::vector<int>& places) {
  const tinygltf::Animation& from = model_.animations[index];
  Animation animation;
  animation.name = from.name;
  for (const tinygltf::AnimationChannel& channel : from.channels) {
    const std::string pointer =
        pointer_to("animations", index, "samplers") + "/" + std::to_string(channel.sampler);
    if (size_t(channel.sampler) >= from.samplers.size()) refuse("there is no such sampler", pointer);
    const std::optional<Channel> property = channel_of(channel.target_path, warnings_);
    const int node = channel.target_node >= 0 ? places[size_t(channel.target_node)] : -1;
    if (!property || node < 0) continue;
    if (scene_.nodes[size_t(node)].matrix) {
      warnings_.say("an animation of a node that has a matrix is left out");
      continue;
    }
    AnimationTrack moved = track(from.samplers[size_t(channel.sampler)], *property, pointer);
    moved.node = node;
    animation.duration = std::max(animation.duration, moved.times.back());
    animation.tracks.push_back(std::move(moved));
  }
  return animation;
}

} // namespace

std::vector<Animation> read_animations(const Scene& scene, const tinygltf::Model& model,
                                       const Accessors& accessors, const std::vector<int>& places,
                                       Warnings& warnings) {
  Reader reader(scene, model, accessors, warnings);
  std::vector<Animation> animations;
  for (size_t i = 0; i < model.animations.size(); ++i) {
    Animation animation = reader.animation(i, places);
    if (!animation.tracks.empty()) animations.push_back(std::move(animation));
  }
  return animations;
}

} // namespace unghost::gltf
