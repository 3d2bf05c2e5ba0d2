// formats/svg_import/scanner.h: SVG's small grammars: numbers, lengths, lists, transforms.
#pragma once
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "formats/svg_import/affine.h"

namespace pliant::svg {

/// What was expected, and where in an attribute's value.
class SyntaxError : public std::runtime_error {
 public:
  SyntaxError(std::size_t offset, const std::string& text) : std::runtime_error(text), offset_(offset) {}
  std::size_t offset() const { return offset_; }

 private:
  std::size_t offset_;
};

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  bool at_end() const { return next_ == text_.size(); }
  char peek() const { return at_end() ? '\0' : text_[next_]; }
  std::size_t offset() const { return next_; }
  void skip_space();
  /// White space, and one comma in it.
  void skip_comma();
  /// Passes `c` if it is next.
  bool take(char c);
  /// Passes letters (none if there are none).
  std::string_view word();
  /// A number starts here.
  bool at_number() const;
  /// Throws      SyntaxError unless a finite number stands here; `what` says what it is
  double number(const char* what);
  /// 0 or 1, one character: "a1 1 0 00.5.5" is legal.
  bool flag(const char* what);
  /// Throws SyntaxError: "expected WHAT, found ...".
  [[noreturn]] void fail(const std::string& what) const;

 private:
  std::string_view text_;
  std::size_t next_ = 0;
};

/// What a length is counted in: user units, percent, sizes of the font (of the element, of the root), percent of the
/// window.
enum class Unit { user, percent, em, rem, vw, vh, vmin, vmax };
struct Length {
  double value = 0;  ///< user units (96 to the inch), or as many of the unit
  Unit unit = Unit::user;
};

/// "12", "3.5mm", "50%", "2em". Throws SyntaxError.
Length parse_length(std::string_view text);
/// The matrix of a transform attribute: the product of its list. Throws SyntaxError.
Affine parse_transform(std::string_view text);
/// The same of a style, where lengths are in px and angles have units. Throws SyntaxError.
Affine parse_style_transform(std::string_view text);

}  // namespace pliant::svg
