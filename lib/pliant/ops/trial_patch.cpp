// lib/pliant/ops/trial_patch.cpp: moves on the copy, and their way into the mesh.
#include "pliant/ops/trial_patch.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "pliant/geometry/index.h"
#include "pliant/ops/build_triangle.h"

namespace pliant {
namespace {

// How far placements are refined. The points move in turn, so neither the last digits of one point's optimum nor a
// proof that it has no valid place is worth its cost.
constexpr double accuracy = 1e-2;
constexpr int most_pieces = 40;

/// Fits the fields of elements that are or were tangled. The border of the patch stays, so the signed integral can be
/// kept here too. But the integral's weights have both signs, so without limits the values could become arbitrarily
/// large. If no values within the limits have the integral: false, and the fields are as they were.
bool fit_tangled(const Patch& patch, Mesh& mesh, std::span<const TriangleId> elements, std::span<const PointId> moved,
                 const RefitOptions& options) {
  RefitOptions fit = options;
  if (fit.projection == Projection::conservative) fit.projection = Projection::limited;
  Transaction transaction(mesh);
  if (!patch.fit_fields(mesh, elements, moved, fit)) return false;
  transaction.commit();
  return true;
}

}  // namespace

void TrialPatch::capture(const Mesh& mesh, std::span<const TriangleId> elements) {
  degree_ = mesh.degree();
  size_ = index(mesh.net_size());
  elements_.assign(elements.begin(), elements.end());
  ids_.clear();
  nets_.resize(elements.size() * size_);
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const auto ids = mesh.net(elements[e]);
    ids_.insert(ids_.end(), ids.begin(), ids.end());
    mesh.gather_points(elements[e], {nets_.data() + e * size_, size_});
  }
  old_ = nets_;
}

bool TrialPatch::has(std::size_t e, PointId p) const {
  const auto first = ids_.begin() + static_cast<std::ptrdiff_t>(e * size_);
  return std::find(first, first + static_cast<std::ptrdiff_t>(size_), p) != first + static_cast<std::ptrdiff_t>(size_);
}

const Point& TrialPatch::point(PointId p) const {
  const auto found = std::find(ids_.begin(), ids_.end(), p);
  assert(found != ids_.end());
  return nets_[static_cast<std::size_t>(found - ids_.begin())];
}

void TrialPatch::move(PointId p, const Point& to) {
  for (std::size_t i = 0; i < ids_.size(); ++i)
    if (ids_[i] == p) nets_[i] = to;
}

bool TrialPatch::place(std::span<const PointId> points, SmoothGoal goal, PlacementMeasure measure) {
  bool moved = false;
  for (const PointId p : points) {
    around_.clear();
    for (std::size_t i = 0; i < ids_.size(); ++i)
      if (ids_[i] == p) around_.push_back({net(i / size_), static_cast<int>(i % size_)});
    const Point old = point(p);
    const Placement placement = goal == SmoothGoal::improve
                                    ? improve_point(degree_, around_, old, measure, accuracy)
                                    : untangle_point(degree_, around_, old, measure, most_pieces);
    if (!is_finite(placement.place) || placement.place == old) continue;
    move(p, placement.place);
    moved = true;
  }
  return moved;
}

void TrialPatch::straighten(const Mesh& mesh, HalfEdgeId h, double keep) {
  const EdgePoints edge = side_of(mesh, h).points;
  const Point &from = point(edge.front()), &to = point(edge.back());
  for (int k = 1; k < degree_; ++k) {
    const double w = static_cast<double>(k) / degree_;
    const Point straight = (1 - w) * from + w * to;
    move(edge[k], straight + keep * (point(edge[k]) - straight));
  }
  for (const HalfEdgeId side : {h, mesh.twin(h)})
    if (side != none && std::find(elements_.begin(), elements_.end(), triangle_of(side)) != elements_.end())
      blend(mesh, triangle_of(side));
}

void TrialPatch::blend(const Mesh& mesh, TriangleId t) {
  if (degree_ <= 2) return;
  const NetLayout& layout = mesh.layout();
  const auto e = static_cast<std::size_t>(std::find(elements_.begin(), elements_.end(), t) - elements_.begin());
  assert(e < elements_.size());
  const std::span<Point> points{nets_.data() + e * size_, size_};
  // How far the polygon of an edge is displaced from its chord at parameter s in [0, 1]; linear between control points.
  const auto bend = [&](int edge, double s) {
    const int k = std::min(degree_ - 1, static_cast<int>(s * degree_));
    const auto displacement = [&](int i) {
      const double w = static_cast<double>(i) / degree_;
      return points[index(layout.edge_index(edge, i))] -
             ((1 - w) * points[index(edge)] + w * points[index((edge + 1) % 3)]);
    };
    const double f = s * degree_ - k;
    return (1 - f) * displacement(k) + f * displacement(k + 1);
  };
  for (int k = layout.first_interior(); k < layout.size(); ++k) {
    const auto& exponents = layout.exponents(k);
    Point place{};
    for (std::size_t c = 0; c < 3; ++c) place += (static_cast<double>(exponents[c]) / degree_) * points[c];
    for (std::size_t edge = 0; edge < 3; ++edge) {
      const int from = exponents[edge], to = exponents[(edge + 1) % 3];
      const double fade = static_cast<double>(from + to) / degree_;
      place += fade * fade * bend(static_cast<int>(edge), static_cast<double>(to) / (from + to));
    }
    points[index(k)] = place;
  }
}

void TrialPatch::drag(PointId v, const Vector& shift) {
  const NetLayout& layout = NetLayout::of(degree_);
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const auto first = ids_.begin() + static_cast<std::ptrdiff_t>(e * size_);
    const auto corner = static_cast<std::size_t>(std::find(first, first + 3, v) - first);
    if (corner == 3) continue;
    for (int k = 0; k < layout.size(); ++k)
      nets_[e * size_ + index(k)] += (static_cast<double>(layout.exponents(k)[corner]) / degree_) * shift;
  }
}

Outcome TrialPatch::apply(Mesh& mesh, const RefitOptions& options, bool must_be_valid) const {
  thread_local std::vector<PointId> moved;
  moved.clear();
  for (std::size_t i = 0; i < ids_.size(); ++i)
    if (nets_[i] != old_[i] && std::find(moved.begin(), moved.end(), ids_[i]) == moved.end()) moved.push_back(ids_[i]);
  const bool was_valid = all_valid(mesh, elements_);
  if (moved.empty()) return must_be_valid && !was_valid ? Outcome::would_invert : Outcome::done;
  Transaction transaction(mesh);
  thread_local Patch patch;
  patch.capture(mesh, elements_);
  for (const PointId p : moved) mesh.set_point(p, point(p));
  const bool is_valid = all_valid(mesh, elements_);
  if (must_be_valid && !is_valid) return Outcome::would_invert;
  if (was_valid && is_valid) {
    if (!patch.fit_fields(mesh, elements_, moved, options)) return Outcome::loses_integral;
  } else if (!fit_tangled(patch, mesh, elements_, moved, options)) {
    patch.fit_fields(mesh, elements_, moved, options, false);  // a change that untangles must not be refused
  }
  transaction.commit();
  return Outcome::done;
}

}  // namespace pliant
