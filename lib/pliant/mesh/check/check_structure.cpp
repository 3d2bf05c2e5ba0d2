// lib/pliant/mesh/check/check_structure.cpp: checks M1, M2, M4, M5, M6 from a document's arrays, without class Mesh.
#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "pliant/boundary/check_boundary.h"
#include "pliant/geometry/describe.h"
#include "pliant/geometry/index.h"
#include "pliant/mesh/check/lone_vertices.h"
#include "pliant/mesh/check_mesh.h"
#include "pliant/mesh/half_edges.h"

namespace pliant {
namespace {

class Checker {
 public:
  Checker(const MeshData& data, const HalfEdges& half_edges, int limit)
      : data_(data),
        limit_(limit),
        layout_(NetLayout::of(data.degree)),
        n_(index(layout_.size())),
        triangles_(static_cast<TriangleId>(data.triangle_faces.size())),
        half_edges_(half_edges) {}

  std::vector<Fault> run() {
    for (Fault fault : check_boundary(data_.boundary)) {
      fault.place = "/boundary" + fault.place;
      faults_.push_back(std::move(fault));
    }
    if (!half_edges_.is_sound()) {
      check_edges();
      check_point_uses();
      check_stars();
    }
    check_curves();
    for (const LoneVertex& each : find_lone_vertices(data_))
      if (each.point == none)
        fault("M4", "/boundary/vertices/" + std::to_string(2 * each.vertex),
              "no vertex of the mesh is at this vertex of the boundary");
    check_faces();
    check_fields();
    return std::move(faults_);
  }

 private:
  void fault(const char* invariant, std::string place, std::string text) {
    if (++counts_[invariant] <= limit_) faults_.push_back({invariant, std::move(place), std::move(text)});
  }
  std::string place_of(TriangleId t) const { return "/triangles/" + std::to_string(index(t) * n_); }
  static std::string point_place(std::size_t p) { return "/points/" + std::to_string(2 * p); }
  PointId entry(TriangleId t, int k) const { return data_.triangles[index(t) * n_ + index(k)]; }
  PointId corner(TriangleId t, int c) const { return entry(t, c); }
  PointId edge_point(HalfEdgeId h, int k) const { return entry(triangle_of(h), layout_.edge_index(edge_of(h), k)); }
  HalfEdgeId twin(HalfEdgeId h) const { return half_edges_.twin(h); }
  PointId origin(HalfEdgeId h) const { return corner(triangle_of(h), edge_of(h)); }
  PointId target(HalfEdgeId h) const { return origin(next(h)); }
  std::string edge_text(HalfEdgeId h) const {
    return "the edge of points " + std::to_string(origin(h)) + " and " + std::to_string(target(h)) + " (triangle " +
           std::to_string(triangle_of(h)) + ")";
  }

  /// M1 for shared edges, M2 for edges with too many triangles.
  void check_edges() {
    const EdgeUses& uses = half_edges_.uses();
    for (std::size_t e = 0; e < uses.count(); ++e) {
      const std::span<const HalfEdgeId> all = uses.of(e);
      if (origin(all[0]) == target(all[0])) {
        for (const HalfEdgeId h : all) fault("M2", place_of(triangle_of(h)), "two corners are the same point");
        continue;
      }
      const HalfEdgeId back = twin(all[0]);
      for (const HalfEdgeId h : all.subspan(1))
        if (h != back) fault("M2", place_of(triangle_of(h)), edge_text(h) + " has another triangle on the same side");
      if (back != none) check_shared_points(all[0], back);
    }
  }
  void check_shared_points(HalfEdgeId h, HalfEdgeId g) {
    for (int k = 0; k <= data_.degree; ++k)
      if (edge_point(h, k) != edge_point(g, data_.degree - k)) {
        fault("M1", place_of(triangle_of(h)),
              edge_text(h) + " has other control points in triangle " + std::to_string(triangle_of(g)));
        return;
      }
  }
  /// Every point is a corner, or one place inside one edge, or inside one triangle.
  void check_point_uses() {
    // unused: -1; corner: 0; in an edge: 1 + the position among the inner points of all half-edges; interior: -2 - t
    std::vector<std::int64_t> use(data_.points.size(), -1);
    const std::int64_t inside = data_.degree - 1;
    for (TriangleId t = 0; t < triangles_; ++t)
      for (int k = 0; k < layout_.size(); ++k) {
        const PointId p = entry(t, k);
        std::int64_t now = 0;
        if (k >= 3 && k < layout_.first_interior()) {
          const HalfEdgeId h = half_edge(t, static_cast<int>((k - 3) / inside)), g = twin(h);
          const std::int64_t along = (k - 3) % inside;  // counted from the other end where the twin is the lower one
          now = 1 + (g != none && g < h ? as_int(g) * inside + inside - 1 - along : as_int(h) * inside + along);
        } else if (k >= 3) {
          now = -2 - static_cast<std::int64_t>(t);
        }
        if (use[index(p)] == -1) {
          use[index(p)] = now;
        } else if (use[index(p)] != now || now < -1) {
          fault("M1", "/triangles/" + std::to_string(index(t) * n_ + index(k)),
                "point " + std::to_string(p) + " is used in two places that are not the same corner or edge");
        }
      }
    for (std::size_t p = 0; p < use.size(); ++p)
      if (use[p] == -1) fault("M1", "/points/" + std::to_string(2 * p), "point " + std::to_string(p) + " is not used");
  }

