// lib/pliant/geometry/placement/untangle_point.cpp: a linear program over det J's coefficients, with cuts.
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

#include "pliant/geometry/placement/affine_program.h"
#include "pliant/geometry/placement/optimal_placement.h"
#include "pliant/geometry/placement/placement_star.h"
#include "pliant/geometry/predicates.h"
#include "pliant/geometry/validity/bisect_net.h"
#include "pliant/geometry/validity/jacobian.h"

namespace pliant {
namespace {

constexpr double reach = 4;  // how far from the middle of the star places are sought, in its half extents
constexpr int most_untangling_rounds = 80;  // rounds of cuts
constexpr double proof_gap = 1e-11;         // more than rounding can change a coefficient of the order of 1

/// How bisect_net takes means of affine functions.
struct AffineMean {
  static void add(AffineFunction& f, const AffineFunction& g) {
    f = {0.5 * (f.a + g.a), 0.5 * (f.b + g.b), 0.5 * (f.c + g.c)};
  }
  static void align(AffineFunction&, int) {}
};

/// The same function, but of the place relative to the middle of the star.
AffineFunction from_middle(const PlacementStar& star, const AffineFunction& f) { return {f.a, f.b, f(star.middle())}; }

/// det J of the elements, or of pieces of them, as coefficients that are affine functions of the place (relative to the
/// middle of the star). They are in lattice order, piece after piece. Memory is reused from call to call.
class AffineJacobians {
 public:
  void start(PlacementStar& star) {
    degree_ = jacobian_degree(star.degree());
    size_ = static_cast<std::size_t>(net_size(degree_));
    functions_.resize(star.count() * size_);
    rounding_ = proof_gap;
    for (std::size_t e = 0; e < star.count(); ++e) add_element(star, e);
  }
  /// A bound of the rounding errors of the functions at places of the order of 1.
  double rounding() const { return rounding_; }
  std::span<const AffineFunction> functions() const { return functions_; }
  std::size_t pieces() const { return functions_.size() / size_; }
  std::size_t piece_of(std::size_t function) const { return function / size_; }
  /// Whether a function is a value of det J, at a corner of a piece; the others are only bounds of it.
  bool is_value(std::size_t function) const {
    const auto corners = lattice_corners(degree_);
    return std::find(corners.begin(), corners.end(), static_cast<int>(function % size_)) != corners.end();
  }
  std::span<const AffineFunction> corner_values() {
    values_.clear();
    for (std::size_t first = 0; first < functions_.size(); first += size_)
      for (const int corner : lattice_corners(degree_))
        values_.push_back(functions_[first + static_cast<std::size_t>(corner)]);
    return values_;
  }
  /// Bisects a piece: one half takes its place, the other comes last.
  void bisect(std::size_t piece) {
    std::array<AffineFunction, net_size(2 * (max_degree - 1))> parent;
    std::array<AffineFunction, 2 * max_degree> row;
    const std::size_t first = piece * size_, last = functions_.size();
    std::copy_n(functions_.begin() + static_cast<std::ptrdiff_t>(first), size_, parent.begin());
    functions_.resize(last + size_);
    bisect_net<AffineMean>(degree_, parent.data(), functions_.data() + first, functions_.data() + last, row.data());
  }

 private:
  void add_element(PlacementStar& star, std::size_t e) {
    std::array<double, net_size(2 * (max_degree - 1))> at_origin, along_x, along_y;
    jacobian_net(star.degree(), star.net(e, {1, 0}), along_x);
    jacobian_net(star.degree(), star.net(e, {0, 1}), along_y);
    const std::span<const Point> net = star.net(e, {0, 0});
    jacobian_net(star.degree(), net, at_origin);
    // The scale is the element's own size and not the star's, so that no element is neglected because another is large.
    Box box;
    for (std::size_t n = 0; n < net.size(); ++n)
      if (static_cast<int>(n) != star.moving(e)) box.extend(net[n]);
    const double extent = squared_length(box.high - box.low), scale = extent > 0 ? 1 / extent : 1;
    rounding_ = std::max(rounding_, std::min(1.0, 0.1 * proof_gap * scale));
    const std::vector<int>& order = lattice_order(degree_);
    for (std::size_t n = 0; n < size_; ++n)
      functions_[e * size_ + static_cast<std::size_t>(order[n])] = from_middle(
          star, {scale * (along_x[n] - at_origin[n]), scale * (along_y[n] - at_origin[n]), scale * at_origin[n]});
  }

