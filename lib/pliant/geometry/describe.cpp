// lib/pliant/geometry/describe.cpp: numbers and places in words, with as many digits as they need.
#include "pliant/geometry/describe.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace pliant {
namespace {

constexpr int enough_digits = 17;  // with as many, any two different doubles look different

std::string with_digits(double value, int digits) {
  std::array<char, 40> text;
  std::snprintf(text.data(), text.size(), "%.*g", digits, value);
  return text.data();
}

/// The fewest digits, at least `digits`, with which all different values look different.
int digits_for(std::vector<double> values, int digits) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  // Rounding keeps the order, so only neighbours can look the same.
  for (std::size_t k = 1; k < values.size(); ++k)
    while (digits < enough_digits && with_digits(values[k - 1], digits) == with_digits(values[k], digits)) ++digits;
  return digits;
}

}  // namespace

std::string describe_number(double value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return std::string(text.data(), end);
}

std::string describe_point(const Point& p) { return "(" + describe_number(p.x) + ", " + describe_number(p.y) + ")"; }

std::string describe_number(double value, double resolution) {
  if (!(std::fabs(value) >= resolution)) return "0";
  // The last digit is the one with the resolution's power of ten.
  const double digits = std::floor(std::log10(std::fabs(value))) - std::floor(std::log10(resolution)) + 1;
  if (!(digits < enough_digits)) return describe_number(value);
  return with_digits(value, static_cast<int>(digits));
}

std::string describe_point(const Point& p, double resolution) {
  return "(" + describe_number(p.x, resolution) + ", " + describe_number(p.y, resolution) + ")";
}

std::vector<std::string> describe_apart(std::span<const double> values, int digits) {
  digits = digits_for({values.begin(), values.end()}, digits);
  std::vector<std::string> texts;
  for (const double value : values) texts.push_back(with_digits(value, digits));
  return texts;
}

}  // namespace pliant
