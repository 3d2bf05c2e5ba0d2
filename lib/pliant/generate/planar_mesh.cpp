// lib/pliant/generate/planar_mesh.cpp: triangulates all chords, names the face of each triangle, drops what is outside.
#include "pliant/generate/planar_mesh.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <stdexcept>

#include "pliant/generate/tame_spans.h"
#include "pliant/generate/triangulate_boundary.h"

namespace pliant {
namespace {

constexpr int unknown = -2;

std::uint64_t edge_key(int a, int b) {
  const auto low = static_cast<std::uint32_t>(std::min(a, b)), high = static_cast<std::uint32_t>(std::max(a, b));
  return (static_cast<std::uint64_t>(low) << 32) | high;
}

/// Names the face of each triangle by the curves around it, and drops the triangles outside.
class FaceFinder {
 public:
  FaceFinder(const BoundaryComplex& boundary, const BoundarySpans& spans, PlanarMesh& mesh)
      : boundary_(boundary), spans_(spans), mesh_(mesh), root_(mesh.corners.size()) {
    std::iota(root_.begin(), root_.end(), 0);
  }

  std::string run() {
    find_edges();
    std::vector<int> labels(mesh_.corners.size(), unknown);
    const int half_edges = static_cast<int>(mesh_.twins.size());
    for (int h = 0; h < half_edges; ++h) {
      const int s = mesh_.span(h);
      if (s < 0 && mesh_.twin(h) >= 0) continue;
      const int side = s < 0 ? outside : side_of(h, s);
      if (s >= 0 && mesh_.twin(h) < 0) {
        const int beyond = other_side_of(h, s);
        if (beyond != outside) return conflict(h, beyond, outside);
      }
      int& label = labels[static_cast<std::size_t>(find(h / 3))];
      if (label == unknown) label = side;
      if (label != side) return conflict(h, label, side);
    }
    mesh_.faces.resize(mesh_.corners.size());
    for (std::size_t t = 0; t < mesh_.corners.size(); ++t)
      mesh_.faces[t] = labels[static_cast<std::size_t>(find(static_cast<int>(t)))];
    drop_outside();
    return {};
  }

 private:
  /// Finds twins and spans, and joins triangles over unconstrained edges to components.
  void find_edges() {
    std::vector<std::pair<std::uint64_t, int>> chords(spans_.size()), edges(3 * mesh_.corners.size());
    for (std::size_t i = 0; i < spans_.size(); ++i)
      chords[i] = {edge_key(spans_[i].from, spans_[i].to), static_cast<int>(i)};
    std::sort(chords.begin(), chords.end());
    const int half_edges = static_cast<int>(edges.size());
    for (int h = 0; h < half_edges; ++h)
      edges[static_cast<std::size_t>(h)] = {edge_key(mesh_.origin(h), mesh_.target(h)), h};
    std::sort(edges.begin(), edges.end());
    mesh_.twins.assign(edges.size(), -1);
    mesh_.spans.assign(edges.size(), -1);
    auto chord = chords.begin();
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const auto [key, h] = edges[k];
      while (chord != chords.end() && chord->first < key) ++chord;
      if (chord != chords.end() && chord->first == key) mesh_.spans[static_cast<std::size_t>(h)] = chord->second;
      if (k + 1 == edges.size() || edges[k + 1].first != key) continue;
      const int g = edges[k + 1].second;
      mesh_.twins[static_cast<std::size_t>(h)] = g;
      mesh_.twins[static_cast<std::size_t>(g)] = h;
      if (chord == chords.end() || chord->first != key) root_[static_cast<std::size_t>(find(h / 3))] = find(g / 3);
    }
  }

  int find(int t) {
    while (root_[static_cast<std::size_t>(t)] != t) {
      int& up = root_[static_cast<std::size_t>(t)];
      up = root_[static_cast<std::size_t>(up)];
      t = up;
    }
    return t;
  }

