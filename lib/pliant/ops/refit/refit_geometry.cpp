// lib/pliant/ops/refit/refit_geometry.cpp: places new control points: fitted displacements, else a search.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

#include "pliant/geometry/bernstein.h"
#include "pliant/geometry/dense/solve_dense.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/linear_triangle.h"
#include "pliant/geometry/node_basis.h"
#include "pliant/geometry/placement/optimal_placement.h"
#include "pliant/geometry/validity/jacobian.h"
#include "pliant/ops/build_triangle.h"
#include "pliant/ops/even_jacobian.h"
#include "pliant/ops/refit/refit.h"
#include "pliant/ops/refit/straight_places.h"

namespace pliant {
namespace {

// Sweeps place the free points one after the other.
constexpr int max_sweeps = 12;
constexpr int least_sweeps = 4;       // so many sweeps may gain little without being the last
constexpr double least_gain = 0.002;  // a sweep gains little if the least value grows by less than this part of it
constexpr int pieces_in_sweep = 200;  // bisections per placement; the next point's move changes the best place anyway
constexpr std::size_t starts_by_cube = 6400;  // random starts times the cube of the number of free points
// Gauss-Newton steps move all free points at once.
constexpr int max_steps = 12;
constexpr double wanted_ratio = 0.05;  // coefficients of det J below this part of their target get more weight,
constexpr double weight_growth = 3;    // by this factor after each step
constexpr double least_share = 1e-6;   // each logical triangle must have this share of the region for these steps
// Displacements shorter than this times the largest coordinate count as none.
constexpr double rounding = 0x1p-51;

/// Moves all free points by Gauss-Newton steps towards a det J that is constant on each element, with more and more
/// weight on coefficients that stay small. The area that each element should have is its share of the region, as the
/// logical triangles divide it. True once every element is valid.
bool even_out(Mesh& mesh, std::span<const TriangleId> now, std::span<const PointId> free) {
  thread_local std::vector<double> targets, ratios, weights;
  const std::size_t n = index(mesh.net_size()), m = index(net_size(jacobian_degree(mesh.degree())));
  std::array<Point, net_size(max_degree)> net;
  targets.clear();
  double region = 0, logical = 0;
  for (const TriangleId t : now) {
    mesh.gather_points(t, net);
    region += element_area(mesh.degree(), {net.data(), n});
    targets.push_back(triangle_area(net[0], net[1], net[2]));
    logical += targets.back();
  }
  // The det J that a sliver should have would drown in the rounding of coordinates.
  const double least = least_share * logical;
  if (!(region > 0) || !std::all_of(targets.begin(), targets.end(), [least](double x) { return x > least; }))
    return false;
  for (double& target : targets) target *= 2 * region / logical;
  ratios.resize(m * now.size());
  weights.assign(ratios.size(), 1.0);
  for (int step = 0; step < max_steps; ++step) {
    step_to_even_jacobian(mesh, now, free, targets, weights);
    if (all_valid(mesh, now)) return true;
    jacobian_ratios(mesh, now, targets, ratios);
    for (std::size_t k = 0; k < ratios.size(); ++k)
      if (ratios[k] < wanted_ratio) weights[k] *= weight_growth;
  }
  return false;
}

/// Moves the free points, one after the other, to their optimal places, until every element is valid (true) or a sweep
/// gains little.
bool sweep_placements(Mesh& mesh, std::span<const TriangleId> now, std::span<const PointId> free) {
  const std::size_t n = index(mesh.net_size());
  std::array<std::array<Point, net_size(max_degree)>, 8> nets;
  std::array<PlacementElement, 8> elements;
  double reached = -HUGE_VAL;
  for (int sweep = 0; sweep < max_sweeps; ++sweep) {
    double least = HUGE_VAL;
    for (const PointId p : free) {
      std::size_t count = 0;
      for (const TriangleId t : now) {
        const auto net = mesh.net(t);
        const auto found = std::find(net.begin(), net.end(), p);
        if (found == net.end() || count == elements.size()) continue;
        mesh.gather_points(t, nets[count]);
        elements[count] = {{nets[count].data(), n}, static_cast<int>(found - net.begin())};
        ++count;
      }
      if (count == 0) continue;
      const Placement placement = untangle_point(mesh.degree(), {elements.data(), count}, mesh.point(p),
                                                 PlacementMeasure::element, free.size() == 1 ? 400 : pieces_in_sweep);
      least = std::min(least, placement.value);
      if (free.size() == 1 && placement.outcome != Placement::Outcome::placed) return false;
      if (is_finite(placement.place)) mesh.set_point(p, placement.place);
    }
    if (all_valid(mesh, now)) return true;
    if (sweep >= least_sweeps && least < reached + least_gain * std::abs(reached)) break;
    reached = std::max(reached, least);
  }
  return false;
}

/// Remembers searches that found nothing, by the bits of everything that decides them: a pass asks for the same flip
/// again and again as long as nothing around it changes.
class FruitlessSearches {
 public:
  /// True if this search is known to find nothing. Makes it the last one asked for.
  bool contains(const Mesh& mesh, std::span<const TriangleId> now, std::span<const PointId> free) {
    key_.assign({static_cast<double>(mesh.degree()), static_cast<double>(free.size())});
    for (const TriangleId t : now)
      for (const PointId p : mesh.net(t)) {
        const Point& place = mesh.point(p);
        key_.insert(key_.end(), {place.x, place.y, static_cast<double>(index_in(free, p))});
      }
    slot_ = 0;
    for (const double value : key_) slot_ = 1099511628211u * (slot_ ^ std::bit_cast<std::uint64_t>(value));
    slot_ = (slot_ >> 32) % known_.size();
    return known_[slot_] == key_;
  }
  /// Adds the search that was asked for last.
  void add() { known_[slot_] = key_; }

