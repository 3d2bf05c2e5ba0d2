// formats/svg_import/scanner.h: SVG's small grammars: numbers, lengths, lists, transforms.
#pragma once
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "formats/svg_import/affine.h"

namespace pliant::svg {

/// A fault in an attribute's value: what was expected, and at which offset.
class SyntaxError : public std::runtime_error {
 public:
  SyntaxError(std::size_t offset, const std::string& text) : std::runtime_error(text), offset_(offset) {}
  std::size_t offset() const { return offset_; }

 private:
  std::size_t offset_;
};

/// The white space of SVG and CSS.
constexpr bool is_white(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  bool at_end() const { return next_ == text_.size(); }
  char peek() const { return at_end() ? '\0' : text_[next_]; }
  std::size_t offset() const { return next_; }
  void skip_space();
  /// Passes white space with at most one comma in it.
  void skip_comma();
  /// Passes `c` if it is next.
  bool take(char c);
  /// Passes letters (none if there are none).
  std::string_view word();
  /// Does a number start here?
  bool at_number() const;
  /// Reads a number.
  /// Throws      SyntaxError unless a finite number stands here; `what` says in the message what it would be
  double number(const char* what);
  /// Reads a flag: the one character 0 or 1, so that "a1 1 0 00.5.5" is legal.
  bool flag(const char* what);
  /// Throws SyntaxError: "expected WHAT, found ...".
  [[noreturn]] void fail(const std::string& what) const;

 private:
  std::string_view text_;
  std::size_t next_ = 0;
};

/// What a length is counted in: user units; percent; font sizes of the element (em) or of the root (rem); percent of
/// the window's width, height, smaller or larger side.
enum class Unit { user, percent, em, rem, vw, vh, vmin, vmax };
struct Length {
  double value = 0;  ///< how many of the unit; user units are 96 to the inch
  Unit unit = Unit::user;
};

/// Reads a length such as "12", "3.5mm", "50%" or "2em". Throws SyntaxError.
Length parse_length(std::string_view text);
/// The matrix of a transform attribute: the product of its list. Throws SyntaxError.
Affine parse_transform(std::string_view text);
/// The same for a transform in a style, where lengths are in px and angles have units. Throws SyntaxError.
Affine parse_style_transform(std::string_view text);

}  // namespace pliant::svg
