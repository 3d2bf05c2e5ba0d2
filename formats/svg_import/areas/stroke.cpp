// formats/svg_import/areas/stroke.cpp: the area that a stroke paints, as outlines.
#include "formats/svg_import/areas/stroke.h"

#include <algorithm>
#include <numbers>

#include "formats/svg_import/areas/stroke_parts.h"
#include "pliant/boundary/fault.h"

namespace pliant::svg {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double smooth_join = 1e-7;      // in radians: parts that join under a smaller angle are one smooth run
constexpr int most_stroke_halvings = 40;  // of a curve beside a part
constexpr double safety = 2;              // samples of a distance may miss its greatest value by so much

Vector left_of(const Vector& v) { return {-v.y, v.x}; }

/// Makes the loops of one outline. Where the curve bends more than the half width allows, the points on its normals run
/// backwards behind the centre of curvature. There the loop beside the curve ends at the centres of curvature, and
/// another loop, in the other direction, has what lies behind them: so all windings have the same sign.
class Stroker {
 public:
  Stroker(const StrokeStyle& style, double tolerance) : style_(style), half_(style.width / 2), tolerance_(tolerance) {
    if (!style_.dashes.empty()) find_first_dash();
  }

  Outline area(const Outline& path) {
    for (const StrokePath& one : stroke_paths(path)) {
      if (one.parts.empty())
        add_dot(one.start);
      else if (style_.dashes.empty())
        add_path(split(one.parts), one.is_closed);
      else
        add_dashes(one);
    }
    return std::move(out_);
  }

 private:
  using Parts = std::vector<StrokePart>;

  // ---- The path ----

  /// Cuts parts where they stop, and where their radius of curvature is half the width: on each side a part is folded
  /// all along, or nowhere.
  Parts split(const Parts& parts) const {
    Parts result;
    for (const StrokePart& part : parts) {
      std::vector<double> cuts;
      part.add_events(half_, cuts);
      const double first = part.first(), span = part.last() - first;
      const auto share = [&](double t) { return (t - first) / span; };
      std::sort(cuts.begin(), cuts.end(), [&](double a, double b) { return share(a) < share(b); });
      double done = first;
      for (const double t : cuts) {
        constexpr double least = 1e-6;
        if (share(t) < share(done) + least || share(t) > 1 - least) continue;
        result.push_back(part.between(done, t));
        done = t;
      }
      result.push_back(done == first ? part : part.between(done, part.last()));
    }
    return result;
  }

  static Vector start_of(const StrokePart& part) { return part.tangent(part.first()); }
  static Vector end_of(const StrokePart& part) { return part.tangent(part.last()); }
  static double turn(const Vector& from, const Vector& to) { return std::atan2(cross(from, to), dot(from, to)); }

  void add_path(const Parts& parts, bool is_closed) {
    const std::size_t count = parts.size();
    const auto is_smooth = [&](std::size_t i) {  // the join before part i
      return std::abs(turn(end_of(parts[(i + count - 1) % count]), start_of(parts[i]))) < smooth_join;
    };
    std::size_t begin = 0;
    if (is_closed) {
      while (begin < count && is_smooth(begin)) ++begin;
      if (begin == count) return add_ring(parts);
    }
    for (std::size_t i = begin; i < begin + count;) {
      std::size_t end = i + 1;
      while (end < begin + count && is_smooth(end % count)) ++end;
      Parts run;
      for (std::size_t k = i; k < end; ++k) run.push_back(parts[k % count]);
      add_run(run);
      if (end < begin + count || is_closed) add_join(run.back(), parts[end % count]);
      i = end;
    }
    if (is_closed) return;
    add_cap(parts.front().at(parts.front().first()), -1 * start_of(parts.front()));
    add_cap(parts.back().at(parts.back().last()), end_of(parts.back()));
  }

  /// Finds the dash or gap in which every subpath starts, and how much of it is left there.
  void find_first_dash() {
    for (const double dash : style_.dashes) period_ += dash;
    double done = std::fmod(style_.dash_offset, period_);
    if (done < 0) done += period_;
    // A dash of no length at the very start is a dot there.
    const auto is_dot = [&] { return done == 0 && style_.dashes[first_dash_] == 0 && first_dash_ % 2 == 0; };
    while (done >= style_.dashes[first_dash_] && !is_dot()) {
      done -= style_.dashes[first_dash_];
      first_dash_ = (first_dash_ + 1) % style_.dashes.size();
    }
    first_left_ = style_.dashes[first_dash_] - done;
  }

