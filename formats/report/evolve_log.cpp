// formats/report/evolve_log.cpp: members and columns in the order of formats/evolve_log.md.
#include "formats/report/evolve_log.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>

#include "formats/document/document_value.h"
#include "formats/document/write_json.h"
#include "pliant/boundary/fault.h"

namespace pliant {
namespace {

constexpr double clock_digits = 1e6;  // the clock is not better than microseconds

double in_microseconds(double seconds) { return std::round(clock_digits * seconds) / clock_digits; }

long count_refusals(const PassReport& report) {
  return std::accumulate(report.refusals.begin(), report.refusals.end(), 0L,
                         [](long sum, const auto& refusal) { return sum + refusal.second; });
}

/// The cells of a step, by their columns and in their order.
std::vector<std::pair<std::string, double>> cells_of(const StepLine& line) {
  std::vector<std::pair<std::string, double>> cells{{"step", static_cast<double>(line.step)},
                                                    {"part", static_cast<double>(line.part)},
                                                    {"time", line.time},
                                                    {"dt", line.dt},
                                                    {"triangles", static_cast<double>(line.triangles)},
                                                    {"min_scaled_jacobian", line.min_scaled_jacobian},
                                                    {"min_logical_angle", line.min_logical_angle}};
  std::map<std::string, int> seen;
  for (const StageWork& work : line.stages) {
    const int number = ++seen[work.stage];
    const std::string prefix = work.stage + (number > 1 ? "-" + std::to_string(number) : "") + ".";
    cells.emplace_back(prefix + "seconds", in_microseconds(work.seconds));
    for (const auto& [name, value] : work.report.values) cells.emplace_back(prefix + name, value);
    cells.emplace_back(prefix + "refused", static_cast<double>(count_refusals(work.report)));
  }
  return cells;
}

std::vector<std::string_view> split_cells(std::string_view row) {
  std::vector<std::string_view> cells;
  while (true) {
    const std::size_t comma = row.find(',');
    cells.push_back(row.substr(0, comma));
    if (comma == std::string_view::npos) return cells;
    row.remove_prefix(comma + 1);
  }
}

}  // namespace

void write_step_line(const StepLine& line, std::string& out) {
  Json stages = Json::array();
  for (const StageWork& work : line.stages) {
    Json values = Json::object(), refusals = Json::object();
    for (const auto& [name, value] : work.report.values) values[name] = count_or_number(value);
    for (const auto& [reason, times] : work.report.refusals) refusals[reason] = times;
    stages.push_back({{"stage", work.stage},
                      {"seconds", in_microseconds(work.seconds)},
                      {"values", std::move(values)},
                      {"refusals", std::move(refusals)}});
  }
  const Json json{{"step", line.step},
                  {"part", line.part},
                  {"time", line.time},
                  {"dt", line.dt},
                  {"triangles", line.triangles},
                  {"min_scaled_jacobian", finite_or_null(line.min_scaled_jacobian)},
                  {"min_logical_angle", finite_or_null(line.min_logical_angle)},
                  {"stages", std::move(stages)}};
  append_json(out, json);
  out += '\n';
}

double read_step_time(std::string_view line) {
  const Json json = Json::parse(line, nullptr, false);
  if (!json.is_object() || !json.contains("stages") || !json.contains("time") || !json["time"].is_number())
    throw InputError("", "this is no line of an evolve log: it has no \"stages\", or no number \"time\"");
  return json["time"].get<double>();
}

std::vector<std::string> history_columns(const StepLine& first) {
  std::vector<std::string> columns;
  for (const auto& [name, value] : cells_of(first)) columns.push_back(name);
  return columns;
}

void write_history_heading(const std::vector<std::string>& columns, std::string& out) {
  for (std::size_t k = 0; k < columns.size(); ++k) out += (k > 0 ? "," : "") + columns[k];
  out += '\n';
}

void write_history_row(const std::vector<std::string>& columns, const StepLine& line, std::string& out) {
  const auto cells = cells_of(line);
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (k > 0) out += ',';
    const auto cell = std::ranges::find(cells, columns[k], &std::pair<std::string, double>::first);
    if (cell != cells.end() && std::isfinite(cell->second)) append_number(out, cell->second);
  }
  out += '\n';
}

std::vector<std::string> read_history_heading(std::string_view heading) {
  std::vector<std::string> columns;
  for (const std::string_view cell : split_cells(heading)) columns.emplace_back(cell);
  if (columns.front() != "step" || std::ranges::find(columns, "time") == columns.end())
    throw InputError("", "this is no heading of an evolve history: it has no columns step and time");
  return columns;
}

double read_history_time(const std::vector<std::string>& columns, std::string_view row) {
  const std::vector<std::string_view> cells = split_cells(row);
  const auto column = static_cast<std::size_t>(std::ranges::find(columns, "time") - columns.begin());
  double time = 0;
  if (column < cells.size()) {
    const std::string_view cell = cells[column];
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), time);
    if (error == std::errc() && end == cell.data() + cell.size()) return time;
  }
  throw InputError("", "this is no row of an evolve history: it has no number in the column time");
}

}  // namespace pliant
