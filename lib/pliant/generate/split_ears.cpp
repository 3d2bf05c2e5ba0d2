// lib/pliant/generate/split_ears.cpp: finds the ears at smooth and reflex corners, and places a point for each.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "pliant/generate/planar_mesh.h"
#include "pliant/generate/tame_spans.h"
#include "pliant/geometry/predicates.h"

namespace pliant {
namespace {

constexpr int most_steps = 100;  // triangles behind an ear that are passed through
constexpr double pi = std::numbers::pi;

/// Is an element at this corner never valid, or valid only by the last bits? Or is the corner so nearly flat that a
/// curved element can hardly be good there, while its chords hide that from every measure of straight triangles?
bool is_bad(const CornerAngle& corner) {
  return corner.curved >= pi - 1e-7 || (corner.curved > 5 * pi / 6 && corner.curved - corner.logical > pi / 180);
}

/// The parameter at which the ray from `from` meets the line through a and b; infinite if it does not.
double ray_meets(const Point& from, const Vector& along, const Point& a, const Point& b) {
  const double denominator = cross(along, b - a);
  const double s = cross(a - from, b - a) / denominator;
  return std::isfinite(s) && s > 0 ? s : HUGE_VAL;
}

class EarSplitter {
 public:
  EarSplitter(const BoundarySpans& spans, const PlanarMesh& mesh) : spans_(spans), mesh_(mesh) {}

  std::vector<Point> run() {
    std::vector<Point> points;
    split_by_.assign(mesh_.corners.size(), {});
    has_point_.assign(mesh_.corners.size(), false);
    const int half_edges = static_cast<int>(mesh_.twins.size());
    for (int h = 0; h < half_edges; ++h) {
      const int back = previous(h);
      if (mesh_.span(h) < 0 || mesh_.span(back) < 0) continue;
      const CornerAngle corner = angle_at(spans_, mesh_, h);
      if (!is_bad(corner) || is_split(h / 3)) continue;
      points.push_back(place(h, corner));
    }
    return points;
  }

 private:
  static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static int previous(int h) { return h % 3 == 0 ? h + 2 : h - 1; }
  const Point& at(int node) const { return mesh_.points[static_cast<std::size_t>(node)]; }

  /// Does the circumcircle of this triangle contain a point that was placed already, in it or in a neighbour?
  bool is_split(int t) const {
    const auto holds = [&](int other) {
      if (!has_point_[static_cast<std::size_t>(other)]) return false;
      return in_circle(at(mesh_.origin(3 * t)), at(mesh_.origin(3 * t + 1)), at(mesh_.origin(3 * t + 2)),
                       split_by_[static_cast<std::size_t>(other)]) > 0;
    };
    if (holds(t)) return true;
    for (int h = 3 * t; h < 3 * t + 3; ++h)
      if (mesh_.span(h) < 0 && mesh_.twin(h) >= 0 && holds(mesh_.twin(h) / 3)) return true;
    return false;
  }

  /// Places a point on the bisector of the tangents, at 0.8 of the shorter leg's length from the corner, or half way to
  /// a curve that stands nearer.
  Point place(int h, const CornerAngle& corner) {
    const Point origin = at(mesh_.origin(h));
    const BoundarySpan& span = spans_[static_cast<std::size_t>(mesh_.span(h))];
    const Vector tangent =
        tangent_at_end(spans_.polygon(static_cast<std::size_t>(mesh_.span(h))), span.from == mesh_.origin(h));
    const double half = corner.curved / 2, norm = length(tangent);
    const Vector along{(tangent.x * std::cos(half) - tangent.y * std::sin(half)) / norm,
                       (tangent.x * std::sin(half) + tangent.y * std::cos(half)) / norm};
    const int opposite = next(h), a = mesh_.origin(opposite), b = mesh_.target(opposite);
    const double leg = std::min(distance(origin, at(a)), distance(origin, at(b)));
    // Walks on through the triangles behind, as far as no curve stands in the way.
    double reach = 0.8 * leg;
    int leave = opposite;
    for (int step = 0; step < most_steps; ++step) {
      const double leaves = ray_meets(origin, along, at(mesh_.origin(leave)), at(mesh_.target(leave)));
      if (reach < leaves) break;
      if (mesh_.span(leave) >= 0 || mesh_.twin(leave) < 0 || step + 1 == most_steps) {
        reach = std::min(reach, leaves / 2);
        break;
      }
      const int g = mesh_.twin(leave);
      const Vector tip = at(mesh_.origin(previous(g))) - origin;
      leave = cross(along, tip) > 0 ? next(g) : previous(g);
    }
    const Point result = origin + reach * along;
    for (const int holder : {h / 3, leave / 3}) {
      has_point_[static_cast<std::size_t>(holder)] = true;
      split_by_[static_cast<std::size_t>(holder)] = result;
    }
    return result;
  }

  const BoundarySpans& spans_;
  const PlanarMesh& mesh_;
  std::vector<Point> split_by_;
  std::vector<bool> has_point_;
};

}  // namespace

CornerAngle angle_at(const BoundarySpans& spans, const PlanarMesh& mesh, int half_edge) {
  const int back = half_edge % 3 == 0 ? half_edge + 2 : half_edge - 1, node = mesh.origin(half_edge);
  const auto tangent = [&](int s) {
    const auto i = static_cast<std::size_t>(s);
    return tangent_at_end(spans.polygon(i), spans[i].from == node);
  };
  const auto turn = [](const Vector& a, const Vector& b) { return std::atan2(cross(a, b), dot(a, b)); };
  const auto at = [&](int v) {
    return mesh.points[static_cast<std::size_t>(v)] - mesh.points[static_cast<std::size_t>(node)];
  };
  CornerAngle angle{turn(at(mesh.target(half_edge)), at(mesh.origin(back))),
                    turn(tangent(mesh.span(half_edge)), tangent(mesh.span(back)))};
  if (angle.curved < angle.logical - pi) angle.curved += 2 * pi;
  return angle;
}

std::vector<Point> points_for_ears(const BoundarySpans& spans, const PlanarMesh& mesh) {
  return EarSplitter(spans, mesh).run();
}

}  // namespace pliant
