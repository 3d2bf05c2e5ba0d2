// formats/picture/svg/frame.cpp: what stands around the drawing of a mesh: title, axes, and the line of keys below.
#include "formats/picture/svg/frame.h"

#include <algorithm>
#include <cmath>

#include "formats/picture/svg/arrows.h"
#include "formats/picture/svg/legend.h"
#include "formats/picture/svg/text.h"

namespace pliant {
namespace {

constexpr double title_font = 16, title_line = 20, font = 12, tick_font = 11, tick_length = 4, gap = 8;
constexpr double bottom_axis = 40;  // ticks, their labels and the name of the axis below the drawing
constexpr double key_row = 24, key_gap = 24;
constexpr double least_drawn = 0.35, least_pixels = 60;  // of the width, and at least so many, or something is left out
constexpr int most_labels = 1000;                        // at an axis, however tall the picture is
constexpr double least_key_width = 100;                  // of the room for keys

std::string group(std::string_view name, const Theme& theme, double size) {
  std::string text = "<g class=\"";
  text.append(name).append("\" font-family=\"").append(font_family).append("\" font-size=\"");
  return text.append(short_number(size)).append("\" fill=\"").append(hex(theme.text)).append("\">\n");
}

void write_key_arrow(const Point& tail, double length, const std::string& ink, std::string& out) {
  out += "<path class=\"key-arrow\" fill=\"" + ink + "\" d=\"";
  SvgPath path(out, 1000, 0, 1e-6);
  write_arrow(tail, tail + Vector{length, 0}, 1.3, path);
  out += "\"/>\n";
}

}  // namespace

Frame::Frame(const SvgOptions& options, const Theme& theme, const Box& box, const Placement& placement,
             const std::function<double(double)>& legend_width)
    : options_(options),
      theme_(theme),
      box_(box),
      placement_(placement),
      width_(options.width / options.scale),
      axes_(options.axes) {
  const std::string pixels = " for a picture " + short_number(options.width) + " pixels wide";
  fit(legend_width);
  if (is_too_narrow() && side_ > 0) {
    left_out_.push_back("the legend is too wide" + pixels);
    fit({});
  }
  if (is_too_narrow() && axes_) {
    left_out_.push_back("the axes are too wide" + pixels);
    axes_ = false;
    fit({});
  }
  if (!options.title.empty()) {
    title_ = wrapped(options.title, width_ - 2 * gap, title_font, true, 4);
    if (width_ < 4 * title_font) {
      left_out_.push_back("the title is too wide" + pixels);
      title_.clear();
    }
  }
  top_ = title_.empty() ? 0 : title_line * double(title_.size()) + 10;
  if (axes_) top_ = std::max(top_, gap) + (name_fits_beside() ? 0 : font + 6);
  keys_top_ = top_ + drawn_height_ + (axes_ ? bottom_axis : 0);
}

/// Shares the width between the axis, the drawing and the legend. Their widths depend on the height of the drawing,
/// which depends on its width: a few rounds, in which margins only grow.
void Frame::fit(const std::function<double(double)>& legend_width) {
  side_ = left_ = 0;
  double right = axes_ ? gap : 0;
  for (int round = 0; round < 4; ++round) {
    drawn_width_ = std::max(1.0, width_ - left_ - side_ - right);
    drawn_height_ = (box_.high.y - box_.low.y) / pixel();
    if (legend_width) side_ = std::max(side_, legend_width(std::max(drawn_height_, min_legend_height)));
    if (!axes_) continue;
    double label = 0;
    for (const Tick& tick : y_ticks()) label = std::max(label, text_width(tick.label, tick_font));
    left_ = std::max(left_, label + tick_length + 4 + (name_fits_beside() ? font + 8 : 4));
  }
  drawn_width_ = std::max(1.0, width_ - left_ - side_ - right);
  drawn_height_ = (box_.high.y - box_.low.y) / pixel();
  min_height_ = side_ > 0 ? min_legend_height : 0;
}

bool Frame::is_too_narrow() const { return drawn_width_ < std::max(least_drawn * width_, least_pixels); }

std::string Frame::axis_name(const char* letter) const {
  return options_.unit.empty() ? letter : letter + (" (" + options_.unit + ")");
}

bool Frame::name_fits_beside() const { return text_width(axis_name("y"), font) <= drawn_height_; }

std::vector<Frame::Tick> Frame::x_ticks() const {
  const ValueRange range{placement_.in_document(box_.low).x, placement_.in_document(box_.high).x};
  std::vector<Tick> result;
  for (int count = std::max(1, static_cast<int>(drawn_width_ / 60)); count > 0; --count) {
    const std::vector<double> values = ticks(range, count);
    const std::vector<std::string> labels = tick_labels(values);
    result.clear();
    double free = -left_;  // where the next label may begin
    bool all = true;
    for (std::size_t k = 0; k < values.size(); ++k) {
      const double at = drawn_width_ * std::clamp(range.place(values[k]), 0.0, 1.0);
      const double half = text_width(labels[k], tick_font) / 2;
      const bool fits = at - half >= free && at + half <= width_ - left_ - side_;
      if (fits) {
        result.push_back({at, labels[k]});
        free = at + half + gap;
      }
      // A label that would leave the picture at its side is left out; others that do not fit ask for fewer ticks.
      all = all && (fits || at + half > width_ - left_ - side_ || at - half < -left_);
    }
    if (all) break;
  }
  return result;
}

std::vector<Frame::Tick> Frame::y_ticks() const {
  const ValueRange range{placement_.in_document(box_.low).y, placement_.in_document(box_.high).y};
  std::vector<Tick> result;
  const std::vector<double> values =
      ticks(range, static_cast<int>(std::clamp(drawn_height_ / 40, 1.0, double(most_labels))));
  const std::vector<std::string> labels = tick_labels(values);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double at = drawn_height_ * (1 - std::clamp(range.place(values[k]), 0.0, 1.0));
    if (result.empty() || result.back().at - at >= tick_font + 2) result.push_back({at, labels[k]});
  }
  return result;
}

