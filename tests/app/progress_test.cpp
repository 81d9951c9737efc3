#include "app/progress.h"

#include <sstream>

#include <gtest/gtest.h>

namespace unghost {
namespace {

TEST(Progress, DurationsAreRead) {
  EXPECT_EQ(duration_text(0.2), "1 s");
  EXPECT_EQ(duration_text(59), "59 s");
  EXPECT_EQ(duration_text(60), "1 min");
  EXPECT_EQ(duration_text(130), "2 min 10 s");
  EXPECT_EQ(duration_text(3600), "1 h");
  EXPECT_EQ(duration_text(3780), "1 h 3 min");
}

std::string said(bool terminal, bool quiet) {
  std::ostringstream out, err;
  const Console console{.out = out, .err = err, .quiet = quiet, .terminal = terminal};
  Progress progress(console, 200);
  progress.name("drive");
  progress.skip(100);
  progress.step(25);
  return err.str();
}

TEST(Progress, IsOfTheWorkThatIsLeftToDoAndOnATerminal) {
  EXPECT_NE(said(true, false).find("drive: 25%"), std::string::npos) << said(true, false);
  EXPECT_EQ(said(false, false), "");
  EXPECT_EQ(said(true, true), "");
}

} // namespace
} // namespace unghost
