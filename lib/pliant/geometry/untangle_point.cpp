#include <algorithm>  // lib/pliant/geometry/untangle_point.cpp: a linear program over det J's coefficients, with cuts
#include <array>
#include <cassert>
#include <cstddef>
#include <vector>

#include "pliant/geometry/affine_program.h"
#include "pliant/geometry/control_net.h"
#include "pliant/geometry/jacobian.h"
#include "pliant/geometry/optimal_placement.h"
#include "pliant/geometry/placement_star.h"
#include "pliant/geometry/predicates.h"

namespace pliant {
namespace {

constexpr double reach = 4;          // places looked at: as far as four times the farthest fixed control point
constexpr int most_rounds = 40;      // of cuts
constexpr double proof_gap = 1e-11;  // above all rounding of coefficients of the order of 1
constexpr int most_pieces = 400;     // a flat element would be quartered everywhere, round after round

/// det J of one element, or of a piece of one: coefficients that are affine in the place, as rows (a, b, c).
struct Piece {
  std::vector<double> rows;
  int depth;
};

Piece affine_jacobian(PlacementStar& star, std::size_t e) {
  const int d = jacobian_degree(star.degree());
  const auto size = static_cast<std::size_t>(net_size(d));
  std::array<double, net_size(2 * (max_degree - 1))> at_origin, along_x, along_y;
  jacobian_net(star.degree(), star.net(e), at_origin);
  jacobian_net(star.degree(), star.net(e, {1, 0}), along_x);
  jacobian_net(star.degree(), star.net(e, {0, 1}), along_y);
  // The element's own size, not the star's: no element is neglected because another one is large.
  Box box;
  const auto net = star.net(e);
  for (std::size_t n = 0; n < net.size(); ++n)
    if (static_cast<int>(n) != star.moving(e)) box.extend(net[n]);
  const double extent = box.size(), scale = extent > 0 ? 1 / (extent * extent) : 1;
  Piece piece{std::vector<double>(3 * size), 0};
  for (std::size_t n = 0; n < size; ++n) {
    piece.rows[3 * n] = scale * (along_x[n] - at_origin[n]);
    piece.rows[3 * n + 1] = scale * (along_y[n] - at_origin[n]);
    piece.rows[3 * n + 2] = scale * at_origin[n];
  }
  return piece;
}

/// Appends the four quarters of a piece.
void quarter(int d, const Piece& parent, std::vector<Piece>& pieces) {
  constexpr Barycentric a{1, 0, 0}, b{0, 1, 0}, c{0, 0, 1}, ab{.5, .5, 0}, bc{0, .5, .5}, ca{.5, 0, .5};
  const std::array<std::array<Barycentric, 3>, 4> quarters{{{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}};
  for (const auto& [first, second, third] : quarters) {
    Piece piece{std::vector<double>(parent.rows.size()), parent.depth + 1};
    sub_net(d, 3, parent.rows, first, second, third, piece.rows);
    pieces.push_back(std::move(piece));
  }
}

/// At a corner whose two neighbours on the edges stay as well, det J stays: not positive there, never valid.
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

AffineFunction function(const Piece& piece, std::size_t n) {
  return {piece.rows[3 * n], piece.rows[3 * n + 1], piece.rows[3 * n + 2]};
}

/// Proof that no place makes the values at the corners of all pieces positive.
bool is_hopeless(const std::vector<Piece>& pieces) {
  std::vector<AffineFunction> values;
  for (const Piece& piece : pieces)
    for (std::size_t corner = 0; corner < std::min<std::size_t>(3, piece.rows.size() / 3); ++corner)
      values.push_back(function(piece, corner));
  const AffineOptimum best = maximise_least(values, 1e3 * reach);
  return best.bounded && best.value <= -proof_gap;
}

Placement untangle_elements(PlacementStar& star, const Point& start) {
  for (const PlacementElement& element : star.elements())
    if (is_fixed_corner_bad(element, star.degree())) return {Placement::Outcome::hopeless, start, -1};
  const int d = jacobian_degree(star.degree());
  const auto size = static_cast<std::size_t>(net_size(d));
  std::vector<Piece> pieces;
  for (std::size_t e = 0; e < star.count(); ++e) pieces.push_back(affine_jacobian(star, e));

  std::vector<AffineFunction> functions;
  Placement best{Placement::Outcome::stuck, start, -1};
  for (int round = 0; round < most_rounds; ++round) {
    functions.clear();
    for (const Piece& piece : pieces)
      for (std::size_t n = 0; n < size; ++n) functions.push_back(function(piece, n));
    const AffineOptimum optimum = maximise_least(functions, reach);
    const Point place = star.world(optimum.place);
    if (round == 0 || optimum.value > best.value) {
      best.place = place;
      best.value = optimum.value;
    }
    // Coefficients are bounds only: the certificate may see further.
    if (star.is_certified(place)) return {Placement::Outcome::placed, place, optimum.value};
    if (is_hopeless(pieces)) {
      best.outcome = Placement::Outcome::hopeless;
      return best;
    }
    // Where a coefficient that is no value of det J holds the optimum down, look closer.
    std::vector<std::size_t> tight;
    for (std::size_t i = 0; i < 3; ++i) {
      const int n = optimum.active[i];
      if (n < 0 || optimum.share[i] <= 0 || static_cast<std::size_t>(n) % size < 3) continue;
      tight.push_back(static_cast<std::size_t>(n) / size);
    }
    // Several optima, or rounding: any piece that is not positive there.
    if (tight.empty())
      for (std::size_t n = 0; n < functions.size(); ++n)
        if (n % size >= 3 && functions[n](optimum.place) <= proof_gap) tight.push_back(n / size);
    std::sort(tight.begin(), tight.end());
    tight.erase(std::unique(tight.begin(), tight.end()), tight.end());
    if (tight.empty() || pieces.size() + 3 * tight.size() > most_pieces) return best;
    for (auto piece = tight.rbegin(); piece != tight.rend(); ++piece) {
      const Piece parent = std::move(pieces[*piece]);
      pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(*piece));
      quarter(d, parent, pieces);
    }
  }
  return best;
}

Placement untangle_control_mesh(PlacementStar& star) {
  std::vector<AffineFunction> areas;
  for (std::size_t e = 0; e < star.count(); ++e) {
    const auto net = star.net(e);
    star.for_control_triangles(e, [&](const std::array<int, 3>& corners, std::size_t which) {
      // Area 1/2 (b - a) x (q - a) of the fixed corners a, b and the moving q.
      const Point& a = net[static_cast<std::size_t>(corners[(which + 1) % 3])];
      const Point& b = net[static_cast<std::size_t>(corners[(which + 2) % 3])];
      const Vector side = b - a;
      areas.push_back({-side.y / 2, side.x / 2, -cross(side, a) / 2});
    });
  }
  const AffineOptimum optimum = maximise_least(areas, reach);
  const Point place = star.world(optimum.place);
  const bool placed = star.is_certified(place);
  return {placed ? Placement::Outcome::placed : Placement::Outcome::stuck, place, optimum.value};
}

}  // namespace

Placement untangle_point(int degree, std::span<const PlacementElement> elements, const Point& start,
                         PlacementMeasure measure) {
  assert(!elements.empty());
  PlacementStar star(degree, elements, start);
  return measure == PlacementMeasure::element ? untangle_elements(star, start) : untangle_control_mesh(star);
}

}  // namespace pliant
