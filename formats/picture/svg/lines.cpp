// formats/picture/svg/lines.cpp: the edges and curves of a mesh, in inks that are seen on the colours around them.
#include <algorithm>
#include <map>

#include "formats/picture/svg/drawing.h"
#include "formats/picture/svg/shown_parts.h"
#include "formats/picture/svg/text.h"
#include "pliant/geometry/control_net.h"

namespace pliant {
namespace {

constexpr double enough_contrast = 3;  // below this an ink is hardly seen as a thin line

/// Where the edge's own parameter s lies in one of its two elements.
Barycentric place_in(const Drawing& drawing, const MeshEdge& edge, TriangleId t, double s) {
  const PointId* corner = &drawing.mesh.triangles[static_cast<std::size_t>(t * net_size(drawing.mesh.degree))];
  Barycentric xi{};
  for (std::size_t c = 0; c < 3; ++c) {
    if (corner[c] == edge.points.front()) xi[c] = 1 - s;
    if (corner[c] == edge.points.back()) xi[c] = s;
  }
  return xi;
}

/// How well an ink is seen beside an edge: on the colour of one of its sides is enough.
double best_contrast(const Drawing& drawing, const MeshEdge& edge, double s, const Rgb& ink) {
  double best = 0;
  const bool same = drawing.values.is_field() && !drawing.values.depends_on_face();
  for (const TriangleId t : edge.sides) {
    if (t == none) break;
    if (t == edge.sides[1] && same) break;  // this side has the other's colours
    best = std::max(best, contrast(ink, drawing.color_at(t, place_in(drawing, edge, t, s))));
  }
  return best;
}

bool prefers_other(const Drawing& drawing, const MeshEdge& edge, double s) {
  const double own = best_contrast(drawing, edge, s, drawing.theme.ink);
  return own < enough_contrast && best_contrast(drawing, edge, s, drawing.theme.other_ink) > own;
}

/// Along how many of `n` equal parts of the edge the other ink is seen better, and along which.
std::vector<bool> inks_along(const Drawing& drawing, const MeshEdge& edge) {
  // The outer boundary is seen against the paper.
  if (drawing.options.color.kind == ColorBy::Kind::nothing || edge.sides[1] == none) return {false};
  if (!drawing.values.is_field()) return {prefers_other(drawing, edge, 0.5)};
  constexpr int n = 8;
  const auto ink = [&](int k) { return prefers_other(drawing, edge, (k + 0.5) / n); };
  std::vector<bool> inks(n, ink(n / 2));
  inks.front() = ink(0), inks.back() = ink(n - 1);
  if (inks.front() == inks.back() && inks.front() == inks[n / 2]) return {inks.front()};
  for (int k = 1; k + 1 < n; ++k) inks[static_cast<std::size_t>(k)] = ink(k);
  return inks;
}

/// The part of a Bézier curve from parameter a to b.
std::vector<Point> part_of(const std::vector<Point>& polygon, double a, double b) {
  const int degree = static_cast<int>(polygon.size()) - 1;
  std::vector<double> rows, left, right;
  for (const Point& p : polygon) rows.insert(rows.end(), {p.x, p.y});
  left.resize(rows.size()), right.resize(rows.size());
  if (b < 1) {
    split_polygon(degree, 2, rows, b, left, right);
    rows = left;
  }
  if (a > 0) {
    split_polygon(degree, 2, rows, a / b, left, right);
    rows = right;
  }
  std::vector<Point> part;
  for (std::size_t i = 0; i < rows.size(); i += 2) part.push_back({rows[i], rows[i + 1]});
  return part;
}

/// Calls draw(polygon, other) for what is shown of the runs of an edge that have one ink.
template <typename Draw>
void draw_in_inks(const Drawing& drawing, const MeshEdge& edge, const Draw& draw) {
  const std::vector<Point> polygon = positions(drawing.mesh, edge.points);
  if (!is_shown(drawing, polygon)) return;
  const std::vector<bool> inks = inks_along(drawing, edge);
  const std::size_t n = inks.size();
  for (std::size_t from = 0, to = 0; from < n; from = to) {
    while (to < n && inks[to] == inks[from]) ++to;
    for_shown_parts(drawing, part_of(polygon, double(from) / double(n), double(to) / double(n)),
                    [&](const std::vector<Point>& part) { draw(part, inks[from]); });
  }
}

}  // namespace

void draw_inner_edges(const Drawing& drawing, std::string& out) {
  if (!drawing.options.edges) return;
  const double width = drawing.fine_width();
  std::string inked, others;
  SvgPath in_ink = drawing.path(inked), in_other = drawing.path(others);
  for (const MeshEdge& edge : drawing.edges.edges) {
    if (edge.constrained != none) continue;
    draw_in_inks(drawing, edge, [&](const std::vector<Point>& part, bool other) {
      (other ? in_other : in_ink).move_to(part.front()).curve_to(part);
    });
  }
  const auto write = [&](std::string_view name, const Rgb& ink, const std::string& data) {
    out.append("<path class=\"").append(name).append("\" fill=\"none\" stroke=\"").append(hex(ink));
    out.append("\" stroke-opacity=\"0.6\"").append(drawing.stroke_width(width));
    out.append(" stroke-linecap=\"round\" d=\"").append(data).append("\"/>\n");
  };
  write("edges", drawing.theme.ink, inked);
  if (!others.empty()) write("edges other", drawing.theme.other_ink, others);
}

void draw_curves(const Drawing& drawing, std::string& out) {
  const MeshData& mesh = drawing.mesh;
  // Where the ink of curves is hardly seen on the colours at both sides, a wider line lies beneath.
  std::string halo;
  SvgPath in_halo = drawing.path(halo);
  for (const MeshEdge& edge : drawing.edges.edges)
    if (edge.constrained != none)
      draw_in_inks(drawing, edge, [&](const std::vector<Point>& part, bool other) {
        if (other) in_halo.move_to(part.front()).curve_to(part);
      });
  if (!halo.empty())
    out.append("<path class=\"halo\" fill=\"none\" stroke=\"")
        .append(hex(drawing.theme.other_ink))
        .append("\" stroke-opacity=\"0.8\"")
        .append(drawing.stroke_width(4.4))
        .append(" stroke-linecap=\"round\" d=\"")
        .append(halo)
        .append("\"/>\n");

  std::map<CurveId, std::map<int, const ConstrainedEdge*>> by_curve;
  for (const ConstrainedEdge& edge : mesh.constrained_edges) by_curve[edge.curve][edge.span] = &edge;
  SvgPath path = drawing.path(out);
  path.text("<g class=\"curves\" fill=\"none\" stroke=\"").text(hex(drawing.theme.ink));
  path.text("\" stroke-linejoin=\"round\"").text(drawing.stroke_width(2.2)).text(">\n");
  for (const auto& [curve, spans] : by_curve) {
    path.text("<path d=\"");
    PointId at = none, first = none;
    for (const auto& [span, edge] : spans) {
      const std::vector<Point> polygon = positions(mesh, edge->points);
      if (!is_drawn_whole(drawing, polygon)) {
        for_shown_parts(drawing, polygon,
                        [&path](const std::vector<Point>& part) { path.move_to(part.front()).curve_to(part); });
        at = none;
        continue;
      }
      if (edge->points.front() != at) {
        first = edge->points.front();
        path.move_to(drawing.at(first));
      }
      path.curve_to(polygon);
      at = edge->points.back();
      if (at == first) path.text("Z");
    }
    path.text("\"><title>").text(escape_xml(mesh.boundary.curves[static_cast<std::size_t>(curve)].name));
    path.text("</title></path>\n");
  }
  path.text("</g>\n");
}

}  // namespace pliant
