// lib/pliant/fem/measures/outline.cpp: sums of Gauss rules over edges.
#include "pliant/fem/measures/outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "pliant/fem/measures/segment_extremes.h"
#include "pliant/geometry/bernstein.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/quadrature.h"

namespace pliant {
namespace {

/// The points of a rule along an edge of some degree: a Gauss rule on each half.
class EdgeRule {
 public:
  explicit EdgeRule(const Mesh& mesh) : mesh_(mesh), degree_(mesh.degree()), polygon_(index(degree_) + 1) {
    constexpr int exact_degree = 40;
    for (const double start : {0.0, 0.5})
      for (const SegmentNode& node : segment_rule(exact_degree))
        nodes_.push_back({start + node.s / 2, node.weight / 2});
    const std::size_t n = polygon_.size();
    values_.resize(nodes_.size() * n);
    slopes_.assign(nodes_.size() * n, 0.0);
    std::vector<double> lower(n - 1);
    for (std::size_t q = 0; q < nodes_.size(); ++q) {
      bernstein_basis(degree_, nodes_[q].s, std::span(values_).subspan(q * n, n));
      bernstein_basis(degree_ - 1, nodes_[q].s, lower);
      for (std::size_t k = 0; k + 1 < n; ++k) {
        slopes_[q * n + k] -= degree_ * lower[k];
        slopes_[q * n + k + 1] += degree_ * lower[k];
      }
    }
  }

  /// Calls use(place, step, s) for each point of the rule: `step` is the derivative along the passage times the weight,
  /// and s runs along the half-edge. All in the units of the mesh.
  template <class Use>
  void pass(const OutlineEdge& edge, const Use& use) {
    mesh_.gather_edge_points(edge.half_edge, polygon_);
    const std::size_t n = polygon_.size();
    for (std::size_t q = 0; q < nodes_.size(); ++q) {
      Point place;
      Vector slope;
      for (std::size_t k = 0; k < n; ++k) {
        place += values_[q * n + k] * polygon_[k];
        slope += slopes_[q * n + k] * polygon_[k];
      }
      use(place, (edge.is_backward ? -nodes_[q].weight : nodes_[q].weight) * slope, nodes_[q].s);
    }
  }

