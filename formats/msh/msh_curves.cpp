// formats/msh/msh_curves.cpp: chains of edges become B-splines of the boundary.
#include <algorithm>
#include <map>
#include <numeric>
#include <unordered_map>

#include "formats/msh/msh_mesh.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/net_layout.h"

namespace pliant {
namespace {

class CurveTracer {
 public:
  CurveTracer(const MshFile& file, const std::vector<OpenEdge>& open, MeshData& mesh)
      : file_(file), mesh_(mesh), layout_(NetLayout::of(mesh.degree)) {
    find_marks();
    for (const OpenEdge& edge : open) {
      const PointId* net = net_of(edge.left);
      const PointId from = net[edge_of(edge.left)], to = net[(edge_of(edge.left) + 1) % 3];
      const FaceId right = edge.right == none ? outside : face_of(edge.right);
      edges_.push_back({edge.left, from, to, face_of(edge.left), right, mark_of(from, to)});
    }
  }

  std::vector<std::string> run() {
    link();
    std::vector<char> done(edges_.size(), 0);
    std::vector<std::size_t> chain;
    const auto follow = [&](std::size_t start) {
      chain.clear();
      for (std::size_t e = start; e != no_edge && !done[e]; e = next_[e]) {
        done[e] = 1;
        chain.push_back(e);
      }
    };
    for (std::size_t e = 0; e < edges_.size(); ++e)
      if (previous_[e] == no_edge) {
        follow(e);
        add_curve(chain, false);
      }
    // The edges that are left form loops. A loop of fewer than three edges cannot be a closed curve.
    for (std::size_t e = 0; e < edges_.size(); ++e)
      if (!done[e]) {
        follow(e);
        add_curve(chain, chain.size() >= 3);
      }
    warn();
    return std::move(warnings_);
  }

 private:
  static constexpr std::size_t no_edge = static_cast<std::size_t>(-1);
  struct Edge {
    HalfEdgeId half_edge;
    PointId from, to;
    FaceId left, right;
    int mark;  ///< index into marks_: group and entity of the file's line on this edge; or none
  };
  struct Mark {
    int physical, entity;
  };
  struct LineEnds {
    PointId low, high;
    int mark;
    bool used;
  };

  FaceId face_of(HalfEdgeId h) const { return mesh_.triangle_faces[index(triangle_of(h))]; }
  const PointId* net_of(HalfEdgeId h) const { return &mesh_.triangles[index(triangle_of(h)) * index(layout_.size())]; }

  /// Collects the groups and entities of the file's lines, sorted by the lines' ends. Where two lines have the same
  /// ends, the first counts.
  void find_marks() {
    std::map<std::pair<int, int>, int> numbers;
    lines_.reserve(file_.lines.size());
    for (const MshLine& line : file_.lines) {
      const auto [place, is_new] =
          numbers.emplace(std::pair(line.physical, line.entity), static_cast<int>(marks_.size()));
      if (is_new) marks_.push_back({line.physical, line.entity});
      lines_.push_back({std::min(line.from, line.to), std::max(line.from, line.to), place->second, false});
    }
    std::stable_sort(lines_.begin(), lines_.end(), [](const LineEnds& a, const LineEnds& b) {
      return a.low != b.low ? a.low < b.low : a.high < b.high;
    });
    const auto same = [](const LineEnds& a, const LineEnds& b) { return a.low == b.low && a.high == b.high; };
    lines_.erase(std::unique(lines_.begin(), lines_.end(), same), lines_.end());
  }

  int mark_of(PointId a, PointId b) {
    const LineEnds wanted{std::min(a, b), std::max(a, b), none, false};
    const auto found = std::lower_bound(lines_.begin(), lines_.end(), wanted, [](const LineEnds& x, const LineEnds& y) {
      return x.low != y.low ? x.low < y.low : x.high < y.high;
    });
    if (found == lines_.end() || found->low != wanted.low || found->high != wanted.high) return none;
    found->used = true;
    return found->mark;
  }

  /// Links edges into chains: one edge follows another where no third meets them, and both separate the same faces and
  /// have the same mark.
  void link() {
    struct Meeting {
      int edges = 0;
      std::size_t in = no_edge, out = no_edge;
    };
    std::unordered_map<PointId, Meeting> meetings;
    meetings.reserve(edges_.size());
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      Meeting& start = meetings[edges_[e].from];
      ++start.edges;
      start.out = e;
      Meeting& end = meetings[edges_[e].to];
      ++end.edges;
      end.in = e;
    }
    next_.assign(edges_.size(), no_edge);
    previous_.assign(edges_.size(), no_edge);
    for (const auto& [vertex, meeting] : meetings) {
      if (meeting.edges != 2 || meeting.in == no_edge || meeting.out == no_edge) continue;
      const Edge &in = edges_[meeting.in], &out = edges_[meeting.out];
      if (in.left != out.left || in.right != out.right || in.mark != out.mark) continue;
      next_[meeting.in] = meeting.out;
      previous_[meeting.out] = meeting.in;
    }
  }

