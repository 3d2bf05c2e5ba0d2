// lib/pliant/boundary/arrangement.cpp: disjoint faces from curves that cross, touch or overlap.
#include "pliant/boundary/arrangement.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <utility>

#include "pliant/boundary/arrangement/arrangement_curves.h"
#include "pliant/boundary/arrangement/arrangement_input.h"
#include "pliant/boundary/boundary_spans.h"
#include "pliant/boundary/check_boundary.h"
#include "pliant/geometry/index.h"

namespace pliant {
namespace {

constexpr double widening = 16;  // the tolerance of an attempt over that of the attempt before

/// The input of `arrange` and that of `resolve`, in one form.
struct Painting {
  std::vector<Point> vertices;
  std::vector<Face> faces;
  std::vector<FillRule> rules;
  std::deque<BSpline> splines;  ///< the splines that `curves` point to
  std::vector<SidedCurve> curves;
  std::vector<Curve> sources;  ///< for each of `curves`, its name and other members, without a spline
  double tip = 0;              ///< the length within which a sharp turn becomes a corner

  /// `source` is the name and the other members of the curve that `spline` belongs to.
  void add_curve(const BSpline& spline, const Winding& jump, const Curve& source) {
    for (BSpline& part : split_at_stops(spline, tip)) {
      splines.push_back(std::move(part));
      curves.push_back({&splines.back(), jump});
      sources.push_back(source);
    }
  }

  /// The face, or `outside`, to which points with these winding numbers belong.
  int owner(const Winding& winding) const {
    for (auto at = winding.rbegin(); at != winding.rend(); ++at)
      if (rules[index(at->first)] == FillRule::nonzero || at->second % 2 != 0) return at->first;
    return outside;
  }
};

void extend(Box& box, const BSpline& spline) {
  for (const Point& p : spline.points()) box.extend(p);
}

Fault inconsistent_at(const Point& p) {
  return {"boundary", "/curves",
          "the curves near " + describe_point(p) +
              " run so close to each other that what lies between them cannot be told"};
}

/// Fills in the boundary of the result: the vertices that are used, the faces of which something is left, and the
/// curves.
void assemble(const Painting& painting, const ArcNetwork& network, std::vector<KeptCurve> kept, Arrangement& result) {
  BoundaryComplex& boundary = result.boundary;
  std::vector<int> vertex(network.nodes.size(), no_vertex), face(painting.faces.size(), outside);
  for (const KeptCurve& curve : kept) {
    for (const int n : {curve.start, curve.end})
      if (n != no_vertex) vertex[index(n)] = 0;
    for (const int f : {curve.left, curve.right})
      if (f != outside) face[index(f)] = 0;
  }
  for (std::size_t n = 0; n < vertex.size(); ++n) {
    if (vertex[n] == no_vertex) continue;
    vertex[n] = static_cast<int>(boundary.vertices.size());
    const Point& p = network.nodes[n];
    boundary.vertices.push_back({std::ldexp(p.x, network.exponent), std::ldexp(p.y, network.exponent)});
  }
  for (std::size_t f = 0; f < face.size(); ++f) {
    if (face[f] == outside) continue;
    face[f] = static_cast<int>(boundary.faces.size());
    boundary.faces.push_back(painting.faces[f]);
    result.sources.push_back(static_cast<int>(f));
  }
  for (KeptCurve& from : kept) {
    Curve curve = painting.sources[index(from.curve)];
    curve.spline = std::move(from.spline);
    curve.start = from.start == no_vertex ? no_vertex : vertex[index(from.start)];
    curve.end = from.end == no_vertex ? no_vertex : vertex[index(from.end)];
    curve.left = from.left == outside ? outside : face[index(from.left)];
    curve.right = from.right == outside ? outside : face[index(from.right)];
    boundary.curves.push_back(std::move(curve));
  }
}

Arrangement attempt(const Painting& painting, const ArrangeOptions& options) {
  Arrangement result;
  ArcTolerances tolerances{};
  const ArcNetwork network = cut_curves(painting.curves, painting.vertices, options, tolerances);
  const ArrangementGraph graph = build_graph(network, painting.curves, tolerances,
                                             [&](const Winding& winding) { return painting.owner(winding); });
  result.intersections = graph.crowded_nodes;
  result.pieces = static_cast<long>(graph.edges.size());
  result.regions = graph.regions;
  result.slivers = graph.slivers;
  result.sliver_area = std::ldexp(graph.sliver_area, 2 * network.exponent);
  for (const int n : graph.broken) {
    const Point& p = network.nodes[index(n)];
    result.faults.push_back(inconsistent_at({std::ldexp(p.x, network.exponent), std::ldexp(p.y, network.exponent)}));
  }
  if (!result.faults.empty()) return result;
  assemble(painting, network, chain_arcs(network, painting.curves, graph, tolerances), result);
  result.faults = check_boundary(result.boundary);
  if (result.faults.empty()) result.faults = check_boundary_geometry(result.boundary);
  return result;
}

/// The fault of an input that is so large or so small that products of lengths would overflow or vanish.
std::vector<Fault> size_fault(const Painting& painting) {
  constexpr double least = 1e-100, most = 1e100;
  Box box;
  double reach = 0;
  for (const BSpline& spline : painting.splines)
    for (const Point& p : spline.points()) {
      box.extend(p);
      reach = std::max({reach, std::fabs(p.x), std::fabs(p.y)});
    }
  const double size = box.size();
  if (size == 0 || (size >= least && reach <= most)) return {};
  return {{"boundary", "/curves", "the curves' size is not between 1e-100 and 1e100"}};
}

/// The arrangement with the smallest tolerance that gives a boundary. Where rounding leaves something that is none, a
/// coarser tolerance mostly helps.
Arrangement solve(const Painting& painting, ArrangeOptions options) {
  Arrangement result;
  result.faults = size_fault(painting);
  if (!result.faults.empty()) return result;
  result = attempt(painting, options);
  result.tolerance = options.tolerance;
  while (!result.faults.empty() && options.tolerance * widening <= options.coarsest) {
    options.tolerance *= widening;
    options.sliver = std::max(options.sliver, 4 * options.tolerance);
    Arrangement next = attempt(painting, options);
    if (!next.faults.empty()) continue;
    next.tolerance = options.tolerance;
    return next;
  }
  return result;
}

/// The places where more, or fewer, open curves of a face start than end.
std::vector<Fault> open_loops(std::span<const FilledFace> faces) {
  std::vector<Fault> faults;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    std::map<std::pair<double, double>, int> balance;
    for (const BSpline& spline : faces[f].curves) {
      if (spline.closed()) continue;
      ++balance[{spline.points().front().x, spline.points().front().y}];
      --balance[{spline.points().back().x, spline.points().back().y}];
    }
    for (const auto& [place, count] : balance)
      if (count != 0)
        faults.push_back({"boundary", "/faces/" + std::to_string(f),
                          "the curves of face '" + faces[f].name + "' do not close at " +
                              describe_point({place.first, place.second})});
  }
  return faults;
}

}  // namespace

