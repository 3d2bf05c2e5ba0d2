// lib/pliant/boundary/curve_contact.cpp: do Bézier curves cross or touch away from their common ends?
#include "pliant/boundary/curve_contact.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "pliant/boundary/hull_separation.h"
#include "pliant/geometry/spline/bspline.h"

namespace pliant {
namespace {

// Relative to the size of the pair of curves:
constexpr double least_margin = 1e-13;  // the distance of hulls that are apart; it is more than subdivision rounds
constexpr double least_contact_piece = 1e-11;  // pieces of this size that are not apart meet
// Relative to the shorter curve, distances from a common end:
constexpr double least_contact_corner = 1e-9;  // curves are not compared any nearer to it
constexpr double blurred_contact = 1e-7;       // nearer than this, curves that only have the same tangent seem to meet
// Limits of the search:
constexpr int deepest_self = 40;        // halvings of a curve; what is then not straight is a place where it stops
constexpr int deepest_pair = 160;       // halvings of a pair of curves; doubles cannot tell more apart
constexpr long most_tests = 2'000'000;  // tests of a pair of curves; a pair that needs more counts as in contact

/// A part of one of the two curves.
struct ContactPiece {
  std::array<Point, max_curve_degree + 1> points;
  int degree;
  double from, to;  // parameters on the whole curve
  int from_node, to_node;

  std::span<const Point> polygon() const { return {points.data(), static_cast<std::size_t>(degree) + 1}; }
  Point& at(int i) { return points[static_cast<std::size_t>(i)]; }
  const Point& at(int i) const { return points[static_cast<std::size_t>(i)]; }
  double middle() const { return from + (to - from) / 2; }
  Vector chord() const { return at(degree) - at(0); }
};

/// The whole curve as a piece, relative to an origin.
ContactPiece whole(const ContactCurve& curve, const Point& origin) {
  ContactPiece piece{{}, static_cast<int>(curve.polygon.size()) - 1, 0, 1, curve.from, curve.to};
  for (int i = 0; i <= piece.degree; ++i) piece.at(i) = curve.polygon[static_cast<std::size_t>(i)] - origin;
  return piece;
}

/// The same piece run backwards, so that its last point comes first.
ContactPiece reversed(ContactPiece piece) {
  std::reverse(piece.points.begin(), piece.points.begin() + piece.degree + 1);
  std::swap(piece.from, piece.to);
  std::swap(piece.from_node, piece.to_node);
  return piece;
}

void shift(ContactPiece& piece, const Point& origin) {
  for (int i = 0; i <= piece.degree; ++i) piece.at(i) -= origin;
}

double reach(const ContactPiece& piece) {
  double most = 0;
  for (const Point& p : piece.polygon()) most = std::max({most, std::fabs(p.x), std::fabs(p.y)});
  return most;
}

double extent(const ContactPiece& piece) {
  Box box;
  for (const Point& p : piece.polygon()) box.extend(p);
  return box.size();
}

class Search {
 public:
  /// New ends become nodes from `first_node` on, which is above the nodes of the curves' own ends.
  explicit Search(int first_node) : next_node_(first_node) {}

  std::pair<ContactPiece, ContactPiece> halves(const ContactPiece& piece) {
    ContactPiece left = piece, right = piece;
    const int p = piece.degree, node = next_node_++;
    for (int r = 1; r <= p; ++r) {
      for (int i = p; i >= r; --i) left.at(i) = 0.5 * (left.at(i - 1) + left.at(i));
      right.at(p - r) = left.at(p);
    }
    left.to = right.from = piece.middle();
    left.to_node = right.from_node = node;
    return {left, right};
  }

  /// The contact of two pieces that are not parts of each other.
  std::optional<Contact> compare(const ContactPiece& a, const ContactPiece& b) {
    // A curve that returns to its start would have two ends at the common node.
    if (a.from_node == a.to_node || b.from_node == b.to_node) {
      const bool split_a = a.from_node == a.to_node;
      const auto [one, two] = halves(split_a ? a : b);
      if (auto found = split_a ? compare(one, b) : compare(a, one)) return found;
      return split_a ? compare(two, b) : compare(a, two);
    }
    const bool at_start = a.from_node == b.from_node || a.from_node == b.to_node;
    const bool at_end = a.to_node == b.from_node || a.to_node == b.to_node;
    if (at_start && at_end) return compare_halves(a, b);
    if (at_start) return from_common_end(a, a.from_node == b.from_node ? b : reversed(b));
    if (at_end) return from_common_end(reversed(a), a.to_node == b.from_node ? b : reversed(b));
    return compare_separate(a, b);
  }

