// formats/svg_import/areas/loops.cpp: the closed loops that bound a filled shape, as B-splines.
#include "formats/svg_import/areas/loops.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "formats/svg_import/areas/subpaths.h"

namespace pliant::svg {
namespace {

constexpr double loop_gap = 1e-12;     // gap, as a part of the drawing's size, that sums of decimals leave
constexpr double exact_join = 1e-13;   // how far a join of exact pieces may move, as a part of the drawing's size
constexpr double smooth_angle = 1e-3;  // in radians: a greater turn is a corner, however short its legs are
constexpr double most_stretch = 16;    // of a knot span over its piece's length; beyond it ratios start anew
constexpr double cusp_angle = 1e-7;    // in radians: a curve that turns back to within this angle has a cusp

Piece elevated(const Piece& piece, int degree) {
  Piece out = piece;
  for (; out.degree < degree; ++out.degree) {
    const Piece low = out;
    const auto p = static_cast<std::size_t>(low.degree);
    out.points[p + 1] = low.points[p];
    for (std::size_t i = p; i > 0; --i) {
      const double share = static_cast<double>(i) / static_cast<double>(p + 1);
      out.points[i] = share * low.points[i - 1] + (1 - share) * low.points[i];
    }
  }
  return out;
}

double polygon_length(const Piece& piece) {
  double sum = 0;
  for (int i = 0; i < piece.degree; ++i)
    sum += distance(piece.points[static_cast<std::size_t>(i)], piece.points[static_cast<std::size_t>(i) + 1]);
  return sum;
}

enum class Join { corner, smooth, cusp };

/// Makes the B-splines of one loop of pieces, all of one degree p.
class LoopBuilder {
 public:
  LoopBuilder(std::vector<Piece> pieces, bool is_open, const LoopOptions& options, LoopCounts& counts)
      : pieces_(std::move(pieces)), is_open_(is_open), options_(options), counts_(counts), p_(pieces_.front().degree) {}

  Loop build() {
    counts_.pieces += static_cast<long>(pieces_.size());
    for (const Piece& piece : pieces_) counts_.fitted += piece.fitted ? 1 : 0;
    if (p_ == 1 && !is_open_) return polygon();
    classify();
    if (is_open_) {
      choose_knots();
      return open_curves();
    }
    // The loop starts in a cusp, or else in a corner.
    const auto starts_with = [&](Join kind) { return std::find(joins_.begin(), joins_.end(), kind); };
    auto start = starts_with(Join::cusp);
    if (start == joins_.end()) start = starts_with(Join::corner);
    if (start == joins_.end()) start = joins_.begin();
    std::rotate(pieces_.begin(), pieces_.begin() + (start - joins_.begin()), pieces_.end());
    std::rotate(joins_.begin(), start, joins_.end());
    choose_knots();
    if (auto closed = closed_curve()) return std::move(*closed);
    return open_curves();
  }

 private:
  std::size_t count() const { return pieces_.size(); }
  const Point& behind(std::size_t i) const { return pieces_[i].points[1]; }                                 // the start
  const Point& before(std::size_t i) const { return pieces_[i].points[static_cast<std::size_t>(p_) - 1]; }  // the end
  std::size_t previous(std::size_t i) const { return (i + count() - 1) % count(); }

  /// A polygon as a curve of degree 1, which may turn at its simple knots.
  Loop polygon() {
    counts_.corners += static_cast<long>(count());
    std::vector<double> knots{0};
    std::vector<Point> points;
    for (const Piece& piece : pieces_) {
      knots.push_back(later(knots.back(), polygon_length(piece)));
      points.push_back(piece.end());
    }
    return {{BSpline(1, true, std::move(knots), std::move(points))}, {false}};
  }

  static double later(double knot, double by) { return std::max(knot + by, std::nextafter(knot, HUGE_VAL)); }

  /// How far the join moves if it becomes a smooth knot, where the control points beside it and the spans a and b
  /// determine its place.
  double displacement(std::size_t i, double a, double b) const {
    const std::size_t j = previous(i);
    const Vector in = pieces_[i].start() - before(j), out = behind(i) - pieces_[i].start();
    return length(a * out - b * in) / (a + b);
  }

  double allowed(std::size_t i) const {
    return pieces_[i].fitted || pieces_[previous(i)].fitted ? options_.tolerance / 2 : exact_join * options_.size;
  }

