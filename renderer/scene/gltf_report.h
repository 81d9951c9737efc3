// How the inside of the loader says no, and how it says what it leaves out.
#pragma once

#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace unghost::gltf {

/// Thrown anywhere behind load_scene and caught there, once.
struct Refused {
  std::string pointer; // JSON pointer
  std::string why;
};

[[noreturn]] void refuse(std::string why, std::string pointer = {});

/// Text out of a file made fit for a terminal: control characters become '?', and what is long is cut.
std::string printable(std::string_view text);

/// `/nodes/3/mesh` out of its parts.
std::string pointer_to(std::string_view collection, size_t index, std::string_view field = {});

/// What is said about a file that is loaded all the same: each sentence once, and no more than a person
/// reads.
class Warnings {
public:
  void say(const std::string& sentence);
  std::vector<std::string> take() { return std::move(said_); }

private:
  std::vector<std::string> said_;
  std::unordered_set<std::string> known_;
};

} // namespace unghost::gltf