 private:
  std::array<std::vector<double>, 256> known_;
  std::vector<double> key_;
  std::uint64_t slot_ = 0;
};

/// Searches for places of the free points that make every element valid. A single free point has one best place, which
/// decides. With several points the result depends on where the search begins: first where they are, then with det J
/// evened out, then at random places in the patch, which are the same in every run.
bool search(Mesh& mesh, std::span<const TriangleId> now, std::span<const PointId> free) {
  thread_local std::vector<Point> first;
  first.clear();
  for (const PointId p : free) first.push_back(mesh.point(p));
  if (sweep_placements(mesh, now, free)) return true;
  if (free.size() == 1) return false;
  for (std::size_t k = 0; k < free.size(); ++k) mesh.set_point(free[k], first[k]);
  if (even_out(mesh, now, free)) return true;
  Box box;
  for (const TriangleId t : now)
    for (const PointId p : mesh.net(t))
      if (index_in(free, p) < 0) box.extend(mesh.point(p));
  std::minstd_rand random(1);
  std::uniform_real_distribution<double> x(box.low.x, box.high.x), y(box.low.y, box.high.y);
  const std::size_t starts = starts_by_cube / (free.size() * free.size() * free.size());
  for (std::size_t start = 0; start < starts; ++start) {
    for (const PointId p : free) mesh.set_point(p, {x(random), y(random)});
    if (sweep_placements(mesh, now, free)) return true;
  }
  return false;
}

/// The same, without the searches that are known to find nothing.
bool untangle(Mesh& mesh, std::span<const TriangleId> now, std::span<const PointId> free) {
  // No place of a control point helps an element that lies between two smoothly joined edges.
  if (std::any_of(now.begin(), now.end(), [&mesh](TriangleId t) { return covers_smooth_corner(mesh, t); }))
    return false;
  // What is remembered does not say which corners are cusps, where elements may be degenerate.
  if (free.size() == 1 || !mesh.boundary().cusps.empty()) return search(mesh, now, free);
  thread_local FruitlessSearches fruitless;
  if (fruitless.contains(mesh, now, free)) return false;
  if (search(mesh, now, free)) return true;
  fruitless.add();
  return false;
}

}  // namespace

void Patch::capture(const Mesh& mesh, std::span<const TriangleId> old) {
  degree_ = mesh.degree();
  n_ = mesh.net_size();
  width_ = mesh.width();
  size_ = mesh.size();
  elements_.clear();
  rows_.resize(old.size() * index(n_ * width_));
  std::size_t first = 0;
  for (const TriangleId t : old) {
    elements_.push_back({mesh.face(t), first});
    mesh.gather(t, std::span<double>(rows_).subspan(first, index(n_ * width_)));
    first += index(n_ * width_);
  }
  origin_ = old_point(elements_[0], 0);
  reach_ = 0;
  for (const Element& e : elements_)
    for (int c = 0; c < 3; ++c) reach_ = std::max({reach_, std::abs(old_point(e, c).x), std::abs(old_point(e, c).y)});
}

double Patch::extent() const {
  double longest = 0;  // squared
  for (const Element& e : elements_)
    for (int c = 0; c < 3; ++c)
      longest = std::max(longest, squared_length(old_point(e, (c + 1) % 3) - old_point(e, c)));
  return std::sqrt(longest);
}

bool Patch::fit_geometry(Mesh& mesh, std::span<const TriangleId> now, std::span<const PointId> free,
                         double straight_below) const {
  if (free.empty()) return all_valid(mesh, now);
  const NetLayout& layout = NetLayout::of(degree_);
  // The displacements of the old control points from their straight places. If the longest is below the rounding of
  // coordinates, the elements are straight.
  thread_local std::vector<double> displacement;
  displacement.resize(elements_.size() * index(2 * n_));
  double longest = 0, reach = 0;  // squared; of the coordinates
  for (std::size_t e = 0; e < elements_.size(); ++e)
    for (int k = 0; k < n_; ++k) {
      const Element& old = elements_[e];
      const Point p = old_point(old, k);
      const Vector d = p - straight(layout, k, old_point(old, 0), old_point(old, 1), old_point(old, 2));
      displacement[e * index(2 * n_) + index(2 * k)] = d.x;
      displacement[e * index(2 * n_) + index(2 * k + 1)] = d.y;
      longest = std::max(longest, squared_length(d));
      reach = std::max({reach, std::abs(p.x), std::abs(p.y)});
    }
  longest = std::sqrt(longest);
  const bool are_straight = longest <= rounding * reach;

  thread_local std::vector<Vector> solution;
  solution.assign(free.size(), Vector{});
  const auto place = [&] {
    for (const TriangleId t : now) {
      const auto net = mesh.net(t);
      const Point &a = mesh.point(net[0]), &b = mesh.point(net[1]), &c = mesh.point(net[2]);
      for (int k = 3; k < n_; ++k) {
        const int u = index_in(free, net[index(k)]);
        if (u < 0) continue;
        Vector d = solution[index(u)];
        if (!is_finite(d)) d = {0, 0};
        const double far = std::sqrt(squared_length(d));
        if (far > longest) d *= longest / far;
        mesh.set_point(net[index(k)], straight(layout, k, a, b, c) + d);
      }
    }
    return all_valid(mesh, now);
  };
  if ((are_straight || longest <= straight_below * extent()) && place()) return true;
  if (!are_straight) {
    fit_displacement(mesh, now, free, displacement, solution);
    if (place()) return true;
  }
  // If straight elements are not valid, they are flat to rounding; bending them would hide that.
  return !are_straight && untangle(mesh, now, free);
}

}  // namespace pliant