  /// M2: the triangles around each vertex are one disk, or half-disks.
  void check_stars() {
    std::vector<std::int32_t> corners(data_.points.size()), in_open(data_.points.size());
    std::vector<HalfEdgeId> leaving(data_.points.size(), none);
    for (const HalfEdgeId h : data_.half_edges()) {
      ++corners[index(origin(h))];
      if (leaving[index(origin(h))] == none) leaving[index(origin(h))] = h;
    }
    for (const HalfEdgeId h : data_.half_edges()) {
      if (twin(h) != none) continue;
      std::int32_t& seen = in_open[index(origin(h))];
      for (HalfEdgeId g = h; g != none && seen <= corners[index(origin(h))]; g = twin(previous(g))) ++seen;
    }
    for (std::size_t v = 0; v < corners.size(); ++v) {
      if (corners[v] == 0) continue;
      if (in_open[v] > 0) {
        if (in_open[v] != corners[v])
          fault("M2", point_place(v), "the triangles around point " + std::to_string(v) + " are no half-disks");
        continue;
      }
      std::int32_t turned = 0;
      HalfEdgeId h = leaving[v];
      do {
        ++turned;
        h = twin(previous(h));
      } while (h != none && h != leaving[v] && turned <= corners[v]);
      if (turned != corners[v])
        fault("M2", point_place(v), "the triangles around point " + std::to_string(v) + " are not one disk");
    }
  }

  /// How far the ends of a span move if a knot changes by a unit in the last place of the largest knot. Knots that are
  /// large beside the span are rounded so when a period is added.
  static double knot_rounding(const BSpline& spline, const std::vector<double>& breaks, int span) {
    const double knot = std::max(std::fabs(breaks.front()), std::fabs(breaks.back()));
    const double speed = std::max(length(spline.derivative(breaks[index(span)])),
                                  length(spline.derivative(breaks[index(span + 1)], true)));
    return 0x1p-51 * knot * speed;
  }

  /// M4: constrained edges are the spans of their curves.
  void check_curves() {
    // Relative to the boundary, not the mesh: a tangled element that reaches far out would make the mesh's tolerance
    // so large that faults went unnoticed.
    const double tolerance = bounding_box(data_.boundary).tolerance();
    std::vector<std::vector<double>> breaks;
    std::vector<std::vector<char>> covered;
    for (std::size_t c = 0; c < data_.boundary.curves.size(); ++c) {
      const BSpline& spline = data_.boundary.curves[c].spline;
      breaks.push_back(spline.breaks());
      covered.emplace_back(index(spline.span_count()), 0);
      if (spline.degree() != data_.degree)
        fault("M4", "/boundary/curves/" + std::to_string(c) + "/degree",
              "is " + std::to_string(spline.degree()) + "; the mesh has degree " + std::to_string(data_.degree));
    }
    std::vector<Point> wanted(index(data_.degree) + 1);
    for (std::size_t k = 0; k < data_.constrained_edges.size(); ++k) {
      const ConstrainedEdge& edge = data_.constrained_edges[k];
      const std::string place = "/constrained_edges/" + std::to_string(k);
      const auto [forward, backward] = half_edges_.along(edge.points);
      if (forward == none && backward == none) {
        fault("M4", place + "/points", "is no edge of a triangle");
        continue;
      }
      for (const HalfEdgeId h : {forward, backward})
        if (h != none) constrained_.emplace_back(h, k);
      for (int i = 0; i <= data_.degree; ++i) {
        const PointId p = forward != none ? edge_point(forward, i) : edge_point(backward, data_.degree - i);
        if (p != edge.points[index(i)]) {
          fault("M4", place + "/points/" + std::to_string(i), "differs from the triangle's control point");
          break;
        }
      }
      if (covered[index(edge.curve)][index(edge.span)]++)
        fault("M4", place + "/span", "this span of the curve has an edge already");
      const BSpline& spline = data_.boundary.curves[index(edge.curve)].spline;
      if (spline.degree() != data_.degree) continue;
      spline.extract(breaks[index(edge.curve)][index(edge.span)], wanted);
      for (int i = 0; i <= data_.degree; ++i) {
        const double off = distance(wanted[index(i)], data_.points[index(edge.points[index(i)])]);
        if (!(off <= tolerance) && !(off <= tolerance + knot_rounding(spline, breaks[index(edge.curve)], edge.span))) {
          fault("M4", "/points/" + std::to_string(2 * edge.points[index(i)]),
                "is " + describe_number(off, 1e-3 * off) + " away from where span " + std::to_string(edge.span) +
                    " of curve " + std::to_string(edge.curve) + " has it");
          break;
        }
      }
    }
    for (std::size_t c = 0; c < covered.size(); ++c)
      for (std::size_t s = 0; s < covered[c].size(); ++s)
        if (!covered[c][s])
          fault("M4", "/boundary/curves/" + std::to_string(c),
                "span " + std::to_string(s) + " has no constrained edge");
  }

