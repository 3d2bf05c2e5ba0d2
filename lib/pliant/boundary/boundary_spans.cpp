// lib/pliant/boundary/boundary_spans.cpp: the Bézier spans of all curves, and the nodes that join them.
#include "pliant/boundary/boundary_spans.h"

namespace pliant {

BoundarySpans::BoundarySpans(const BoundaryComplex& boundary) : nodes_(boundary.vertices) {
  for (std::size_t c = 0; c < boundary.curves.size(); ++c) {
    const Curve& curve = boundary.curves[c];
    const BSpline& spline = curve.spline;
    const std::vector<double> breaks = spline.breaks();
    const int first_node = static_cast<int>(nodes_.size());
    const int count = static_cast<int>(breaks.size()) - 1;
    for (int s = 0; s < count; ++s) {
      const auto at = static_cast<std::size_t>(s);
      BoundarySpan span{static_cast<int>(c), s, breaks[at], breaks[at + 1], 0, 0, points_.size(), spline.degree()};
      if (spline.closed()) {
        span.from = first_node + s;
        span.to = first_node + (s + 1) % count;
      } else {
        span.from = s == 0 ? curve.start : first_node + s - 1;
        span.to = s + 1 == count ? curve.end : first_node + s;
      }
      points_.resize(points_.size() + static_cast<std::size_t>(spline.degree()) + 1);
      spline.extract(span.t0, std::span<Point>(points_).subspan(span.first_point));
      if (spline.closed() || s > 0) nodes_.push_back(points_[span.first_point]);
      spans_.push_back(span);
    }
  }
}

Box BoundarySpans::box(std::size_t i) const {
  Box box;
  for (const Point& p : polygon(i)) box.extend(p);
  return box;
}

std::string describe_curve(const BoundaryComplex& boundary, int curve) {
  const std::string& name = boundary.curves[static_cast<std::size_t>(curve)].name;
  const std::string number = std::to_string(curve);
  return name.empty() ? "curve " + number : "curve '" + name + "' (" + number + ")";
}

std::string describe_node(const BoundaryComplex& boundary, const BoundarySpans& spans, int node) {
  const std::string place = describe_point(spans.nodes()[static_cast<std::size_t>(node)]);
  if (node < static_cast<int>(boundary.vertices.size())) return "vertex " + std::to_string(node) + " " + place;
  for (const BoundarySpan& span : spans.spans())
    if (span.from == node)
      return describe_curve(boundary, span.curve) + " at parameter " + describe_number(span.t0) + ", " + place;
  return place;
}

}  // namespace pliant
