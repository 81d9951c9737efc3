// Files that the build puts into the program (embed.cmake), for the page to carry.
#pragma once

#include <string_view>

namespace unghost {

struct EmbeddedFile {
  std::string_view text;       // empty where it was not there when the program was built
  std::string_view sha256_hex; // of the text
};

namespace report_files {
extern const EmbeddedFile page_css, page_js, page_charts_js, page_pictures_js;
/// Chart.js 3.9.1 as Debian has it.
extern const EmbeddedFile chart_js;
} // namespace report_files

} // namespace unghost