  int vertex(PointId p) {
    const auto [place, is_new] = vertices_.emplace(p, static_cast<int>(mesh_.boundary.vertices.size()));
    if (is_new) mesh_.boundary.vertices.push_back(mesh_.points[index(p)]);
    return place->second;
  }

  /// The breaks of a chain, spaced by chord lengths; equally spaced where chords differ so much that breaks would
  /// coincide.
  std::vector<double> breaks(const std::vector<std::size_t>& chain) const {
    std::vector<double> at_end{0};
    double least = HUGE_VAL;
    for (const std::size_t e : chain) {
      const double chord = distance(mesh_.points[index(edges_[e].from)], mesh_.points[index(edges_[e].to)]);
      least = std::fmin(least, chord);
      at_end.push_back(at_end.back() + chord);
    }
    if (!(least > 1e-9 * at_end.back() && at_end.back() <= msh_largest && least > 1 / msh_largest))
      std::iota(at_end.begin(), at_end.end(), 0.0);
    return at_end;
  }

  void add_curve(const std::vector<std::size_t>& chain, bool closed) {
    const int p = mesh_.degree;
    const auto number = static_cast<CurveId>(mesh_.boundary.curves.size());
    std::vector<Point> points;
    points.reserve(chain.size() * index(p) + 1);
    for (std::size_t s = 0; s < chain.size(); ++s) {
      const HalfEdgeId h = edges_[chain[s]].half_edge;
      ConstrainedEdge edge{number, static_cast<int>(s), {}};
      edge.points.reserve(index(p) + 1);
      for (int k = 0; k <= p; ++k) edge.points.push_back(net_of(h)[layout_.edge_index(edge_of(h), k)]);
      for (int k = s == 0 ? 0 : 1; k <= p; ++k) points.push_back(mesh_.points[index(edge.points[index(k)])]);
      mesh_.constrained_edges.push_back(std::move(edge));
    }
    if (closed) points.pop_back();

    // Every break has multiplicity p. In a closed curve basis function i starts at knot i, so control point 0 is the
    // second one of the first edge, and the first edge's start comes last.
    const std::vector<double> at_end = breaks(chain);
    std::vector<double> knots;
    knots.reserve(at_end.size() * index(p) + 2);
    if (closed) std::rotate(points.begin(), points.begin() + 1, points.end());
    for (std::size_t k = 0; k < at_end.size(); ++k) {
      const bool is_end = k == 0 || k + 1 == at_end.size();
      const int times = closed ? (k + 1 == at_end.size() ? 1 : p) : is_end ? p + 1 : p;
      knots.insert(knots.end(), index(times), at_end[k]);
    }
    const Edge &first = edges_[chain.front()], &last = edges_[chain.back()];
    Curve curve;
    curve.name = name(first);
    curve.spline = BSpline(p, closed, std::move(knots), std::move(points));
    if (!closed) {
      curve.start = vertex(first.from);
      curve.end = vertex(last.to);
    }
    curve.left = first.left;
    curve.right = first.right;
    mesh_.boundary.curves.push_back(std::move(curve));
  }

  std::string name(const Edge& edge) const {
    if (edge.mark == none) {
      const auto face = [&](FaceId f) { return mesh_.boundary.faces[index(f)].name; };
      return edge.right == outside ? "boundary of " + face(edge.left) : face(edge.left) + " | " + face(edge.right);
    }
    const Mark& mark = marks_[index(edge.mark)];
    if (mark.physical == 0) return "curve " + std::to_string(mark.entity);
    const auto named = file_.names.find({1, std::abs(mark.physical)});
    return named == file_.names.end() || named->second.empty() ? "physical curve " + std::to_string(mark.physical)
                                                               : msh_name(named->second);
  }

  void warn() {
    const auto inside = std::count_if(lines_.begin(), lines_.end(), [](const LineEnds& line) { return !line.used; });
    if (inside > 0)
      warnings_.push_back(std::to_string(inside) + (inside == 1 ? " line element lies" : " line elements lie") +
                          " neither on the boundary nor between two faces, and " + (inside == 1 ? "is" : "are") +
                          " left out");
  }

  const MshFile& file_;
  MeshData& mesh_;
  const NetLayout& layout_;
  std::vector<Edge> edges_;
  std::vector<Mark> marks_;
  std::vector<LineEnds> lines_;
  std::vector<std::size_t> next_, previous_;
  std::unordered_map<PointId, int> vertices_;
  std::vector<std::string> warnings_;
};

}  // namespace

std::vector<std::string> trace_curves(const MshFile& file, const std::vector<OpenEdge>& edges, MeshData& mesh) {
  return CurveTracer(file, edges, mesh).run();
}

}  // namespace pliant
