// Aligned columns for people to read.
#pragma once

#include <string>
#include <vector>

namespace unghost {

class Table {
public:
  explicit Table(std::vector<std::string> heads) : rows_{std::move(heads)} {}
  /// As many cells as there are heads.
  void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  /// Lines with every column as wide as its widest cell; numbers to the right, but for
  /// those in the first column, which are names.
  std::string text() const;

private:
  std::vector<std::vector<std::string>> rows_;
};

/// With that many decimals, whatever the locale.
std::string fixed(double value, int decimals);

} // namespace unghost