  void classify() {
    joins_.assign(count(), Join::corner);
    for (std::size_t i = is_open_ ? 1 : 0; i < count(); ++i) {
      const Vector in = pieces_[i].start() - before(previous(i)), out = behind(i) - pieces_[i].start();
      const double a = length(in), b = length(out);
      if (!(a > 0 && b > 0)) continue;
      const double sine = std::abs(cross(in, out)) / a / b;
      if (dot(in, out) < 0)
        joins_[i] = sine < cusp_angle ? Join::cusp : Join::corner;
      else if (p_ > 1 && sine < smooth_angle && displacement(i, a, b) <= allowed(i))
        joins_[i] = Join::smooth;
    }
  }

  /// Chooses the knot spans: at smooth joins in the ratio of the legs; elsewhere, and where these ratios have led too
  /// far from the lengths of the pieces, as these lengths.
  void choose_knots() {
    knots_.assign(1, 0);
    double span = 0;
    for (std::size_t i = 0; i < count(); ++i) {
      const double natural = polygon_length(pieces_[i]);
      if (i > 0 && joins_[i] == Join::smooth) {
        const double a = distance(pieces_[i].start(), before(i - 1)), b = distance(pieces_[i].start(), behind(i));
        span *= b / a;
        if (!(span <= most_stretch * natural && natural <= most_stretch * span)) {
          span = natural;
          joins_[i] = Join::corner;
        }
      } else {
        span = natural;
      }
      knots_.push_back(later(knots_.back(), span));
      if (i > 0 && joins_[i] == Join::smooth) check_join(i, knots_[i] - knots_[i - 1], knots_[i + 1] - knots_[i]);
    }
  }

  /// Makes a corner of each smooth join that the rounded knots do not keep in its place.
  bool check_join(std::size_t i, double a, double b) {
    const double moved = displacement(i, a, b);
    if (moved <= allowed(i))
      moved_ = std::max(moved_, moved);
    else
      joins_[i] = Join::corner;
    return joins_[i] == Join::smooth;
  }

  std::optional<Loop> closed_curve() {
    if (count() < 2) return std::nullopt;
    if (std::any_of(joins_.begin(), joins_.end(), [](Join j) { return j != Join::smooth; })) return std::nullopt;
    if (!check_join(0, knots_[count()] - knots_[count() - 1], knots_[1])) return std::nullopt;
    counts_.smooth += static_cast<long>(count());
    counts_.join_error = std::max(counts_.join_error, moved_);
    // Every break p - 1 times; the control points are the inner ones of the pieces. Basis function i starts at knot i
    // and so belongs to the point behind it in this order.
    std::vector<double> knots;
    std::vector<Point> points;
    for (std::size_t i = 0; i < count(); ++i) {
      knots.insert(knots.end(), static_cast<std::size_t>(p_) - 1, knots_[i]);
      points.insert(points.end(), pieces_[i].points.begin() + 1, pieces_[i].points.begin() + p_);
    }
    knots.push_back(knots_.back());
    std::rotate(points.begin(), points.begin() + 1, points.end());
    return Loop{{BSpline(p_, true, std::move(knots), std::move(points))}, {false}};
  }

  Loop open_curves() {
    Loop loop;
    counts_.join_error = std::max(counts_.join_error, moved_);
    counts_.corners += joins_[0] == Join::smooth ? 0 : 1;
    for (std::size_t first = 0; first < count();) {
      std::size_t last = first + 1;
      while (last < count() && joins_[last] != Join::cusp) ++last;
      const auto clamp = static_cast<std::size_t>(p_) + 1;
      std::vector<double> knots(clamp, knots_[first]);
      std::vector<Point> points{pieces_[first].start()};
      for (std::size_t i = first; i < last; ++i) {
        if (i > first) {
          const bool is_smooth = joins_[i] == Join::smooth;
          knots.insert(knots.end(), static_cast<std::size_t>(is_smooth ? p_ - 1 : p_), knots_[i]);
          if (!is_smooth) points.push_back(pieces_[i].start());
          ++(is_smooth ? counts_.smooth : counts_.corners);
        }
        points.insert(points.end(), pieces_[i].points.begin() + 1, pieces_[i].points.begin() + p_);
      }
      points.push_back(pieces_[last - 1].end());
      knots.insert(knots.end(), clamp, knots_[last]);
      loop.curves.emplace_back(p_, false, std::move(knots), std::move(points));
      loop.cusps.push_back(joins_[first] == Join::cusp);
      first = last;
    }
    return loop;
  }

