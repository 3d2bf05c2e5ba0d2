// tools/options/numbers.cpp: numbers from the texts of options.
#include "options/numbers.h"

#include <charconv>
#include <cmath>

#include "run/exit_status.h"

namespace pliant {

double parse_number(const std::string& option, const std::string& text) {
  double value = 0;
  const char* first = text.c_str();
  const char* last = first + text.size();
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') ++first;
  const auto [end, error] = std::from_chars(first, last, value);
  if (end != last || error != std::errc() || !std::isfinite(value))
    throw UsageError(option + ": '" + text + "' is not a finite number");
  return value;
}

double parse_positive(const std::string& option, const std::string& text) {
  const double value = parse_number(option, text);
  if (!(value > 0)) throw UsageError(option + ": '" + text + "' should be above zero");
  return value;
}

double parse_not_negative(const std::string& option, const std::string& text) {
  const double value = parse_number(option, text);
  if (!(value >= 0)) throw UsageError(option + ": '" + text + "' should not be below zero");
  return value;
}

std::string fault_of_number(const std::string& text, double low, double high) {
  double value = 0;
  const char* const last = text.c_str() + text.size();
  const auto [end, error] = std::from_chars(text.c_str(), last, value);
  if (end == last && error == std::errc() && value >= low && value <= high) return {};
  const auto shortest = [](double bound) {
    char digits[40];
    return std::string(digits, std::to_chars(digits, digits + sizeof digits, bound).ptr);
  };
  return "'" + text + "' is not a number from " + shortest(low) + " to " + shortest(high);
}

std::optional<long> whole_number(const std::string& text) {
  long value = 0;
  const char* first = text.c_str();
  const char* const last = first + text.size();
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') ++first;
  const auto [end, error] = std::from_chars(first, last, value);
  if (end != last || error != std::errc()) return {};
  return value;
}

long parse_whole_number(const std::string& option, const std::string& text) {
  const std::optional<long> value = whole_number(text);
  if (!value) throw UsageError(option + ": '" + text + "' is not a whole number");
  return *value;
}

std::string fault_of_whole_number(const std::string& text, long low, long high) {
  const std::optional<long> value = whole_number(text);
  if (value && *value >= low && *value <= high) return {};
  return "'" + text + "' is not a whole number from " + std::to_string(low) + " to " + std::to_string(high);
}

std::pair<std::string, double> parse_named_number(const std::string& option, const std::string& text) {
  const std::size_t equals = text.rfind('=');
  if (equals == std::string::npos || equals == 0) throw UsageError(option + ": '" + text + "' should be NAME=NUMBER");
  return {text.substr(0, equals), parse_positive(option, text.substr(equals + 1))};
}

}  // namespace pliant
