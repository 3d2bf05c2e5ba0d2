// formats/svg_import/path_data.cpp: the path data of an SVG path.
#include "formats/svg_import/path_data.h"

#include "formats/svg_import/scanner.h"

namespace pliant::svg {
namespace {

char upper(char c) { return 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

class PathReader {
 public:
  explicit PathReader(std::string_view d) : in_(d) {}

  Outline read() {
    in_.skip_space();
    while (!in_.at_end()) read_command();
    return std::move(out_);
  }

 private:
  /// Reads one letter and all groups of arguments behind it.
  void read_command() {
    const Scanner at_letter = in_;
    const char letter = in_.peek();
    const char command = upper(letter);
    if (out_.empty() && command != 'M') at_letter.fail("the path to start with M or m");
    if (letter == '\0' || std::string_view("MLHVCSQTAZ").find(command) == std::string_view::npos)
      at_letter.fail("a command, one of MLHVCSQTAZ or mlhvcsqtaz");
    in_.take(letter);
    relative_ = letter != command;
    in_.skip_space();
    if (command == 'Z') {
      out_.close();
      at_ = start_;
      last_ = 'Z';
      is_open_ = false;
      return;
    }
    char group = command;
    do {
      draw(group);
      last_ = group;
      if (group == 'M') group = 'L';  // pairs that follow the first one of a moveto are linetos
      in_.skip_space();
      // Behind a comma another group must follow.
      if (in_.take(',')) {
        in_.skip_space();
        if (!in_.at_number()) in_.fail("a number behind the comma");
      }
    } while (in_.at_number());
  }

  double number(const char* what) {
    const double value = in_.number(what);
    in_.skip_space();
    return value;
  }
  void comma() { in_.skip_comma(); }

  Point point(const char* what) {
    Point p;
    p.x = number(what);
    comma();
    p.y = number(what);
    return relative_ ? at_ + p : p;
  }

  void draw(char command) {
    if (command == 'M') {
      start_ = at_ = point("a coordinate");
      is_open_ = true;
      return out_.move(at_);
    }
    // A subpath that begins without a moveto, after a close, starts where the one before it started.
    if (!is_open_) out_.move(at_);
    is_open_ = true;
    switch (command) {
      case 'L':
        at_ = point("a coordinate");
        return out_.line(at_);
      case 'H':
        at_.x = (relative_ ? at_.x : 0) + number("a coordinate");
        return out_.line(at_);
      case 'V':
        at_.y = (relative_ ? at_.y : 0) + number("a coordinate");
        return out_.line(at_);
      case 'C':
      case 'S':
        return draw_cubic(command);
      case 'Q':
      case 'T':
        return draw_quadratic(command);
      default:
        return draw_arc();
    }
  }

  Point mirrored() const { return at_ + (at_ - control_); }

  void draw_cubic(char command) {
    Point q = at_;
    if (command == 'C') {
      q = point("a coordinate");
      comma();
    } else if (last_ == 'C' || last_ == 'S') {
      q = mirrored();
    }
    const Point r = point("a coordinate");
    comma();
    const Point p = point("a coordinate");
    out_.cubic(q, r, p);
    control_ = r;
    at_ = p;
  }

  void draw_quadratic(char command) {
    Point q = at_;
    if (command == 'Q') {
      q = point("a coordinate");
      comma();
    } else if (last_ == 'Q' || last_ == 'T') {
      q = mirrored();
    }
    const Point p = point("a coordinate");
    out_.quadratic(q, p);
    control_ = q;
    at_ = p;
  }

  void draw_arc() {
    const double rx = number("a radius");
    comma();
    const double ry = number("a radius");
    comma();
    const double turned = number("an angle");
    comma();
    const bool large = in_.flag("the flag 0 or 1");
    comma();
    const bool sweep = in_.flag("the flag 0 or 1");
    comma();
    const Point p = point("a coordinate");
    add_arc(out_, at_, rx, ry, turned, large, sweep, p);
    at_ = p;
  }

  Scanner in_;
  Outline out_;
  Point at_, start_, control_;
  char last_ = '\0';
  bool relative_ = false;
  bool is_open_ = false;  ///< is a subpath under way?
};

}  // namespace

Outline parse_path_data(std::string_view d) {
  if (d == "none") return {};
  return PathReader(d).read();
}

Outline parse_points(std::string_view points) {
  Outline out;
  Scanner in(points);
  in.skip_space();
  while (!in.at_end()) {
    Point p;
    p.x = in.number("a coordinate");
    in.skip_comma();
    p.y = in.number("a second coordinate of the point");
    in.skip_comma();
    if (out.empty())
      out.move(p);
    else
      out.line(p);
  }
  return out;
}

}  // namespace pliant::svg
