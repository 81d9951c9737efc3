// Checks of options' values that the library does not have.
#pragma once

#include <charconv>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "app/table.h"

namespace unghost {

/// Of options that take any words: the next option is none of them.
inline std::string no_option(const std::string& text) {
  return text.empty() || (text.starts_with('-') && text.size() > 1) ? "a value is missing" : "";
}

/// A number, finite and in its range: the library lets `nan` through.
inline CLI::Option* add_number(CLI::App& app, const char* name, std::optional<double>& to, double low,
                               double high, const std::string& help) {
  return app.add_option(name, to, help)->check([low, high](const std::string& text) {
    double value = 0;
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    const bool good = error == std::errc{} && rest == end && value >= low && value <= high;
    return good ? "" : "it is a number from " + fixed(low, 0) + " to " + fixed(high, 0);
  });
}

} // namespace unghost