 private:
  const Mesh& mesh_;
  int degree_;
  std::vector<SegmentNode> nodes_;
  std::vector<double> values_, slopes_;
  std::vector<Point> polygon_;
};

/// A place on a half-edge, in its triangle.
Barycentric on_edge(HalfEdgeId h, double s) {
  Barycentric xi{0, 0, 0};
  xi[index(edge_of(h))] = 1 - s;
  xi[index((edge_of(h) + 1) % 3)] = s;
  return xi;
}

/// The control values of a field along a half-edge.
void gather_edge_values(const Mesh& mesh, const MeshFunction& field, HalfEdgeId h, std::span<double> values) {
  for (int k = 0; k <= mesh.degree(); ++k)
    values[index(k)] = field.control_values()[index(mesh.layout().edge_index(edge_of(h), k))];
}

Point first_point(const Mesh& mesh, const Outline& outline) { return mesh.point(mesh.origin(outline[0].half_edge)); }

}  // namespace

Outline outline_of_face(const Mesh& mesh, FaceId face) {
  Outline outline;
  for (const HalfEdgeId h : mesh.half_edges()) {
    const TriangleId t = triangle_of(h);
    if (!mesh.is_alive(t) || (face != every_face && mesh.face(t) != face)) continue;
    const HalfEdgeId twin = mesh.twin(h);
    if (twin == none || (face != every_face && mesh.face(triangle_of(twin)) != face)) outline.push_back({h});
  }
  return outline;
}

Outline outline_of_curves(const Mesh& mesh, std::span<const CurveId> curves) {
  Outline outline;
  for (const HalfEdgeId h : mesh.half_edges()) {
    if (!mesh.is_alive(triangle_of(h)) || !mesh.is_constrained(h)) continue;
    const CurveId c = mesh.constraint_curve(mesh.constraint(h));
    if (std::ranges::find(curves, c) == curves.end()) continue;
    const bool forward = mesh.runs_forward(h), outer = mesh.twin(h) == none;
    if (forward || outer) outline.push_back({h, !forward, outer && forward ? -1.0 : 1.0});
  }
  return outline;
}

double measure_length(const Mesh& mesh, const Outline& outline) {
  EdgeRule rule(mesh);
  double sum = 0;
  for (const OutlineEdge& edge : outline)
    rule.pass(edge, [&](const Point&, const Vector& step, double) { sum += length(step); });
  return mesh.boundary().unit * sum;
}

Point centre_of_line(const Mesh& mesh, const Outline& outline) {
  EdgeRule rule(mesh);
  double sum = 0;
  Vector moment;
  const Point near = first_point(mesh, outline);
  for (const OutlineEdge& edge : outline)
    rule.pass(edge, [&](const Point& place, const Vector& step, double) {
      sum += length(step);
      moment += length(step) * (place - near);
    });
  return mesh.boundary().unit * (near + moment / sum);
}

double integrate(MeshFunction& function, const Mesh& mesh, const Outline& outline) {
  EdgeRule rule(mesh);
  double sum = 0;
  for (const OutlineEdge& edge : outline) {
    function.set(triangle_of(edge.half_edge));
    rule.pass(edge, [&](const Point&, const Vector& step, double s) {
      sum += length(step) * function.at(on_edge(edge.half_edge, s));
    });
  }
  return mesh.boundary().unit * sum;
}

double integrate_flux(MeshFunction& along_x, MeshFunction& along_y, const Mesh& mesh, const Outline& outline) {
  EdgeRule rule(mesh);
  double sum = 0;
  for (const OutlineEdge& edge : outline) {
    along_x.set(triangle_of(edge.half_edge));
    along_y.set(triangle_of(edge.half_edge));
    rule.pass(edge, [&](const Point&, const Vector& step, double s) {
      const Barycentric xi = on_edge(edge.half_edge, s);
      sum += edge.crossing * cross({along_x.at(xi), along_y.at(xi)}, step);
    });
  }
  return mesh.boundary().unit * sum;
}

std::optional<Range> bounds(MeshFunction& field, const Mesh& mesh, const Outline& outline) {
  constexpr double width = 1e-12;
  if (outline.empty()) return {};
  std::vector<double> values(index(mesh.degree()) + 1);
  const auto gather = [&](const OutlineEdge& edge) {
    field.set(triangle_of(edge.half_edge));
    gather_edge_values(mesh, field, edge.half_edge, values);
  };
  gather(outline[0]);
  Range hull{values[0], values[0]};
  for (const OutlineEdge& edge : outline) {
    gather(edge);
    const auto [low, high] = std::ranges::minmax(values);
    hull = {std::min(hull.least, low), std::max(hull.greatest, high)};
  }
  // Below the rounding of the values nothing would be told apart, and halving would go on over noise.
  constexpr double rounding = 4e-15;
  const double allowed = std::max(width * (hull.greatest - hull.least),
                                  rounding * std::max(std::abs(hull.greatest), std::abs(hull.least)));
  SegmentMaximum greatest(allowed), least(allowed);
  for (std::size_t e = 0; e < outline.size(); ++e) {
    gather(outline[e]);
    greatest.take_in(values, e);
    for (double& value : values) value = -value;
    least.take_in(values, e);
  }
  return Range{-least.value(), greatest.value()};
}

bool is_closed(const Mesh& mesh, const Outline& outline) {
  std::vector<std::pair<PointId, int>> passages;
  for (const OutlineEdge& edge : outline) {
    passages.emplace_back(mesh.origin(edge.half_edge), edge.is_backward ? 1 : -1);
    passages.emplace_back(mesh.target(edge.half_edge), edge.is_backward ? -1 : 1);
  }
  std::ranges::sort(passages);
  for (std::size_t k = 0; k < passages.size();) {
    int balance = 0;
    const PointId vertex = passages[k].first;
    for (; k < passages.size() && passages[k].first == vertex; ++k) balance += passages[k].second;
    if (balance != 0) return false;
  }
  return !outline.empty();
}

AreaAndCentre measure_enclosed(const Mesh& mesh, const Outline& outline) {
  EdgeRule rule(mesh);
  double area = 0;
  Vector moment;
  const Point near = first_point(mesh, outline);
  for (const OutlineEdge& edge : outline)
    rule.pass(edge, [&](const Point& place, const Vector& step, double) {
      const Vector arm = place - near;
      const double swept = cross(arm, step) / 2;  // a triangle at `near`, whose centre is two thirds of the arm away
      area += swept;
      moment += (2 * swept / 3) * arm;
    });
  const double unit = mesh.boundary().unit;
  return {unit * unit * area, unit * (near + moment / area)};
}

Reach measure_reach(const Mesh& mesh, const Outline& outline, const Point& place) {
  const int p = mesh.degree();
  const double unit = mesh.boundary().unit;
  const Point centre = place / unit;
  std::vector<Point> polygon(index(p) + 1);
  std::vector<double> xs(polygon.size()), ys(polygon.size()), squares(2 * index(p) + 1), more(squares.size());
  const auto gather = [&](std::size_t e) {
    mesh.gather_edge_points(outline[e].half_edge, polygon);
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      xs[k] = polygon[k].x - centre.x;
      ys[k] = polygon[k].y - centre.y;
    }
    multiply_segment(p, xs, p, xs, squares);
    multiply_segment(p, ys, p, ys, more);
    for (std::size_t k = 0; k < squares.size(); ++k) squares[k] += more[k];
  };
  double size = 0;
  for (std::size_t e = 0; e < outline.size(); ++e) {
    gather(e);
    size = std::max(size, squares[0]);
  }
  constexpr double width = 1e-14;
  SegmentMaximum greatest(width * size), least(width * size);
  for (std::size_t e = 0; e < outline.size(); ++e) {
    gather(e);
    greatest.take_in(squares, e);
    for (double& value : squares) value = -value;
    least.take_in(squares, e);
  }
  gather(greatest.segment());
  greatest.polish(squares);
  mesh.gather_edge_points(outline[greatest.segment()].half_edge, polygon);
  std::vector<double> basis(polygon.size());
  bernstein_basis(p, greatest.s(), basis);
  Point farthest;
  for (std::size_t k = 0; k < polygon.size(); ++k) farthest += basis[k] * polygon[k];
  return {unit * std::sqrt(std::max(0.0, -least.value())), unit * std::sqrt(greatest.value()), unit * farthest};
}

}  // namespace pliant
