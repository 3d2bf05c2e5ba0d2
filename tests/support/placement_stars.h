// tests/support/placement_stars.h: random elements around one control point that moves.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

#include "pliant/geometry/net_layout.h"
#include "pliant/geometry/placement/optimal_placement.h"
#include "pliant/geometry/validity/validity.h"

namespace pliant::samples {

/// Which control point moves: a vertex, one of an edge between two elements, or one inside an element.
enum class StarKind { vertex, edge, interior };

struct PlacementStar {
  int degree;
  std::vector<std::vector<Point>> nets;
  std::vector<int> moving;

  std::vector<PlacementElement> elements() const {
    std::vector<PlacementElement> all;
    for (std::size_t e = 0; e < nets.size(); ++e) all.push_back({nets[e], moving[e]});
    return all;
  }
  Point place() const { return nets[0][static_cast<std::size_t>(moving[0])]; }
  void move(const Point& to) {
    for (std::size_t e = 0; e < nets.size(); ++e) nets[e][static_cast<std::size_t>(moving[e])] = to;
  }
  bool is_valid() const {
    for (const auto& net : nets)
      if (certify(degree, net) != Validity::valid) return false;
    return true;
  }
};

/// Straight triangles of size about 1 around the origin, in which each control point but the corners is then moved by
/// up to noise / (2 degree) in each coordinate. Elements agree on the control points that they share.
inline PlacementStar random_star(int degree, StarKind kind, double noise, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  const NetLayout& layout = NetLayout::of(degree);
  const int count = kind == StarKind::vertex ? 3 + static_cast<int>(random() % 5) : kind == StarKind::edge ? 2 : 1;
  const int turn = std::max(count, 3);
  std::vector<Point> ring;
  for (int k = 0; k <= count; ++k) {
    const double angle = 2 * std::numbers::pi * (k + 0.6 * unit(random)) / turn, r = 0.6 + unit(random);
    ring.push_back(r * Point{std::cos(angle), std::sin(angle)});
  }
  if (count >= 3) ring.back() = ring.front();
  PlacementStar star{degree, {}, {}};
  for (int e = 0; e < count; ++e) {
    std::vector<Point> net;
    const Point a = ring[static_cast<std::size_t>(e)], b = ring[static_cast<std::size_t>(e) + 1];
    for (int n = 0; n < layout.size(); ++n) {
      const auto& [i, j, k] = layout.exponents(n);
      Point p = (static_cast<double>(j) / degree) * a + (static_cast<double>(k) / degree) * b;
      if (n >= 3) p += noise / degree * Vector{unit(random) - 0.5, unit(random) - 0.5};
      net.push_back(p);
    }
    star.nets.push_back(net);
    star.moving.push_back(kind == StarKind::vertex ? 0
                          : kind == StarKind::edge ? layout.edge_index(e == 0 ? 2 : 0, e == 0 ? degree - 1 : 1)
                                                   : layout.first_interior());
  }
  // The edge from the centre to ring[e + 1] is the third of element e and the first of the next.
  for (int e = 0; e + 1 < count + (count >= 3 ? 1 : 0); ++e)
    for (int k = 1; k < degree; ++k)
      star.nets[static_cast<std::size_t>((e + 1) % count)][static_cast<std::size_t>(layout.edge_index(0, k))] =
          star.nets[static_cast<std::size_t>(e)][static_cast<std::size_t>(layout.edge_index(2, degree - k))];
  return star;
}

/// A random star. Every other one is as a smoother meets it. The rest is bent much (some elements are inverted),
/// turned, now and then squeezed to a sliver, which makes constraints nearly parallel, and has the point anywhere, even
/// far outside.
inline PlacementStar hard_star(int degree, unsigned long seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  const StarKind kind = degree == 1   ? StarKind::vertex
                        : degree == 2 ? (random() % 4 == 0 ? StarKind::vertex : StarKind::edge)
                                      : static_cast<StarKind>(random() % 3);
  if (seed % 2 == 0) return random_star(degree, kind, 0.6, random);
  PlacementStar star = random_star(degree, kind, std::exp2(2 * unit(random)), random);
  const double squeeze = random() % 3 == 0 ? std::pow(10.0, -6 * std::fabs(unit(random))) : 1;
  const double angle = 3 * unit(random), far = random() % 4 == 0 ? std::pow(10.0, 3 * std::fabs(unit(random))) : 0.5;
  const Vector side{std::cos(angle), std::sin(angle)};
  for (auto& net : star.nets)
    for (Point& p : net) p = p.x * side + squeeze * p.y * perpendicular(side);
  star.move({far * unit(random), far * unit(random)});
  return star;
}

}  // namespace pliant::samples
