// formats/svg_import/scanner.cpp: SVG's small grammars: numbers, lengths, lists, transforms.
#include "formats/svg_import/scanner.h"

#include <array>
#include <charconv>
#include <cstdlib>
#include <numbers>
#include <vector>

#include "formats/document/characters.h"
#include "formats/svg_import/paint.h"

namespace pliant::svg {
namespace {

/// Sine and cosine of an angle in degrees. They are exact at multiples of 90, so that a quarter turn keeps
/// coordinates bit for bit.
Point direction(double degrees) {
  const double reduced = std::remainder(degrees, 360);
  if (reduced == 0) return {1, 0};
  if (reduced == 90) return {0, 1};
  if (reduced == -90) return {0, -1};
  if (std::abs(reduced) == 180) return {-1, 0};
  const double angle = reduced * (std::numbers::pi / 180);
  return {std::cos(angle), std::sin(angle)};
}

Affine transform_of(std::string_view name, const std::vector<double>& v, const Scanner& in) {
  const auto count = v.size();
  const auto need = [&](bool fits, const char* what) {
    if (!fits) in.fail(std::string(what) + " of " + std::string(name));
  };
  if (name == "matrix") {
    need(count == 6, "6 numbers");
    return {v[0], v[1], v[2], v[3], v[4], v[5]};
  }
  if (name == "translate") {
    need(count == 1 || count == 2, "1 or 2 numbers");
    return {1, 0, 0, 1, v[0], count == 2 ? v[1] : 0};
  }
  if (name == "scale") {
    need(count == 1 || count == 2, "1 or 2 numbers");
    return {v[0], 0, 0, count == 2 ? v[1] : v[0], 0, 0};
  }
  if (name == "rotate") {
    need(count == 1 || count == 3, "1 or 3 numbers");
    const Point u = direction(v[0]);
    const Affine turn{u.x, u.y, -u.y, u.x, 0, 0};
    if (count == 1) return turn;
    return Affine{1, 0, 0, 1, v[1], v[2]} * turn * Affine{1, 0, 0, 1, -v[1], -v[2]};
  }
  need(name == "skewX" || name == "skewY", "a transform");
  need(count == 1, "1 number");
  const double slope = std::tan(std::remainder(v[0], 180) * (std::numbers::pi / 180));
  return name == "skewX" ? Affine{1, 0, slope, 1, 0, 0} : Affine{1, slope, 0, 1, 0, 0};
}

}  // namespace

void Scanner::skip_space() {
  while (!at_end() && is_white(text_[next_])) ++next_;
}

void Scanner::skip_comma() {
  skip_space();
  if (take(',')) skip_space();
}

bool Scanner::take(char c) {
  if (at_end() || text_[next_] != c) return false;
  ++next_;
  return true;
}

std::string_view Scanner::word() {
  const std::size_t first = next_;
  while (!at_end() && is_letter(text_[next_])) ++next_;
  return text_.substr(first, next_ - first);
}

bool Scanner::at_number() const {
  std::size_t i = next_;
  const auto at = [&](std::size_t k) { return k < text_.size() ? text_[k] : '\0'; };
  if (at(i) == '+' || at(i) == '-') ++i;
  return is_digit(at(i)) || (at(i) == '.' && is_digit(at(i + 1)));
}

double Scanner::number(const char* what) {
  if (!at_number()) fail(what);
  if (text_[next_] == '+') ++next_;
  double value = 0;
  const auto [end, error] = std::from_chars(text_.data() + next_, text_.data() + text_.size(), value);
  const auto length = static_cast<std::size_t>(end - (text_.data() + next_));
  // A number too small for a double is read as 0 or nearly so; one that is too large is refused.
  if (error == std::errc::result_out_of_range)
    value = std::strtod(std::string(text_.substr(next_, length)).c_str(), nullptr);
  if (!std::isfinite(value)) fail(std::string(what) + " that is finite");
  next_ += length;
  return value;
}

bool Scanner::flag(const char* what) {
  if (take('0')) return false;
  if (take('1')) return true;
  fail(what);
}

void Scanner::fail(const std::string& what) const {
  std::string found = "the end";
  if (!at_end()) {
    found = "'";
    for (const char c : text_.substr(next_, 12)) found += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    // The quotation must not end inside a character of several bytes.
    while (next_ + 12 < text_.size() && (static_cast<unsigned char>(found.back()) & 0x80U) != 0) found.pop_back();
    found += "'";
  }
  throw SyntaxError(next_, "expected " + what + ", found " + found);
}

Length parse_length(std::string_view text) {
  Scanner in(text);
  in.skip_space();
  const double value = in.number("a length");
  if (in.take('%')) {
    in.skip_space();
    if (!in.at_end()) in.fail("the end of the length");
    return {value, Unit::percent};
  }
  struct Known {
    std::string_view name;
    double factor;
    Unit unit = Unit::user;
  };
  constexpr double half = 0.5;  // of the font's size: what CSS takes for ex and ch where no font is measured
  static constexpr std::array<Known, 18> units{{{"", 1},
                                                {"px", 1},
                                                {"pt", 96.0 / 72},
                                                {"pc", 16},
                                                {"mm", 96 / 25.4},
                                                {"cm", 96 / 2.54},
                                                {"in", 96},
                                                {"q", 96 / 101.6},
                                                {"em", 1, Unit::em},
                                                {"ex", half, Unit::em},
                                                {"ch", half, Unit::em},
                                                {"ic", 1, Unit::em},
                                                {"rem", 1, Unit::rem},
                                                {"rex", half, Unit::rem},
                                                {"vw", 1, Unit::vw},
                                                {"vh", 1, Unit::vh},
                                                {"vmin", 1, Unit::vmin},
                                                {"vmax", 1, Unit::vmax}}};
  const Scanner at_unit = in;
  const std::string_view unit = in.word();
  in.skip_space();
  if (in.at_end())
    for (const Known& known : units)
      if (is_same_word(known.name, unit)) return {value * known.factor, known.unit};
  at_unit.fail("one of the units px, pt, pc, mm, cm, in, Q, em, ex, ch, rem, vw, vh, vmin, vmax, % or none");
}

Affine parse_style_transform(std::string_view text) {
  std::string plain;  // the transform as an attribute would have it: numbers without units
  Scanner in(text);
  while (!in.at_end()) {
    if (in.at_number()) {
      double value = in.number("a number");
      Scanner before = in;
      const std::string_view unit = in.word();
      if (is_same_word(unit, "rad"))
        value *= 180 / std::numbers::pi;
      else if (is_same_word(unit, "grad"))
        value *= 0.9;
      else if (is_same_word(unit, "turn"))
        value *= 360;
      else if (!unit.empty() && !is_same_word(unit, "px") && !is_same_word(unit, "deg"))
        before.fail("one of the units px, deg, rad, grad or turn");
      char digits[32];
      const auto written = std::to_chars(digits, digits + sizeof digits, value);
      plain.append(digits, written.ptr);
    } else {
      plain += in.peek();
      in.take(in.peek());
    }
  }
  return parse_transform(plain);
}

Affine parse_transform(std::string_view text) {
  Affine product;
  Scanner in(text);
  in.skip_space();
  if (text.substr(in.offset()) == "none") return product;
  while (!in.at_end()) {
    const std::string_view name = in.word();
    if (name.empty()) in.fail("a transform");
    in.skip_space();
    if (!in.take('(')) in.fail("( behind " + std::string(name));
    std::vector<double> values;
    in.skip_space();
    while (in.at_number() && values.size() < 6) {
      values.push_back(in.number("a number"));
      in.skip_comma();
    }
    if (!in.take(')')) in.fail("a number or )");
    product = product * transform_of(name, values, in);
    in.skip_comma();
  }
  return product;
}

}  // namespace pliant::svg
