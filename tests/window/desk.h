// A screen, a keyboard and a mouse of a test's own: an X server that shows nothing to anybody (Xvfb), and
// xdotool.
#pragma once

#include "tests/app/scratch_folder.h"
#include "tests/window/picture.h"
#include "tests/window/process.h"

namespace unghost {

class DeskWindow;

/// No window manager runs on it: windows lie where they put themselves, without frames. Whatever fails on it
/// is a std::runtime_error with a sentence.
class Desk {
public:
  explicit Desk(Size size = {1280, 720});

  /// Why there can be none here, in a sentence; empty where there can.
  static std::string missing();

  /// As in DISPLAY.
  const std::string& display() const { return display_; }
  /// Stands in for /dev/input.
  std::filesystem::path gamepads() const { return folder_.path / "gamepads"; }
  /// Where programs find and leave what they keep between runs.
  std::filesystem::path home() const { return folder_.path / "home"; }
  /// Where a program's standard error goes.
  std::filesystem::path talk() const { return folder_.path / "talk"; }

  /// Waits for the window whose title matches (an extended regular expression), gives it the keyboard and
  /// returns it; without one asked for, the only window there is that has a title.
  DeskWindow window(const std::string& title = ".") const;
  /// What xdotool prints.
  std::string xdotool(const Words& words) const;
  /// The screen as it is now: also in the middle of a change.
  Picture picture(Spot corner, Size size) const;

private:
  ScratchFolder folder_;
  std::string display_;
  std::optional<Process> server_;
};

/// Keys are X keysyms (Return, space, z, Escape), and spots are the window's. What is done arrives in that
/// order, but the program may not have seen it when a call returns: wait for what it says.
class DeskWindow {
public:
  DeskWindow(const Desk& desk, std::string id) : desk_(&desk), id_(std::move(id)) {}

  void focus() const;
  void press(const std::string& key) const;
  void hold(const std::string& key) const;
  void let_go(const std::string& key) const;

  void move_mouse(Spot to) const;
  /// Buttons: 1 left, 2 middle, 3 right.
  void hold_mouse(int button = 1) const;
  void let_go_mouse(int button = 1) const;
  void click(Spot at, int button = 1) const;
  /// In steps, with a pause after each that lets the program draw a frame in between.
  void drag(Spot from, Spot to, Milliseconds pause = Milliseconds(30)) const;
  /// Away from the user where positive.
  void scroll(int notches) const;

  /// As a file manager does it, onto the middle; the program has taken them when it returns.
  void drop(const std::vector<std::filesystem::path>& files) const;

  void resize(Size size) const;
  /// As a window manager does it: the window is iconic, and is not shown.
  void minimise() const;
  void restore() const;

  Size size() const;
  /// Waits until it is that large.
  void expect_size(Size size) const;
  Picture picture() const;

private:
  struct Place {
    Spot corner;
    Size size;
  };
  Place place() const;
  void mouse(const Words& words) const;

  const Desk* desk_;
  std::string id_;
};

} // namespace unghost
