#include "app/measure/stability_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <new>

#include <nlohmann/json.hpp>

#include "app/failure.h"

namespace unghost {
namespace {

using nlohmann::json;

json json_of(const StabilityCell& cell, const StabilityTable& table) {
  const auto column = std::ranges::find(table.columns, cell.column, &StabilityColumn::name);
  json object = {
      {"mode", cell.mode},      {"case", cell.column}, {"value", cell.value ? json(*cell.value) : json()},
      {"bound", column->bound}, {"pass", cell.pass},   {"worst", cell.worst}};
  if (!cell.excuse.empty()) object["excuse"] = cell.excuse;
  return object;
}

StabilityCell figure_of(const json& object, const StabilityTable& table) {
  StabilityCell cell{.mode = object.at("mode"),
                     .column = object.at("case"),
                     .value = {},
                     .worst = object.at("worst"),
                     .excuse = object.value("excuse", ""),
                     .pass = object.at("pass")};
  if (!object.at("value").is_null()) cell.value = object.at("value").get<double>();
  if (std::ranges::find(table.columns, cell.column, &StabilityColumn::name) == table.columns.end())
    throw std::invalid_argument("'" + cell.column + "' is none of its cases");
  return cell;
}

} // namespace

const StabilityCell* find_cell(const StabilityTable& table, const std::string& mode,
                               const std::string& column) {
  const auto found = std::ranges::find_if(table.cells, [&](const StabilityCell& cell) {
    return cell.column == column && (cell.mode == mode || cell.mode == every_mode);
  });
  return found == table.cells.end() ? nullptr : &*found;
}

const StabilityCell* worst_cell(const StabilityTable& table, const std::string& column) {
  const auto worse = [](const StabilityCell& a, const StabilityCell& b) {
    return !a.value ? b.value.has_value() : b.value && *a.value > *b.value;
  };
  const StabilityCell* worst = nullptr;
  for (const StabilityCell& cell : table.cells)
    if (cell.column == column && cell.excuse.empty() && (worst == nullptr || worse(cell, *worst)))
      worst = &cell;
  return worst;
}

size_t missing_cells(const StabilityTable& table) {
  size_t missing = 0;
  for (const std::string& mode : modes_of(table))
    for (const StabilityColumn& column : table.columns)
      missing += find_cell(table, mode, column.name) == nullptr;
  return missing;
}

std::vector<std::string> modes_of(const StabilityTable& table) {
  std::vector<std::string> modes;
  for (const StabilityCell& cell : table.cells)
    if (cell.mode != every_mode && std::ranges::find(modes, cell.mode) == modes.end())
      modes.push_back(cell.mode);
  return modes.empty() ? std::vector<std::string>{every_mode} : modes;
}

std::string value_text(const std::optional<double>& value) {
  if (!value) return "broken";
  if (*value == 0) return "0";
  char buffer[64];
  const double size = std::abs(*value);
  const auto [end, error] =
      size < 1e-3 || size >= 1e6
          ? std::to_chars(buffer, buffer + sizeof buffer, *value, std::chars_format::scientific, 1)
          : std::to_chars(buffer, buffer + sizeof buffer, *value, std::chars_format::fixed,
                          std::max(2 - int(std::floor(std::log10(size))), 0));
  return {buffer, end};
}

json stability_json(const StabilityTable& table) {
  json object = {{"version", table.version},     {"device", table.device}, {"driver", table.driver},
                 {"endurance", table.endurance}, {"seed", table.seed},     {"cases", json::array()},
                 {"cells", json::array()}};
  for (const StabilityColumn& column : table.columns)
    object["cases"].push_back(
        {{"name", column.name}, {"summary", column.summary}, {"unit", column.unit}, {"bound", column.bound}});
  for (const StabilityCell& cell : table.cells) object["cells"].push_back(json_of(cell, table));
  return object;
}

StabilityTable stability_from_json(const json& object, const std::string& where) {
  try {
    if (!object.is_object()) throw std::invalid_argument("it is no object");
    StabilityTable table{.version = object.at("version"),
                         .device = object.at("device"),
                         .driver = object.at("driver"),
                         .endurance = object.at("endurance"),
                         .seed = object.at("seed"),
                         .columns = {},
                         .cells = {}};
    for (const json& column : object.at("cases"))
      table.columns.push_back({.name = column.at("name"),
                               .summary = column.at("summary"),
                               .unit = column.at("unit"),
                               .bound = column.at("bound")});
    for (const json& cell : object.at("cells")) table.cells.push_back(figure_of(cell, table));
    return table;
  } catch (const std::bad_alloc&) {
    throw; // is no fault of the file
  } catch (const std::exception& error) {
    const std::string said = error.what();
    throw Failure(Exit::input_refused, where + " holds no matrix of unghost stability: " +
                                           said.substr(said.starts_with('[') ? said.find(']') + 2 : 0));
  }
}

} // namespace unghost