  std::vector<Piece> pieces_;
  bool is_open_;  ///< does the last piece not lead to the first?
  const LoopOptions& options_;
  LoopCounts& counts_;
  int p_;
  std::vector<Join> joins_;  ///< the join at the start of each piece
  std::vector<double> knots_;
  double moved_ = 0;
};

double extent_of(const Piece& piece) {
  Box box;
  for (int i = 0; i <= piece.degree; ++i) box.extend(piece.points[static_cast<std::size_t>(i)]);
  return box.size();
}

/// Drops pieces without length and lets every piece start where the one before it ends. False if nothing is left.
bool close_up(std::vector<Piece>& pieces, double least, bool is_open = false) {
  std::vector<Piece> kept;
  for (const Piece& piece : pieces) {
    if (extent_of(piece) <= least) continue;
    kept.push_back(piece);
  }
  for (std::size_t i = 0; i + (is_open ? 1 : 0) < kept.size(); ++i)
    kept[(i + 1) % kept.size()].points[0] = kept[i].end();
  pieces = std::move(kept);
  return !pieces.empty();
}

/// Has the loop an interior? It has none if all control points are on a line.
bool has_area(const std::vector<Piece>& pieces, double least) {
  const Point origin = pieces.front().start();
  Vector far;
  for (const Piece& piece : pieces)
    for (int i = 0; i <= piece.degree; ++i) {
      const Vector v = piece.points[static_cast<std::size_t>(i)] - origin;
      if (squared_length(v) > squared_length(far)) far = v;
    }
  const double reach = length(far);
  for (const Piece& piece : pieces)
    for (int i = 0; i <= piece.degree; ++i)
      if (std::abs(cross(far, piece.points[static_cast<std::size_t>(i)] - origin)) > least * reach) return true;
  return false;
}

/// Splits the only piece of a loop in two, so that a closed curve has enough spans.
void halve(std::vector<Piece>& pieces) {
  const Piece whole = elevated(pieces.front(), 3);
  const auto halves = split(whole.points, 0.5);
  Piece first = whole, second = whole;
  first.points = halves[0];
  second.points = halves[1];
  pieces = {first, second};
}

void elevate_all(std::vector<Piece>& pieces) {
  int degree = 1;
  for (const Piece& piece : pieces) degree = std::max(degree, piece.degree);
  for (Piece& piece : pieces) piece = elevated(piece, degree);
}

void close_by_line(std::vector<Piece>& pieces, const Point& end, const Point& start) {
  if (end == start) return;
  Piece line;
  line.points[0] = end;
  line.points[1] = start;
  pieces.push_back(line);
}

}  // namespace

std::vector<Loop> make_loops(const Outline& outline, const LoopOptions& options, LoopCounts& counts) {
  std::vector<Loop> loops;
  const double least = loop_gap * options.size;
  const auto finish = [&](std::vector<Piece> pieces, const Point& start, const Point& end, bool) {
    close_by_line(pieces, end, start);
    if (!close_up(pieces, least) || !has_area(pieces, least)) {
      ++counts.no_area;
      return;
    }
    if (pieces.size() == 1 && options.degree >= 3) halve(pieces);
    elevate_all(pieces);
    loops.push_back(LoopBuilder(std::move(pieces), false, options, counts).build());
  };
  Subpaths(options, counts, finish).read(outline);
  return loops;
}

std::vector<BSpline> make_lines(const Outline& outline, const LoopOptions& options, LoopCounts& counts) {
  std::vector<BSpline> lines;
  const double least = loop_gap * options.size;
  const auto finish = [&](std::vector<Piece> pieces, const Point& start, const Point& end, bool is_closed) {
    if (is_closed) close_by_line(pieces, end, start);
    if (!close_up(pieces, least, !is_closed)) return;
    const bool is_open = !is_closed || !has_area(pieces, least);
    if (!is_open && pieces.size() == 1 && options.degree >= 3) halve(pieces);
    elevate_all(pieces);
    Loop loop = LoopBuilder(std::move(pieces), is_open, options, counts).build();
    for (BSpline& curve : loop.curves) lines.push_back(std::move(curve));
  };
  Subpaths(options, counts, finish, true).read(outline);
  return lines;
}

}  // namespace pliant::svg