  void add_dashes(const StrokePath& path) {
    std::vector<double> lengths;
    double total = 0;
    for (const StrokePart& part : path.parts) {
      lengths.push_back(part.length(part.first(), part.last()));
      total += lengths.back();
    }
    dashes_ += total / period_ * static_cast<double>(style_.dashes.size());
    if (!(dashes_ <= static_cast<double>(most_dashes)))
      throw InputError(
          "", "a stroke has more than " + std::to_string(most_dashes) + " dashes; give it longer ones, or none");
    std::size_t dash = first_dash_;
    double left = first_left_;
    Parts run, first_run;
    bool starts_on = dash % 2 == 0, is_first = true;
    const auto finish = [&] {
      if (is_first && starts_on && path.is_closed)
        first_run = run;  // it may go on from the path's end
      else if (!run.empty())
        add_path(split(run), false);
      is_first = false;
      run.clear();
    };
    for (std::size_t p = 0; p < path.parts.size(); ++p) {
      const StrokePart& part = path.parts[p];
      double t = part.first(), rest = lengths[p];
      while (left < rest) {
        const double cut = parameter(part, t, left);
        if (dash % 2 == 0) {
          if (left > 0) run.push_back(part.between(t, cut));
          if (run.empty() && style_.dashes[dash] == 0) add_dash_dot(part, cut);
          finish();
        }
        rest -= left;
        t = cut;
        dash = (dash + 1) % style_.dashes.size();
        left = style_.dashes[dash];
      }
      left -= rest;
      if (dash % 2 == 0) run.push_back(part.between(t, part.last()));
    }
    if (is_first && dash % 2 == 0 && path.is_closed) return add_path(split(path.parts), true);  // one dash all round
    if (dash % 2 == 0 || !run.empty())
      run.insert(run.end(), first_run.begin(), first_run.end());
    else
      run = first_run;
    if (!run.empty()) add_path(split(run), false);
  }

  /// The parameter at a length behind t.
  static double parameter(const StrokePart& part, double t, double length) {
    double low = t, high = part.last();
    for (int i = 0; i < 50; ++i) {
      const double middle = low + (high - low) / 2;
      (part.length(t, middle) < length ? low : high) = middle;
    }
    return high;
  }

  // ---- Loops ----

  /// Where the area beside the curve ends: at the half width, or at the centre of curvature before it.
  Point beside(const StrokePart& part, double t, double side) const {
    return is_folded(part, side) ? centre(part, t, side) : offset(part, t, side);
  }
  Point offset(const StrokePart& part, double t, double side) const {
    return part.at(t) + side * half_ * left_of(part.tangent(t));
  }
  bool is_folded(const StrokePart& part, double side) const {
    return side * part.curvature((part.first() + part.last()) / 2) * half_ > 1 + 1e-9;
  }

  void line(const Point& p) {
    if (!(p == at_)) out_.line(at_ = p);
  }
  void move(const Point& p) { out_.move(at_ = p); }

  /// Follows a curve given by its points: cubics with its derivatives at their ends, as long as samples say so.
  template <class Curve>
  void follow(const Curve& curve, double from, double to, int depth = 0) {
    const Point p = curve(from), q = curve(to);
    const double d = to - from;
    const auto slope = [&](double t, double inwards) {  // one-sided differences of the fourth order
      const double h = inwards * d / 64;
      return (-25.0 / 12 * curve(t) + 4.0 * curve(t + h) - 3.0 * curve(t + 2 * h) + 4.0 / 3 * curve(t + 3 * h) -
              0.25 * curve(t + 4 * h)) /
             h;
    };
    const Point a = p + (d / 3) * slope(from, 1), b = q - (d / 3) * slope(to, -1);
    double worst = 0;
    constexpr int parts = 8;
    for (int i = 1; i < parts; ++i) {
      const double s = static_cast<double>(i) / parts, r = 1 - s;
      const Point fit = r * r * r * p + 3 * r * r * s * a + 3 * r * s * s * b + s * s * s * q;
      worst = std::max(worst, distance(fit, curve(from + s * d)));
    }
    if (worst * safety <= tolerance_ || depth >= most_stroke_halvings) {
      if (++offsets_ > most_offsets)
        throw InputError("", "the outline of a stroke needs more than " + std::to_string(most_offsets) +
                                 " curves; a greater --tolerance takes fewer");
      if (std::max(distance(p, q), std::max(distance(p, a), distance(p, b))) <= tolerance_ / 64) return line(q);
      line(p);
      out_.cubic(a, b, at_ = q);
      return;
    }
    const double middle = from + d / 2;
    follow(curve, from, middle, depth + 1);
    follow(curve, middle, to, depth + 1);
  }

  /// Goes along one side of a part, in its direction or against it.
  void side_of(const StrokePart& part, double side, bool backwards) {
    const double from = backwards ? part.last() : part.first(), to = backwards ? part.first() : part.last();
    line(beside(part, from, side));
    if (part.is_line()) return line(beside(part, to, side));
    if (is_folded(part, side))
      follow([&](double t) { return centre(part, t, side); }, from, to);
    else
      follow([&](double t) { return offset(part, t, side); }, from, to);
    line(beside(part, to, side));
  }
  /// The centre of curvature, no farther away than the half width. At a stop it is the place itself.
  Point centre(const StrokePart& part, double t, double side) const {
    const double bend = std::abs(part.curvature(t));
    const double reach = bend == 0 ? 0 : std::min(1 / bend, half_);
    return part.at(t) + side * reach * left_of(part.tangent(t));
  }