  int degree_ = 0;
  std::size_t size_ = 1;
  double rounding_ = 0;
  std::vector<AffineFunction> functions_, values_;
};

/// Whether det J is not positive at a corner that the moving point does not affect, because it is neither the corner
/// nor its neighbour on an edge. Then no place makes the element valid.
bool is_fixed_corner_bad(const PlacementElement& element, int degree) {
  const NetLayout& layout = NetLayout::of(degree);
  for (int corner = 0; corner < 3; ++corner) {
    const int next = layout.edge_index(corner, 1), previous = layout.edge_index((corner + 2) % 3, degree - 1);
    if (element.moving == corner || element.moving == next || element.moving == previous) continue;
    const auto point = [&element](int n) { return element.net[static_cast<std::size_t>(n)]; };
    if (orient2d(point(corner), point(next), point(previous)) <= 0) return true;
  }
  return false;
}

/// Proves, or does not, that no place within 1000 half extents makes the values at the corners of all pieces positive.
/// Their least is nowhere above a mean of them, so one mean that is negative in that whole square is a proof, whatever
/// rounding did to its weights.
bool is_hopeless(AffineJacobians& jacobians) {
  constexpr double far = 1e3;
  const std::span<const AffineFunction> values = jacobians.corner_values();
  const AffineOptimum best = maximise_least(values, far);
  if (!best.bounded || best.value > -proof_gap) return false;
  AffineFunction mean{0, 0, 0};
  double shares = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double share = std::max(0.0, best.share[i]);
    if (share == 0) continue;
    if (best.active[i] < 0) return false;
    const AffineFunction& f = values[static_cast<std::size_t>(best.active[i])];
    mean = {mean.a + share * f.a, mean.b + share * f.b, mean.c + share * f.c};
    shares += share;
  }
  return mean.c + far * (std::fabs(mean.a) + std::fabs(mean.b)) <= -jacobians.rounding() * shares;
}

/// The pieces to bisect: those where a coefficient that is not a value of det J holds the optimum down.
void find_tight(const AffineJacobians& jacobians, const AffineOptimum& optimum, std::vector<std::size_t>& tight) {
  tight.clear();
  for (std::size_t i = 0; i < 3; ++i) {
    const int n = optimum.active[i];
    if (n < 0 || optimum.share[i] <= 0 || jacobians.is_value(static_cast<std::size_t>(n))) continue;
    tight.push_back(jacobians.piece_of(static_cast<std::size_t>(n)));
  }
  // There may be none, because of several optima or rounding. Then all pieces that are not positive at the optimum.
  const auto functions = jacobians.functions();
  if (tight.empty())
    for (std::size_t n = 0; n < functions.size(); ++n)
      if (functions[n](optimum.place) <= proof_gap && !jacobians.is_value(n)) tight.push_back(jacobians.piece_of(n));
  std::sort(tight.begin(), tight.end());
  tight.erase(std::unique(tight.begin(), tight.end()), tight.end());
}

Placement untangle_elements(PlacementStar& star, const Point& start, std::size_t most_pieces) {
  constexpr auto area = Placement::Program::area;
  for (const PlacementElement& element : star.elements())
    if (is_fixed_corner_bad(element, star.degree())) return {Placement::Outcome::hopeless, start, -1, area};
  thread_local AffineJacobians jacobians;
  thread_local std::vector<std::size_t> tight;
  jacobians.start(star);
  const Point near = star.local(start) - star.middle();
  Placement best{Placement::Outcome::stuck, start, -1, area};
  for (int round = 0; round < most_untangling_rounds; ++round) {
    const AffineOptimum optimum = maximise_least(jacobians.functions(), reach * star.half(), near);
    const Point place = star.world(star.middle() + optimum.place);
    if (round == 0 || optimum.value > best.value) {
      best.place = place;
      best.value = optimum.value;
    }
    // The coefficients are only bounds, so that a place may be certified although one of them is negative. The
    // certificate and the proof cost as much as many cuts, so they are tried less and less often.
    const bool is_milestone = (round & (round - 1)) == 0;
    if ((is_milestone || optimum.value > 0) && star.is_certified(place))
      return {Placement::Outcome::placed, place, optimum.value, area};
    find_tight(jacobians, optimum, tight);
    const bool is_last =
        tight.empty() || jacobians.pieces() + tight.size() > most_pieces || round + 1 == most_untangling_rounds;
    if ((is_milestone || is_last) && is_hopeless(jacobians)) {
      best.outcome = Placement::Outcome::hopeless;
      return best;
    }
    if (is_last) {
      if (!is_milestone && star.is_certified(place)) return {Placement::Outcome::placed, place, optimum.value, area};
      return best;
    }
    for (const std::size_t piece : tight) jacobians.bisect(piece);
  }
  return best;
}

Placement untangle_control_mesh(PlacementStar& star, const Point& start) {
  thread_local std::vector<AffineFunction> areas;
  areas.clear();
  const double scale = star.half() > 0 ? 0.5 / (star.half() * star.half()) : 0.5;
  for (std::size_t e = 0; e < star.count(); ++e) {
    const auto net = star.net(e, {});
    star.for_control_triangles(e, [&](const std::array<int, 3>& corners, std::size_t which) {
      // The area is (b - a) x (q - a) / 2, with fixed corners a and b and the moving corner q.
      const Point& a = net[static_cast<std::size_t>(corners[(which + 1) % 3])];
      const Point& b = net[static_cast<std::size_t>(corners[(which + 2) % 3])];
      const Vector side = b - a;
      areas.push_back(from_middle(star, {-scale * side.y, scale * side.x, -scale * cross(side, a)}));
    });
  }
  const AffineOptimum optimum = maximise_least(areas, reach * star.half(), star.local(start) - star.middle());
  const Point place = star.world(star.middle() + optimum.place);
  const bool placed = star.is_certified(place);
  return {placed ? Placement::Outcome::placed : Placement::Outcome::stuck, place, optimum.value,
          Placement::Program::area};
}

}  // namespace

Placement untangle_point(int degree, std::span<const PlacementElement> elements, const Point& start,
                         PlacementMeasure measure, int most_pieces) {
  assert(!elements.empty());
  thread_local PlacementStar star;
  star.begin(degree, elements);
  return measure == PlacementMeasure::element ? untangle_elements(star, start, static_cast<std::size_t>(most_pieces))
                                              : untangle_control_mesh(star, start);
}

}  // namespace pliant
