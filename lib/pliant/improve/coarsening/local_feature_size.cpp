// lib/pliant/improve/coarsening/local_feature_size.cpp: samples the curves, and takes the disks that touch them there.
#include "pliant/improve/coarsening/local_feature_size.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "pliant/geometry/index.h"
#include "pliant/geometry/placement/touching_disks.h"

namespace pliant {
namespace {

constexpr double corner_angle = 0.05;  // radians: a curve has a corner where its tangents differ by more

Vector unit(const Vector& v) {
  const double size = length(v);
  return size > 0 ? v / size : Vector{};
}

/// Samples of curves at vertices and at the middles of spans. The curves are cut into stretches at their corners.
struct Sampling {
  std::vector<CurveSample> samples;
  std::vector<std::array<PointId, 2>> vertices;  // the vertices whose size each sample bounds
  std::vector<CurveStretch> stretches;

  void add(const Point& place, const Vector& tangent, PointId v, PointId w) {
    samples.push_back({place, unit(tangent), static_cast<int>(stretches.size()) - 1});
    vertices.push_back({v, w});
  }
  void add_curve(const Mesh& mesh, const BSpline& spline, const CurveChain& chain);
};

/// Which vertices of a chain are corners. The ends of an open curve count as corners. A closed curve with a single
/// corner gets a second one, so that the two sides of the corner belong to two stretches.
std::vector<bool> corners_of(const BSpline& spline, const CurveChain& chain) {
  const std::size_t count = chain.vertices.size();
  std::vector<bool> is_corner(count, false);
  for (std::size_t k = 0; k < count; ++k) {
    if (!chain.closed && (k == 0 || k + 1 == count)) {
      is_corner[k] = true;
      continue;
    }
    const double into = k == 0 ? spline.last_parameter() : chain.breaks[k];
    const Vector before = spline.derivative(into, true), after = spline.derivative(chain.breaks[k]);
    is_corner[k] = std::abs(std::atan2(cross(before, after), dot(before, after))) > corner_angle;
  }
  const auto first = std::find(is_corner.begin(), is_corner.end(), true);
  if (first != is_corner.end() && std::count(first, is_corner.end(), true) == 1)
    is_corner[(static_cast<std::size_t>(first - is_corner.begin()) + count / 2) % count] = true;
  return is_corner;
}

void Sampling::add_curve(const Mesh& mesh, const BSpline& spline, const CurveChain& chain) {
  const std::size_t count = chain.vertices.size(), spans = chain.closed ? count : count - 1;
  const std::vector<bool> is_corner = corners_of(spline, chain);
  const auto first = static_cast<std::size_t>(std::find(is_corner.begin(), is_corner.end(), true) - is_corner.begin());
  const std::size_t start = first == count ? 0 : first;
  for (std::size_t step = 0; step < spans; ++step) {
    const std::size_t k = (start + step) % count, next = (k + 1) % count;
    const PointId v = chain.vertices[k], w = chain.vertices[next];
    if (step == 0 || is_corner[k]) stretches.push_back({is_corner[k] ? v : -1, -1});
    if (is_corner[next]) stretches.back().last = w;
    const double to = k + 1 < chain.breaks.size() ? chain.breaks[k + 1] : spline.last_parameter();
    const double middle = (chain.breaks[k] + to) / 2;
    add(mesh.point(v), is_corner[k] ? Vector{} : spline.derivative(chain.breaks[k]), v, v);
    add(spline.evaluate(middle), spline.derivative(middle), v, w);
    if (is_corner[next]) add(mesh.point(w), {}, w, w);
  }
}

}  // namespace

std::vector<double> local_feature_sizes(const Mesh& mesh, const std::vector<CurveChain>& chains) {
  Sampling sampling;
  for (std::size_t c = 0; c < chains.size(); ++c)
    if (!chains[c].vertices.empty()) sampling.add_curve(mesh, mesh.boundary().curves[c].spline, chains[c]);
  const std::vector<double> radii = touching_disks(sampling.samples, sampling.stretches, mesh.size());
  std::vector<double> sizes(index(mesh.point_slots()), HUGE_VAL);
  for (std::size_t k = 0; k < radii.size(); ++k)
    for (const PointId v : sampling.vertices[k]) sizes[index(v)] = std::min(sizes[index(v)], radii[k]);
  return sizes;
}

}  // namespace pliant
