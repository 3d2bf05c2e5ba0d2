// lib/pliant/quality/element/condition.cpp: parses a key, an operator and a number, and compares.
#include "pliant/quality/element/condition.h"

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include "pliant/quality/metrics.h"

namespace pliant {
namespace {

/// A value of the report that is not a metric.
struct Scalar {
  std::string_view name;
  double (*value)(const QualityReport&);
};
constexpr std::array<Scalar, 13> scalars{
    {{"triangles", [](const QualityReport& r) { return static_cast<double>(r.triangles); }},
     {"vertices", [](const QualityReport& r) { return static_cast<double>(r.vertices); }},
     {"control_points", [](const QualityReport& r) { return static_cast<double>(r.control_points); }},
     {"degree", [](const QualityReport& r) { return static_cast<double>(r.degree); }},
     {"time", [](const QualityReport& r) { return r.time; }},
     {"area", [](const QualityReport& r) { return r.area; }},
     {"invalid", [](const QualityReport& r) { return static_cast<double>(r.invalid); }},
     {"degenerate", [](const QualityReport& r) { return static_cast<double>(r.degenerate); }},
     {"overlaps", [](const QualityReport& r) { return static_cast<double>(r.overlaps); }},
     {"duplicate_points", [](const QualityReport& r) { return static_cast<double>(r.duplicate_points); }},
     {"unused_points", [](const QualityReport& r) { return static_cast<double>(r.unused_points); }},
     {"faults", [](const QualityReport& r) { return static_cast<double>(r.faults.size()); }},
     {"tangent_jump", [](const QualityReport& r) { return r.tangent_jump.value_or(NAN); }}}};

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\n\r";
  const auto first = text.find_first_not_of(blank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

}  // namespace

Condition::Condition(const std::string& text) : text_(trimmed(text)) {
  const auto fail = [this](const std::string& why) {
    throw std::invalid_argument("\"" + text_ + "\" is no condition KEY OP NUMBER: " + why);
  };
  const std::string_view whole = text_;
  const auto start = whole.find_first_of("<>=!");
  if (start == std::string_view::npos) fail("it lacks one of < <= > >= == !=");
  const auto end = whole.find_first_not_of("<>=!", start);
  operator_ = whole.substr(start, end == std::string_view::npos ? end : end - start);
  constexpr std::array<std::string_view, 6> operators{"<", "<=", ">", ">=", "==", "!="};
  bool is_known = false;
  for (const std::string_view op : operators) is_known = is_known || op == operator_;
  if (!is_known) fail("\"" + operator_ + "\" is none of < <= > >= == !=");

  std::string_view number = end == std::string_view::npos ? std::string_view{} : trimmed(whole.substr(end));
  if (number.starts_with('+')) number.remove_prefix(1);
  const auto [stop, error] = std::from_chars(number.data(), number.data() + number.size(), bound_);
  if (error != std::errc{} || stop != number.data() + number.size() || !std::isfinite(bound_))
    fail("\"" + std::string(number) + "\" is not a finite number");

  const std::string_view key = trimmed(whole.substr(0, start));
  const auto open = key.find('(');
  if (open == std::string_view::npos) {
    key_ = key;
    std::string list;
    for (const Scalar& scalar : scalars) {
      if (scalar.name == key_) return;
      list += (list.empty() ? "" : ", ") + std::string(scalar.name);
    }
    if (find_report_metric(key_) != nullptr)
      fail("say which value of the metric: min(" + key_ + "), max(" + key_ + ") or mean(" + key_ + ")");
    fail("\"" + key_ + "\" is none of " + list + ", min(METRIC), max(METRIC), mean(METRIC)");
  }
  const std::string_view function = trimmed(key.substr(0, open));
  if (key.back() != ')') fail("a \")\" is missing");
  key_ = trimmed(key.substr(open + 1, key.size() - open - 2));
  if (function == "min")
    statistic_ = Statistic::min;
  else if (function == "max")
    statistic_ = Statistic::max;
  else if (function == "mean")
    statistic_ = Statistic::mean;
  else
    fail("\"" + std::string(function) + "\" is none of min, max, mean");
  if (find_report_metric(key_) == nullptr)
    fail("\"" + key_ + "\" is no metric; there are " + std::string(metric_list()));
}

std::optional<double> Condition::value(const QualityReport& report) const {
  double result = NAN;
  if (statistic_ == Statistic::scalar) {
    for (const Scalar& scalar : scalars)
      if (scalar.name == key_) result = scalar.value(report);
  }
  for (const MetricSummary& metric : report.metrics) {
    if (statistic_ == Statistic::scalar || metric.name != key_) continue;
    result = statistic_ == Statistic::min ? metric.min : statistic_ == Statistic::max ? metric.max : metric.mean;
  }
  if (std::isnan(result)) return std::nullopt;
  return result;
}

bool Condition::holds(const QualityReport& report) const {
  const std::optional<double> found = value(report);
  if (!found) return false;
  if (operator_ == "<") return *found < bound_;
  if (operator_ == "<=") return *found <= bound_;
  if (operator_ == ">") return *found > bound_;
  if (operator_ == ">=") return *found >= bound_;
  return (*found == bound_) == (operator_ == "==");
}

}  // namespace pliant