  void add_folds(const Parts& parts) {
    for (const StrokePart& part : parts)
      for (const double side : {-1.0, 1.0}) {
        if (part.is_line() || !is_folded(part, side)) continue;
        const double from = part.first(), to = part.last();
        // Behind the centres of curvature the offset curve runs backwards. On the left the loop follows the part
        // backwards, so that it winds in the same direction as all others.
        const bool backwards = side < 0;
        move(backwards ? offset(part, to, side) : offset(part, from, side));
        follow([&](double t) { return offset(part, t, side); }, backwards ? to : from, backwards ? from : to);
        line(beside(part, backwards ? from : to, side));
        follow([&](double t) { return centre(part, t, side); }, backwards ? from : to, backwards ? to : from);
        out_.close();
      }
  }

  void add_run(const Parts& parts) {
    move(beside(parts.front(), parts.front().first(), -1));
    for (const StrokePart& part : parts) side_of(part, -1, false);
    line(parts.back().at(parts.back().last()));
    for (auto part = parts.rbegin(); part != parts.rend(); ++part) side_of(*part, 1, true);
    line(parts.front().at(parts.front().first()));
    out_.close();
    add_folds(parts);
  }

  void add_ring(const Parts& parts) {
    move(beside(parts.front(), parts.front().first(), -1));
    for (const StrokePart& part : parts) side_of(part, -1, false);
    out_.close();
    move(beside(parts.back(), parts.back().last(), 1));
    for (auto part = parts.rbegin(); part != parts.rend(); ++part) side_of(*part, 1, true);
    out_.close();
    add_folds(parts);
  }

  void arc(const Point& center, const Vector& from, double sweep, const Point& end) {
    constexpr double quarter = pi / 2;
    const int count = std::max(1, static_cast<int>(std::ceil(sweep / quarter - 1e-9)));
    const double start = std::atan2(from.y, from.x);
    for (int i = 1; i <= count; ++i) {
      const double t0 = start + sweep * (i - 1) / count, t1 = start + sweep * i / count;
      at_ = i == count ? end : center + half_ * Vector{std::cos(t1), std::sin(t1)};
      out_.arc(center, {half_, 0}, {0, half_}, t0, t1 - t0, at_);
    }
  }

  void add_join(const StrokePart& before, const StrokePart& after) {
    const Vector in = end_of(before), out = start_of(after);
    double angle = turn(in, out);
    if (std::abs(angle) < smooth_join) return;
    const Point p = after.at(after.first());
    // The outer side is on the right of a left turn; the wedge goes round counter-clockwise from `from` to `to`.
    const bool is_left = angle > 0;
    const Vector from = is_left ? -half_ * left_of(in) : half_ * left_of(out);
    const Vector to = is_left ? -half_ * left_of(out) : half_ * left_of(in);
    angle = std::abs(angle);
    move(p);
    line(p + from);
    if (style_.join == LineJoin::round) {
      arc(p, from, angle, p + to);
    } else {
      const double cosine = std::cos(angle / 2);
      if (style_.join == LineJoin::miter && cosine > 0 && 1 / cosine <= style_.miter_limit)
        line(p + (from + to) / (2 * cosine * cosine));
      line(p + to);
    }
    out_.close();
  }

  /// The cap at p, where the curve goes on in the direction `ahead`.
  void add_cap(const Point& p, const Vector& ahead) {
    if (style_.cap == LineCap::butt) return;
    const Vector right = -half_ * left_of(ahead), reach = half_ * ahead;
    move(p);
    line(p + right);
    if (style_.cap == LineCap::round) {
      arc(p, right, pi, p - right);
    } else {
      line(p + right + reach);
      line(p - right + reach);
      line(p - right);
    }
    out_.close();
  }

  void add_dot(const Point& p, const Vector& along = {1, 0}) {
    add_cap(p, along);
    add_cap(p, -1 * along);
  }
  void add_dash_dot(const StrokePart& part, double t) { add_dot(part.at(t), part.tangent(t)); }

  const StrokeStyle& style_;
  double half_, tolerance_;
  double period_ = 0, first_left_ = 0;
  std::size_t first_dash_ = 0;
  double dashes_ = 0;  ///< number of dashes and gaps of the subpaths so far
  Outline out_;
  Point at_;
  long offsets_ = 0;
};

}  // namespace

Outline stroke_area(const Outline& path, const StrokeStyle& style, double tolerance) {
  return Stroker(style, tolerance).area(path);
}

}  // namespace pliant::svg
