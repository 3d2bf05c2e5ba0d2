// formats/picture/svg/frame.h: what stands around the drawing of a mesh: title, axes, and the line of keys below.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "formats/picture/svg.h"
#include "formats/picture/svg/placement.h"
#include "formats/picture/svg/theme.h"

namespace pliant {

/// One entry of the line below a picture: a sign and what it means.
struct Key {
  enum class Sign { bar, arrow, curve };
  Sign sign;
  double width;  ///< of the sign, in pixels
  std::string text;
};

/// Where the parts of a picture stand, in pixels from its upper left corner.
class Frame {
 public:
  /// Makes room for title, axes and the legend, whose width depends on the height of the drawing (0: there is none).
  /// A part for which there is no room is left out. `placement` tells the document's coordinates from those of the box.
  Frame(const SvgOptions& options, const Theme& theme, const Box& box, const Placement& placement,
        const std::function<double(double)>& legend_width);

  double width() const { return width_; }
  double left() const { return left_; }
  double top() const { return top_; }
  double drawn_width() const { return drawn_width_; }
  double drawn_height() const { return drawn_height_; }
  double pixel() const { return (box_.high.x - box_.low.x) / drawn_width_; }
  bool has_legend() const { return side_ > 0; }
  double legend_left() const { return width_ - side_; }
  double legend_height() const { return std::max(drawn_height_, min_height_); }
  const std::vector<std::string>& left_out() const { return left_out_; }

  /// A key for the scale bar: a round length of about a quarter of the drawing.
  Key scale_bar() const;
  /// Puts the keys below. Returns the height of the picture.
  double place_keys(std::vector<Key> keys);
  void write_title(std::string& out) const;
  void write_axes(std::string& out) const;
  void write_keys(std::string& out) const;

 private:
  struct Tick {
    double at;  ///< pixels from the left or upper end of the drawing
    std::string label;
  };
  struct PlacedKey {
    Key key;
    double x, y;
  };
  void fit(const std::function<double(double)>& legend_width);
  std::vector<Tick> x_ticks() const;
  std::vector<Tick> y_ticks() const;
  std::string axis_name(const char* letter) const;
  bool name_fits_beside() const;
  bool is_too_narrow() const;

  const SvgOptions& options_;
  const Theme& theme_;
  Box box_;
  Placement placement_;
  double width_, min_height_ = 0;
  bool axes_;
  double side_ = 0, left_ = 0, top_ = 0, drawn_width_ = 1, drawn_height_ = 1, keys_top_ = 0;
  std::vector<std::string> title_, left_out_;
  std::vector<PlacedKey> keys_;
};

}  // namespace pliant
