#include "app/table.h"

#include <algorithm>
#include <charconv>

namespace unghost {
namespace {

/// Or the dash that stands for one.
bool is_number(const std::string& text) {
  const bool digits = text.find_first_not_of("0123456789.") == std::string::npos;
  return text == "-" || (digits && std::ranges::count(text, '.') <= 1);
}

} // namespace

std::string Table::text() const {
  std::vector<size_t> widths(rows_.front().size(), 0);
  for (const auto& row : rows_)
    for (size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  std::string text;
  for (const auto& row : rows_) {
    std::string line;
    for (size_t i = 0; i < row.size(); ++i) {
      const std::string gap(widths[i] - row[i].size(), ' ');
      line += (i == 0 ? "" : "  ") + (i > 0 && is_number(row[i]) ? gap + row[i] : row[i] + gap);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

std::string fixed(double value, int decimals) {
  char buffer[400]; // the largest double has 309 digits before the point
  return {buffer,
          std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, decimals).ptr};
}

} // namespace unghost
