// formats/picture/isolines/isolines.cpp: curves on which a field has one value, across the elements of a mesh.
#include "formats/picture/isolines/isolines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "formats/picture/isolines/element_tracer.h"
#include "formats/picture/isolines/sign_changes.h"
#include "pliant/geometry/control_net.h"
#include "pliant/geometry/net_layout.h"

namespace pliant {
namespace {

/// Rounding of control values must not draw an isoline through a region where the field is that value: the isoline
/// is that of a value which is so much less (values are at most 1).
constexpr double below = 0x1p-49;

class MeshTracer {
 public:
  MeshTracer(const MeshData& mesh, const MeshEdges& edges, FieldPolynomial& polynomial, double value, double tolerance)
      : mesh_(mesh),
        edges_(edges),
        polynomial_(polynomial),
        level_(value - below * std::max(1.0, std::abs(value))),
        tolerance_(tolerance) {}

  IsolineSet trace(const std::function<bool(TriangleId)>& in_element) {
    IsolineSet set;
    for (TriangleId t = 0; t < static_cast<TriangleId>(mesh_.triangle_faces.size()); ++t) {
      if (in_element && !in_element(t)) continue;
      ElementToTrace element{mesh_.degree, {}, polynomial_.degree(), polynomial_.on_element(t), {}, {}};
      for (double& coefficient : element.field) coefficient -= level_;
      if (has_one_sign(element.field)) continue;
      for (std::size_t c = 0; c < 3; ++c) element.above[c] = element.field[c] >= 0;
      for (int e = 0; e < 3; ++e) element.crossings[static_cast<std::size_t>(e)] = crossings(t, e, element.field);
      if (is_nowhere(element)) continue;
      for (const Point& p : element_net(mesh_, t)) element.geometry.insert(element.geometry.end(), {p.x, p.y});
      set.uncertain += trace_element(element, tolerance_, crossing_count_, arcs_);
    }
    chain(set.lines);
    return set;
  }

 private:
  /// True where neither the coefficients nor the crossings of the edges change their sign.
  static bool is_nowhere(const ElementToTrace& element) {
    const auto [low, high] = std::minmax_element(element.field.begin(), element.field.end());
    return (*low >= 0 || *high < 0) && std::all_of(element.crossings.begin(), element.crossings.end(),
                                                   [](const auto& edge) { return edge.empty(); });
  }
  std::vector<EdgeCrossing> crossings(TriangleId t, int e, const std::vector<double>& field) {
    const HalfEdgeId h = half_edge(t, e);
    const auto number = static_cast<std::size_t>(edges_.of_half_edge[static_cast<std::size_t>(h)]);
    const MeshEdge& edge = edges_.edges[number];
    const auto face = [this](TriangleId of) { return mesh_.triangle_faces[static_cast<std::size_t>(of)]; };
    const bool jumps =
        polynomial_.depends_on_face() && edge.sides[1] != none && face(edge.sides[0]) != face(edge.sides[1]);
    const std::pair key(number, jumps && edge.sides[1] == t ? 1 : 0);
    const auto corner = [&](int c) {
      return mesh_.triangles[static_cast<std::size_t>(t * net_size(mesh_.degree) + c % 3)];
    };
    const bool forward = corner(e) < corner(e + 1);
    const auto [place, is_new] = on_edges_.try_emplace(key);
    if (is_new) {
      std::vector<double> along = polynomial_.on_edge(t, e), polygon;
      for (double& coefficient : along) coefficient -= level_;
      const NetLayout& layout = NetLayout::of(mesh_.degree);
      const std::vector<Point> net = element_net(mesh_, t);
      for (int k = 0; k <= mesh_.degree; ++k) {
        const Point& p = net[static_cast<std::size_t>(layout.edge_index(e, forward ? k : mesh_.degree - k))];
        polygon.insert(polygon.end(), {p.x, p.y});
      }
      const auto above = [&](int c) { return field[static_cast<std::size_t>(c % 3)] >= 0; };
      for (const double s : sign_changes(along, above(forward ? e : e + 1), above(forward ? e + 1 : e))) {
        std::array<double, 2> at{};
        evaluate_polygon(mesh_.degree, 2, polygon, s, at);
        place->second.push_back({s, crossing_count_++, {at[0], at[1]}});
      }
    }
    std::vector<EdgeCrossing> result = place->second;
    if (!forward) {
      std::reverse(result.begin(), result.end());
      for (EdgeCrossing& crossing : result) crossing.s = 1 - crossing.s;
    }
    return result;
  }

  bool is_small(const Isoline& line) const {
    Box box;
    for (const std::vector<Point>& curve : line.curves)
      for (const Point& p : curve) box.extend(p);
    return box.size() <= tolerance_;
  }
  /// Joins the arcs at their crossings. Lines that end at a border come first, then closed ones.
  void chain(std::vector<Isoline>& lines) const {
    constexpr auto nothing = static_cast<std::size_t>(-1);
    std::vector<std::size_t> begins(crossing_count_, nothing);
    std::vector<bool> ends(crossing_count_, false), used(arcs_.size(), false);
    for (std::size_t a = 0; a < arcs_.size(); ++a) begins[arcs_[a].from] = a, ends[arcs_[a].to] = true;
    const auto follow = [&](std::size_t first) {
      Isoline line;
      std::size_t at = first;
      while (at != nothing && !used[at]) {
        used[at] = true;
        line.curves.insert(line.curves.end(), arcs_[at].curves.begin(), arcs_[at].curves.end());
        if (arcs_[at].to == arcs_[first].from) line.closed = true;
        at = begins[arcs_[at].to];
      }
      // Where a curve crosses itself, the pieces that are joined straight may make a loop of their own size.
      if (!line.curves.empty() && !(line.closed && is_small(line))) lines.push_back(std::move(line));
    };
    for (std::size_t a = 0; a < arcs_.size(); ++a)
      if (!ends[arcs_[a].from]) follow(a);
    for (std::size_t a = 0; a < arcs_.size(); ++a)
      if (!used[a]) follow(a);
  }

  const MeshData& mesh_;
  const MeshEdges& edges_;
  FieldPolynomial& polynomial_;
  double level_, tolerance_;
  std::map<std::pair<std::size_t, int>, std::vector<EdgeCrossing>> on_edges_;
  std::size_t crossing_count_ = 0;
  std::vector<IsolineArc> arcs_;
};

}  // namespace

IsolineSet trace_isoline(const MeshData& mesh, const MeshEdges& edges, FieldPolynomial& polynomial, double value,
                         double tolerance, const std::function<bool(TriangleId)>& in_element) {
  return MeshTracer(mesh, edges, polynomial, value, tolerance).trace(in_element);
}

}  // namespace pliant