  /// M5: faces are separated by constrained edges and by nothing else. Also finds edges that are listed twice (M4).
  void check_faces() {
    std::sort(constrained_.begin(), constrained_.end());
    auto next_constrained = constrained_.begin();
    for (const HalfEdgeId h : data_.half_edges()) {
      const bool is_constrained = next_constrained != constrained_.end() && next_constrained->first == h;
      if (!is_constrained && !half_edges_.is_border(h)) continue;
      const HalfEdgeId g = twin(h);
      const FaceId mine = data_.triangle_faces[index(triangle_of(h))];
      if (!is_constrained) {
        fault("M5", place_of(triangle_of(h)),
              edge_text(h) + (g == none ? " is on the outer boundary but on no curve"
                                        : " separates two faces but is on no curve"));
        continue;
      }
      const std::size_t k = next_constrained->second;
      while (++next_constrained != constrained_.end() && next_constrained->first == h)
        fault("M4", "/constrained_edges/" + std::to_string(next_constrained->second), "this edge is listed twice");
      const ConstrainedEdge& edge = data_.constrained_edges[k];
      const Curve& curve = data_.boundary.curves[index(edge.curve)];
      const bool forward = origin(h) == edge.points.front();
      if ((forward ? curve.left : curve.right) != mine)
        fault("M5", "/triangle_faces/" + std::to_string(triangle_of(h)),
              "differs from the face that curve " + std::to_string(edge.curve) + " names on its " +
                  (forward ? "left" : "right"));
      if (g == none && (forward ? curve.right : curve.left) != outside)
        fault("M5", place_of(triangle_of(h)), edge_text(h) + " has no triangle on the other side of its curve");
    }
  }

  /// M6: fields by face have one value per control point and face around it.
  void check_fields() {
    std::vector<std::array<std::int32_t, 2>> wanted;
    for (std::size_t k = 0; k < data_.fields.size(); ++k) {
      const Field& field = data_.fields[k];
      const std::string place = "/fields/" + std::to_string(k);
      for (std::size_t other = 0; other < k; ++other)
        if (data_.fields[other].name == field.name)
          fault("M6", place + "/name", "there is a field of this name already");
      if (!field.by_face) continue;
      if (wanted.empty()) {
        for (TriangleId t = 0; t < triangles_; ++t)
          for (int i = 0; i < layout_.size(); ++i) wanted.push_back({entry(t, i), data_.triangle_faces[index(t)]});
        std::sort(wanted.begin(), wanted.end());
        wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
      }
      if (field.places != wanted)
        fault("M6", place + "/places", "is not the sorted list of every control point with each face around it");
    }
  }

  const MeshData& data_;
  int limit_;
  const NetLayout& layout_;
  std::size_t n_;
  TriangleId triangles_;
  std::vector<Fault> faults_;
  std::map<std::string, int> counts_;
  const HalfEdges& half_edges_;
  std::vector<std::pair<HalfEdgeId, std::size_t>> constrained_;  // half-edge, number of its constrained edge
};

}  // namespace

std::vector<Fault> check_structure(const MeshData& data, int limit) {
  return check_structure(data, HalfEdges(data), limit);
}

std::vector<Fault> check_structure(const MeshData& data, const HalfEdges& half_edges, int limit) {
  return Checker(data, half_edges, limit).run();
}

}  // namespace pliant
