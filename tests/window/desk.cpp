#include "tests/window/desk.h"

#include <sstream>
#include <stdexcept>
#include <thread>

#include "tests/window/file_drop.h"
#include "tests/window/window_manager.h"

namespace unghost {
namespace {

using Clock = std::chrono::steady_clock;

template <class Condition> bool wait_until(Condition&& condition) {
  for (const auto until = Clock::now() + patience; Clock::now() < until;) {
    if (condition()) return true;
    std::this_thread::sleep_for(Milliseconds(20));
  }
  return false;
}

Words lines_of(const std::string& text) {
  std::istringstream stream(text);
  Words lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

} // namespace

std::string Desk::missing() {
  for (const char* program : {"Xvfb", "xdotool"})
    if (std::system((std::string("command -v ") + program + " >/dev/null").c_str()) != 0)
      return std::string(program) + " is not installed";
  return {};
}

Desk::Desk(Size size) {
  std::filesystem::create_directories(gamepads());
  std::filesystem::create_directories(home());
  const std::string screen = std::to_string(size.width) + "x" + std::to_string(size.height) + "x24";
  // It takes the first number that is free and prints it. A mouse pointer would be in the pictures.
  server_.emplace(Words{"Xvfb", "-displayfd", "1", "-screen", "0", screen, "-fbdir", folder_.path.string(),
                        "-nolisten", "tcp", "-noreset", "-nocursor"},
                  folder_.path / "server");
  const auto number = server_->line();
  if (!number) throw std::runtime_error("Xvfb did not start: " + server_->talk());
  display_ = ":" + *number;
}

std::string Desk::xdotool(const Words& words) const {
  Words order = {"env", "DISPLAY=" + display_, "xdotool"};
  order.insert(order.end(), words.begin(), words.end());
  Process process(order, folder_.path / "xdotool");
  const std::string said = process.rest();
  // of a search, 1 says that nothing was found
  if (process.exit_code() != 0 && (words.front() != "search" || !process.talk().empty()))
    throw std::runtime_error("xdotool " + words.front() + ": " + process.talk());
  return said;
}

DeskWindow Desk::window(const std::string& title) const {
  Words found;
  const bool one = wait_until([&] {
    found = lines_of(xdotool({"search", "--onlyvisible", "--name", title}));
    return found.size() == 1;
  });
  if (!one)
    throw std::runtime_error(std::to_string(found.size()) + " windows have a title like '" + title + "'");
  const DeskWindow window(*this, found.front());
  window.focus();
  return window;
}

Picture Desk::picture(Spot corner, Size size) const {
  return read_xwd(folder_.path / "Xvfb_screen0", corner, size);
}

void DeskWindow::focus() const { desk_->xdotool({"windowfocus", "--sync", id_}); }
void DeskWindow::press(const std::string& key) const { desk_->xdotool({"key", key}); }
void DeskWindow::hold(const std::string& key) const { desk_->xdotool({"keydown", key}); }
void DeskWindow::let_go(const std::string& key) const { desk_->xdotool({"keyup", key}); }

void DeskWindow::mouse(const Words& words) const { desk_->xdotool(words); }

void DeskWindow::move_mouse(Spot to) const {
  mouse({"mousemove", "--window", id_, std::to_string(to.x), std::to_string(to.y)});
}

void DeskWindow::hold_mouse(int button) const { mouse({"mousedown", std::to_string(button)}); }
void DeskWindow::let_go_mouse(int button) const { mouse({"mouseup", std::to_string(button)}); }

void DeskWindow::click(Spot at, int button) const {
  move_mouse(at);
  mouse({"click", std::to_string(button)});
}

void DeskWindow::drag(Spot from, Spot to, Milliseconds pause) const {
  constexpr int steps = 5;
  move_mouse(from);
  std::this_thread::sleep_for(pause);
  hold_mouse();
  for (int i = 1; i <= steps; i++) {
    std::this_thread::sleep_for(pause);
    move_mouse({from.x + (to.x - from.x) * i / steps, from.y + (to.y - from.y) * i / steps});
  }
  std::this_thread::sleep_for(pause);
  let_go_mouse();
}

void DeskWindow::scroll(int notches) const {
  mouse({"click", "--repeat", std::to_string(std::abs(notches)), "--delay", "20", notches > 0 ? "4" : "5"});
}

void DeskWindow::drop(const std::vector<std::filesystem::path>& files) const {
  drop_files(desk_->display(), std::stoul(id_), files);
}

void DeskWindow::resize(Size size) const {
  desk_->xdotool({"windowsize", id_, std::to_string(size.width), std::to_string(size.height)});
}

void DeskWindow::minimise() const { set_iconic(desk_->display(), std::stoul(id_), true); }

void DeskWindow::restore() const {
  set_iconic(desk_->display(), std::stoul(id_), false);
  focus(); // which went elsewhere
}

DeskWindow::Place DeskWindow::place() const {
  Place place = {};
  for (const std::string& line : lines_of(desk_->xdotool({"getwindowgeometry", "--shell", id_}))) {
    std::sscanf(line.c_str(), "X=%d", &place.corner.x);
    std::sscanf(line.c_str(), "Y=%d", &place.corner.y);
    std::sscanf(line.c_str(), "WIDTH=%d", &place.size.width);
    std::sscanf(line.c_str(), "HEIGHT=%d", &place.size.height);
  }
  return place;
}

Size DeskWindow::size() const { return place().size; }

void DeskWindow::expect_size(Size wanted) const {
  if (!wait_until([&] { return size() == wanted; })) throw std::runtime_error("the window has another size");
}

Picture DeskWindow::picture() const {
  const Place now = place();
  return desk_->picture(now.corner, now.size);
}

} // namespace unghost