  /// The contact of a piece with itself, or the point where it stops.
  std::optional<Contact> compare_with_itself(const ContactPiece& piece, int depth = 0) {
    if (runs_along_chord(piece)) return std::nullopt;
    if (depth == deepest_self)
      return Contact{Contact::Kind::turns_back, piece.middle(), piece.middle(), piece.at(0), -1};
    const auto [left, right] = halves(piece);
    if (auto found = compare_with_itself(left, depth + 1)) return found;
    if (auto found = compare_with_itself(right, depth + 1)) return found;
    return compare(left, right);
  }

 private:
  /// Whether every leg advances along the chord. Then the piece does not meet itself, and its derivative vanishes
  /// nowhere.
  static bool runs_along_chord(const ContactPiece& piece) {
    const Vector chord = piece.chord();
    for (int i = 1; i <= piece.degree; ++i) {
      const Vector leg = piece.at(i) - piece.at(i - 1);
      const bool inner = 1 < i && i < piece.degree;
      if (!(dot(leg, chord) > 0) && !(inner && leg == Vector{})) return false;
    }
    return true;
  }

  std::optional<Contact> compare_halves(const ContactPiece& a, const ContactPiece& b) {
    const auto [a1, a2] = halves(a);
    const auto [b1, b2] = halves(b);
    for (const ContactPiece* i : {&a1, &a2})
      for (const ContactPiece* j : {&b1, &b2})
        if (auto found = compare(*i, *j)) return found;
    return std::nullopt;
  }

  /// Compares pieces that start in the same point. Coordinates relative to that point keep their relative precision,
  /// however small the pieces become. The longer piece is halved, or both if they are about as long, so that the
  /// margin, which is relative to the longer one, is small compared with both.
  std::optional<Contact> from_common_end(ContactPiece a, ContactPiece b) {
    const Point origin = a.at(0);
    shift(a, origin);
    shift(b, origin);
    const double whole_extent = std::min(extent(a), extent(b));
    for (int depth = 0; depth < deepest_pair; ++depth) {
      if (cones_apart(a.polygon(), b.polygon(), least_margin)) return std::nullopt;
      const double extent_a = extent(a), extent_b = extent(b), near = std::max(extent_a, extent_b);
      if (near < least_contact_corner * whole_extent) break;
      const bool cut_a = extent_a >= extent_b / 2, cut_b = extent_b >= extent_a / 2;
      const auto [a1, a2] = halves(a);
      const auto [b1, b2] = halves(b);
      const ContactPiece &near_a = cut_a ? a1 : a, &near_b = cut_b ? b1 : b;
      std::optional<Contact> found;
      if (cut_a && cut_b) found = compare_separate(a2, b2);
      if (!found && cut_b) found = compare_separate(near_a, b2);
      if (!found && cut_a) found = compare_separate(a2, near_b);
      if (found) {
        if (near < blurred_contact * whole_extent) break;
        found->place += origin;
        return found;
      }
      a = near_a;
      b = near_b;
    }
    return Contact{Contact::Kind::turns_back, a.from, b.from, origin, a.from_node};
  }

  /// The contact of two pieces without a common end.
  std::optional<Contact> compare_separate(ContactPiece a, ContactPiece b) {
    const double size = std::max(reach(a), reach(b));
    tests_ = 0;
    return compare_separate(a, b, size, 0);
  }

  std::optional<Contact> compare_separate(const ContactPiece& a, const ContactPiece& b, double size, int depth) {
    if (hulls_apart(a.polygon(), b.polygon(), least_margin * size)) return std::nullopt;
    const double extent_a = extent(a), extent_b = extent(b);
    if ((extent_a <= least_contact_piece * size && extent_b <= least_contact_piece * size) || ++tests_ > most_tests ||
        depth == deepest_pair)
      return Contact{Contact::Kind::meets, a.middle(), b.middle(), a.at(0)};
    const bool split_a = extent_a >= extent_b;
    const auto [one, two] = halves(split_a ? a : b);
    if (auto found = split_a ? compare_separate(one, b, size, depth + 1) : compare_separate(a, one, size, depth + 1))
      return found;
    return split_a ? compare_separate(two, b, size, depth + 1) : compare_separate(a, two, size, depth + 1);
  }

  int next_node_;
  long tests_ = 0;
};

/// The first number above the nodes of a curve.
int above(const ContactCurve& a) { return std::max(a.from, a.to) + 1; }

}  // namespace

std::optional<Contact> find_contact(const ContactCurve& a, const ContactCurve& b) {
  const Point origin = a.polygon.front();
  auto found = Search(std::max(above(a), above(b))).compare(whole(a, origin), whole(b, origin));
  if (found) found->place += origin;
  return found;
}

std::optional<Contact> find_self_contact(const ContactCurve& a) {
  const Point origin = a.polygon.front();
  auto found = Search(above(a)).compare_with_itself(whole(a, origin));
  if (found) found->place += origin;
  return found;
}

}  // namespace pliant
