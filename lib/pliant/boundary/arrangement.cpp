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
  std::vector<FillRule> rules;  ///< of the regions that winding numbers count: first the faces, then parts of clips
  const PaintedLayers* layers = nullptr;  ///< null where nothing is clipped, and no line drawn
  std::vector<int> first_parts;           ///< the region of the first part of each clip area; one more at the end
  std::deque<BSpline> splines;            ///< the splines that `curves` point to
  std::vector<SidedCurve> curves;
  std::vector<Curve> sources;  ///< for each of `curves`, its name and other members, without a spline
  double tip = 0;              ///< the length within which a sharp turn becomes a corner

  /// `source` is the name and the other members of the curve that `spline` belongs to.
  void add_curve(const BSpline& spline, const Winding& jump, const Curve& source, int line = -1) {
    for (BSpline& part : split_at_stops(spline, tip)) {
      splines.push_back(std::move(part));
      curves.push_back({&splines.back(), jump, line});
      sources.push_back(source);
    }
  }

  /// The face, or `outside`, to which points with these winding numbers belong.
  int owner(const Winding& winding) const {
    for (auto at = winding.rbegin(); at != winding.rend(); ++at) {
      if (at->first >= static_cast<int>(faces.size()) || !fills(*at)) continue;
      if (layers == nullptr || is_inside(layers->faces[index(at->first)].clips, winding)) return at->first;
    }
    return outside;
  }

  bool shows(int line, const Winding& winding, int owner) const {
    const DrawnLine& drawn = layers->lines[index(line)];
    return owner < drawn.above && is_inside(drawn.clips, winding);
  }

 private:
  bool fills(const std::pair<int, int>& region) const {
    return rules[index(region.first)] == FillRule::nonzero || region.second % 2 != 0;
  }
  bool is_inside(const std::vector<int>& clips, const Winding& winding) const {
    std::map<int, bool> known;
    return is_inside(clips, winding, known);
  }
  /// Do points with these winding numbers lie in all of the clip areas? What is known of one is not asked again, since
  /// areas may be clipped by the same other one many times.
  bool is_inside(const std::vector<int>& clips, const Winding& winding, std::map<int, bool>& known) const {
    return std::all_of(clips.begin(), clips.end(), [&](int clip) {
      const auto found = known.find(clip);
      if (found != known.end()) return found->second;
      return known[clip] = is_inside(clip, winding, known);
    });
  }
  bool is_inside(int clip, const Winding& winding, std::map<int, bool>& known) const {
    const ClipArea& area = layers->clips[index(clip)];
    const int first = first_parts[index(clip)], last = first_parts[index(clip) + 1];
    auto at = std::lower_bound(winding.begin(), winding.end(), std::pair(first, 0),
                               [](const auto& a, const auto& b) { return a.first < b.first; });
    for (; at != winding.end() && at->first < last; ++at)
      if (fills(*at) && is_inside(area.parts[index(at->first - first)].clips, winding, known))
        return is_inside(area.clips, winding, known);
    return false;
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
  const ArrangementGraph graph =
      build_graph(network, painting.curves, tolerances,
                  {[&](const Winding& winding) { return painting.owner(winding); },
                   [&](int line, const Winding& winding, int owner) { return painting.shows(line, winding, owner); }});
  result.intersections = graph.crowded_nodes;
  result.pieces = static_cast<long>(graph.edges.size());
  result.regions = graph.regions;
  result.slivers = graph.slivers;
  result.bare_lines = graph.bare_lines;
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
std::vector<Fault> open_loops(const FilledFace& face, int number) {
  std::vector<Fault> faults;
  std::map<std::pair<double, double>, int> balance;
  for (const BSpline& spline : face.curves) {
    if (spline.closed()) continue;
    ++balance[{spline.points().front().x, spline.points().front().y}];
    --balance[{spline.points().back().x, spline.points().back().y}];
  }
  for (const auto& [place, count] : balance)
    if (count != 0)
      faults.push_back(
          {"boundary", "/faces/" + std::to_string(number),
           "the curves of face '" + face.name + "' do not close at " + describe_point({place.first, place.second})});
  return faults;
}

}  // namespace

Arrangement arrange(std::span<const FilledFace> faces, const ArrangeOptions& options) {
  return arrange_layers(PaintedLayers{{faces.begin(), faces.end()}}, options);
}

Arrangement arrange_layers(const PaintedLayers& layers, const ArrangeOptions& options) {
  Painting painting;
  painting.layers = &layers;
  std::vector<const FilledFace*> regions;
  for (const FilledFace& face : layers.faces) {
    regions.push_back(&face);
    painting.faces.push_back({face.name, face.extra});
  }
  for (const ClipArea& clip : layers.clips) {
    painting.first_parts.push_back(static_cast<int>(regions.size()));
    for (const FilledFace& part : clip.parts) regions.push_back(&part);
  }
  painting.first_parts.push_back(static_cast<int>(regions.size()));
  Box box;
  for (const FilledFace* region : regions)
    for (const BSpline& spline : region->curves) extend(box, spline);
  for (const DrawnLine& line : layers.lines) extend(box, line.curve);
  painting.tip = options.tip * box.size();
  Arrangement result;
  for (const FilledFace* region : regions) {
    const int r = static_cast<int>(painting.rules.size());
    painting.rules.push_back(region->rule);
    Curve source;
    source.name = region->name;
    for (const BSpline& spline : region->curves) painting.add_curve(spline, {{r, 1}}, source);
    for (Fault& fault : open_loops(*region, r)) result.faults.push_back(std::move(fault));
  }
  for (std::size_t l = 0; l < layers.lines.size(); ++l) {
    Curve source;
    source.name = layers.lines[l].name;
    painting.add_curve(layers.lines[l].curve, {}, source, static_cast<int>(l));
  }
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