  const Curve& curve_of(int s) const {
    return boundary_.curves[static_cast<std::size_t>(spans_[static_cast<std::size_t>(s)].curve)];
  }
  bool runs_forward(int h, int s) const { return mesh_.origin(h) == spans_[static_cast<std::size_t>(s)].from; }
  int side_of(int h, int s) const { return runs_forward(h, s) ? curve_of(s).left : curve_of(s).right; }
  int other_side_of(int h, int s) const { return runs_forward(h, s) ? curve_of(s).right : curve_of(s).left; }

  std::string conflict(int h, int one, int other) const {
    const auto name = [this](int face) {
      return face == outside ? std::string("the outside")
                             : "face '" + boundary_.faces[static_cast<std::size_t>(face)].name + "'";
    };
    const int s = mesh_.span(h);
    const Point a = mesh_.points[static_cast<std::size_t>(mesh_.origin(h))];
    const Point b = mesh_.points[static_cast<std::size_t>(mesh_.target(h))];
    std::string text =
        name(one) + " and " + name(other) + " are not separated by a curve near " + describe_point(a / 2 + b / 2);
    if (s >= 0) text += ", at " + describe_span(boundary_, spans_[static_cast<std::size_t>(s)]);
    return text;
  }

  void drop_outside() {
    std::vector<int> moved(mesh_.corners.size(), -1);
    int kept = 0;
    for (std::size_t t = 0; t < moved.size(); ++t)
      if (mesh_.faces[t] != outside) moved[t] = kept++;
    for (std::size_t t = 0; t < moved.size(); ++t) {
      if (moved[t] < 0) continue;
      const auto to = static_cast<std::size_t>(moved[t]);
      mesh_.corners[to] = mesh_.corners[t];
      mesh_.faces[to] = mesh_.faces[t];
      for (std::size_t e = 0; e < 3; ++e) {
        const int g = mesh_.twins[3 * t + e];
        const int beyond = g < 0 ? -1 : moved[static_cast<std::size_t>(g / 3)];
        mesh_.twins[3 * to + e] = beyond < 0 ? -1 : 3 * beyond + g % 3;
        mesh_.spans[3 * to + e] = mesh_.spans[3 * t + e];
      }
    }
    const auto count = static_cast<std::size_t>(kept);
    mesh_.corners.resize(count);
    mesh_.faces.resize(count);
    mesh_.twins.resize(3 * count);
    mesh_.spans.resize(3 * count);
  }

  const BoundaryComplex& boundary_;
  const BoundarySpans& spans_;
  PlanarMesh& mesh_;
  std::vector<int> root_;
};

}  // namespace

std::string triangulate_faces(const BoundaryComplex& boundary, const BoundarySpans& spans,
                              const std::vector<Point>& free_points, PlanarMesh& mesh) {
  mesh.points = spans.nodes();
  mesh.points.insert(mesh.points.end(), free_points.begin(), free_points.end());
  std::vector<std::array<int, 2>> segments;
  segments.reserve(spans.size());
  for (const BoundarySpan& span : spans.spans()) segments.push_back({span.from, span.to});
  try {
    mesh.corners = triangulate(mesh.points, segments);
  } catch (const TriangulationError& e) {
    const int nodes = static_cast<int>(spans.nodes().size());
    const auto name = [&](int v) {
      return v < nodes ? describe_node(boundary, spans, v)
                       : "an inner point " + describe_point(mesh.points[static_cast<std::size_t>(v)]);
    };
    std::string text =
        "the curves' chords cannot be triangulated, points are too close for doubles: " + name(e.points[0]) + ", and " +
        name(e.points[1]) + ", " + e.how;
    for (const int v : e.others) text += (v == e.others.front() ? " " : ", and ") + name(v);
    return text;
  } catch (const std::invalid_argument& e) {
    return std::string("the curves' chords cannot be triangulated: ") + e.what();
  }
  return FaceFinder(boundary, spans, mesh).run();
}

}  // namespace pliant
