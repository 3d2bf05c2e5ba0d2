// tools/measure/requests.h: what a command line asks to measure, as read from its texts.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "pliant/geometry/point.h"

namespace pliant {

/// "[COLUMN=]WHAT" or "[COLUMN=]WHAT(ARGUMENT)".
struct QuantityRequest {
  std::string column;    ///< empty: named after place and text
  std::string what;      ///< of places the field or expression
  std::string argument;  ///< a field or an expression; empty: none
  std::string text;      ///< without COLUMN=
};

/// "[NAME=]WHERE:QUANTITY[,QUANTITY...]".
struct PlaceRequest {
  enum class Kind { point, face, curve } kind = Kind::point;
  std::string prefix;  ///< of its columns
  std::string target;  ///< the name of the face or curve
  Point place;         ///< of a point
  std::vector<QuantityRequest> quantities;
  std::string source;  ///< the text of the option
  std::string text;    ///< with the option in front, for messages
};

/// "[NAME=]X0,Y0:X1,Y1:N:FIELD[,FIELD...]".
struct LineRequest {
  std::string name;
  Point from, to;
  int samples = 2;
  std::vector<QuantityRequest> quantities;
  std::string text;
};

/// The texts of an option; `number` counts the requests of its kind from 1, for a name where none is given.
/// Throws      UsageError that opens with the option and the text
PlaceRequest parse_point(const std::string& text, int number);
/// A face or a curve is what stands before the first colon. Where names are given, one of these may have colons and
/// more of what else would mean something: the longest that fits is taken.
PlaceRequest parse_region(PlaceRequest::Kind kind, const std::string& text, const std::vector<std::string>& names = {});
LineRequest parse_line(const std::string& text, int number);
/// NAME=REST of --value and --set, where NAME can be used in expressions.
std::pair<std::string, std::string> parse_named(const std::string& option, const std::string& text);

/// The text with all that no name in an expression may contain replaced by "_".
std::string as_name(const std::string& text);

}  // namespace pliant