Key Frame::scale_bar() const {
  const double most = 0.3 * (box_.high.x - box_.low.x) * placement_.unit;
  const double power = std::pow(10, std::floor(std::log10(most)));
  double length = power;
  for (const double nice : {2.0, 5.0})
    if (nice * power <= most) length = nice * power;
  return {Key::Sign::bar, length / placement_.unit / pixel(),
          short_number(length) + (options_.unit.empty() ? "" : " " + options_.unit)};
}

double Frame::place_keys(std::vector<Key> keys) {
  double bottom = std::max(keys_top_, top_ + legend_height());
  if (keys.empty()) return std::ceil(bottom);
  const double right = width_ - side_ - gap;
  if (right - left_ < least_key_width) {
    left_out_.push_back("the line of keys is too wide for a picture " + short_number(options_.width) + " pixels wide");
    return std::ceil(bottom);
  }
  double x = left_ + gap, y = keys_top_ + gap;
  for (Key& key : keys) {
    // A text that is too wide for the line is broken into several.
    const double text_left = key.width + gap;
    const std::string text = key.text;
    const double whole = text_left + text_width(text, font);
    if (x > left_ + gap && x + whole > right) x = left_ + gap, y += key_row;
    const double room = std::max(right - x - text_left, 4 * font);
    const std::vector<std::string> lines = wrapped(text, room, font, false, 3);
    for (std::size_t k = 0; k < lines.size(); ++k) {
      keys_.push_back({{key.sign, k == 0 ? key.width : 0, lines[k]}, x + (k == 0 ? 0 : key.width), y});
      if (k + 1 < lines.size()) y += key_row - 6;
    }
    x += whole + key_gap;
    if (lines.size() > 1) x = right;
  }
  return std::ceil(std::max(bottom, y + key_row));
}

void Frame::write_title(std::string& out) const {
  if (title_.empty()) return;
  out += group("title", theme_, title_font);
  double y = title_line;
  for (const std::string& line : title_) {
    write_text(out, width_ / 2, y, " text-anchor=\"middle\" font-weight=\"600\" fill=\"" + hex(theme_.ink) + "\"",
               line);
    y += title_line;
  }
  out += "</g>\n";
}

void Frame::write_axes(std::string& out) const {
  if (!axes_) return;
  const double bottom = top_ + drawn_height_;
  out += group("axes", theme_, tick_font);
  std::string lines = "M" + short_number(left_) + " " + short_number(top_) + "h" + short_number(drawn_width_) + "v" +
                      short_number(drawn_height_) + "h" + short_number(-drawn_width_) + "Z";
  const std::vector<Tick> along_x = x_ticks(), along_y = y_ticks();
  for (const Tick& tick : along_x)
    lines += "M" + short_number(left_ + tick.at) + " " + short_number(bottom) + "v" + short_number(tick_length);
  for (const Tick& tick : along_y)
    lines += "M" + short_number(left_) + " " + short_number(top_ + tick.at) + "h" + short_number(-tick_length);
  out += "<path fill=\"none\" stroke=\"" + hex(theme_.faint) + "\" stroke-width=\"" + short_number(theme_.line) +
         "\" d=\"" + lines + "\"/>\n";
  for (const Tick& tick : along_x)
    write_text(out, left_ + tick.at, bottom + tick_length + 11, " text-anchor=\"middle\"", tick.label);
  for (const Tick& tick : along_y)
    write_text(out, left_ - tick_length - 4, top_ + tick.at + 4, " text-anchor=\"end\"", tick.label);
  const std::string size = " font-size=\"" + short_number(font) + "\"";
  const std::string x_name = shortened(axis_name("x"), std::max(drawn_width_, 2 * font), font);
  write_text(out, left_ + drawn_width_ / 2, bottom + 32, size + " text-anchor=\"middle\"", x_name);
  const std::string y_name = axis_name("y");
  if (name_fits_beside())
    out += "<text transform=\"translate(" + short_number(font) + " " + short_number(top_ + drawn_height_ / 2) +
           ") rotate(-90)\"" + size + " text-anchor=\"middle\">" + escape_xml(y_name) + "</text>\n";
  else
    write_text(out, 4, top_ - 8, size, shortened(y_name, width_ - side_ - gap, font));
  out += "</g>\n";
}

void Frame::write_keys(std::string& out) const {
  if (keys_.empty()) return;
  out += group("keys", theme_, font);
  const std::string ink = hex(theme_.ink);
  for (const PlacedKey& each : keys_) {
    const double w = each.key.width, y = each.y + 8;
    if (w > 0) {
      const std::string from = "M" + short_number(each.x) + " " + short_number(y);
      if (each.key.sign == Key::Sign::bar)
        out += "<path class=\"scale-bar\" fill=\"none\" stroke=\"" + ink + "\" stroke-width=\"1.5\" d=\"" + from + "h" +
               short_number(w) + "m0 -4v8m" + short_number(-w) + " 0v-8\"/>\n";
      else if (each.key.sign == Key::Sign::curve)
        out += "<path fill=\"none\" stroke=\"" + ink + "\" stroke-width=\"1.4\" d=\"" + from + "h" + short_number(w) +
               "\"/>\n";
      else
        write_key_arrow({each.x, -y}, w, ink, out);
    }
    write_text(out, each.x + w + gap, y + 4, "", each.key.text);
  }
  out += "</g>\n";
}

}  // namespace pliant