Arrangement arrange(std::span<const FilledFace> faces, const ArrangeOptions& options) {
  Painting painting;
  Box box;
  for (const FilledFace& face : faces)
    for (const BSpline& spline : face.curves) extend(box, spline);
  painting.tip = options.tip * box.size();
  for (const FilledFace& face : faces) {
    const int f = static_cast<int>(painting.faces.size());
    painting.faces.push_back({face.name, face.extra});
    painting.rules.push_back(face.rule);
    Curve source;
    source.name = face.name;
    for (const BSpline& spline : face.curves) painting.add_curve(spline, {{f, 1}}, source);
  }
  Arrangement result;
  result.faults = open_loops(faces);
  return result.faults.empty() ? solve(painting, options) : result;
}

Arrangement resolve(const BoundaryComplex& boundary, const ArrangeOptions& options) {
  Painting painting;
  painting.vertices = boundary.vertices;
  painting.faces = boundary.faces;
  painting.rules.assign(boundary.faces.size(), FillRule::nonzero);
  painting.tip = options.tip * bounding_box(boundary).size();
  for (const Curve& curve : boundary.curves) {
    Winding jump;
    if (curve.left != outside) add_winding(jump, {{curve.left, 1}});
    if (curve.right != outside) add_winding(jump, {{curve.right, -1}});
    Curve source = curve;
    source.spline = {};
    painting.add_curve(curve.spline, jump, source);
  }
  Arrangement result = solve(painting, options);
  result.boundary.extra = boundary.extra;
  return result;
}

}  // namespace pliant
