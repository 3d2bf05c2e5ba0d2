#include <algorithm>  // lib/pliant/boundary/check_boundary_geometry.cpp: what a boundary that is to be meshed must hold
#include <numeric>

#include "pliant/boundary/boundary_spans.h"
#include "pliant/boundary/box_pairs.h"
#include "pliant/boundary/check_boundary.h"
#include "pliant/boundary/curve_contact.h"

namespace pliant {
namespace {

constexpr std::size_t most_faults = 20;  // a curve laid over another would give one a span

class Geometry {
 public:
  explicit Geometry(const BoundaryComplex& boundary) : boundary_(boundary), spans_(boundary) {}

  std::vector<Fault> check() {
    check_vertices();
    check_spans();
    check_pairs();
    check_orientation();
    return std::move(faults_);
  }

 private:
  void fault(std::string place, std::string text) {
    if (faults_.size() < most_faults) faults_.push_back({"boundary", std::move(place), std::move(text)});
  }
  std::string place_of(std::size_t i) const { return "/curves/" + std::to_string(spans_[i].curve); }
  std::string at_parameter(std::size_t i, double s) const {
    const BoundarySpan& span = spans_[i];
    return describe_curve(boundary_, span.curve) + " at parameter " +
           describe_number(span.t0 + s * (span.t1 - span.t0));
  }
  ContactCurve curve(std::size_t i) const { return {spans_.polygon(i), spans_[i].from, spans_[i].to}; }

  void check_vertices() {
    const std::vector<Point>& all = boundary_.vertices;
    std::vector<std::size_t> order(all.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
      return std::array{all[i].x, all[i].y} < std::array{all[j].x, all[j].y};
    });
    for (std::size_t k = 1; k < order.size(); ++k)
      if (all[order[k - 1]] == all[order[k]])
        fault("/vertices/" + std::to_string(2 * std::max(order[k - 1], order[k])),
              "vertices " + std::to_string(std::min(order[k - 1], order[k])) + " and " +
                  std::to_string(std::max(order[k - 1], order[k])) + " are the same point " +
                  describe_point(all[order[k]]));
  }

  void check_spans() {
    is_regular_.assign(spans_.size(), true);
    for (std::size_t i = 0; i < spans_.size(); ++i) {
      const auto polygon = spans_.polygon(i);
      const bool is_point =
          std::all_of(polygon.begin(), polygon.end(), [&](const Point& p) { return p == polygon[0]; });
      const auto contact = is_point ? std::nullopt : find_self_contact(curve(i));
      if (!is_point && !contact) continue;
      is_regular_[i] = false;
      if (is_point) {
        fault(place_of(i), at_parameter(i, 0) + ": the span has no length; it stays at " + describe_point(polygon[0]));
      } else if (contact->kind == Contact::Kind::turns_back && contact->node < 0) {
        fault(place_of(i),
              at_parameter(i, contact->s) + ": the curve's derivative vanishes at " + describe_point(contact->place));
      } else {
        fault(place_of(i), at_parameter(i, contact->s) + " meets itself at parameter " +
                               describe_number(spans_[i].t0 + contact->t * (spans_[i].t1 - spans_[i].t0)) + ", at " +
                               describe_point(contact->place));
      }
    }
  }

  void check_pairs() {
    std::vector<Box> boxes(spans_.size());
    for (std::size_t i = 0; i < spans_.size(); ++i) boxes[i] = spans_.box(i);
    for (const auto& [first, second] : overlapping_pairs(boxes)) {
      const auto i = static_cast<std::size_t>(first), j = static_cast<std::size_t>(second);
      if (faults_.size() >= most_faults) return;
      if (!is_regular_[i] || !is_regular_[j]) continue;
      const auto contact = find_contact(curve(i), curve(j));
      if (!contact) continue;
      const bool at_vertex = contact->node >= 0 && contact->node < static_cast<int>(boundary_.vertices.size());
      if (contact->kind == Contact::Kind::turns_back && at_vertex) continue;  // a cusp: listed by who meshes it
      const bool turns = contact->kind == Contact::Kind::turns_back;
      fault(place_of(i), at_parameter(i, contact->s) + (turns ? " turns back into " : " meets ") +
                             at_parameter(j, contact->t) + ", at " + describe_point(contact->place) +
                             (turns ? "; a cusp needs a vertex" : ""));
    }
  }

  void check_orientation() {
    const Point origin = spans_.nodes().empty() ? Point{} : spans_.nodes().front();
    std::vector<double> area(boundary_.faces.size(), 0);
    for (const Curve& curve : boundary_.curves) {
      std::vector<Point> points = curve.spline.points();  // near the origin: open curves' areas cancel less
      for (Point& p : points) p -= origin;
      const double swept =
          BSpline(curve.spline.degree(), curve.spline.closed(), curve.spline.knots(), std::move(points)).area();
      if (curve.left != outside) area[static_cast<std::size_t>(curve.left)] += swept;
      if (curve.right != outside) area[static_cast<std::size_t>(curve.right)] -= swept;
    }
    for (std::size_t f = 0; f < area.size(); ++f)
      if (!(area[f] > 0))
        fault("/faces/" + std::to_string(f), "the curves around face '" + boundary_.faces[f].name +
                                                 "' enclose the area " + describe_number(area[f]) +
                                                 ": it lies on their wrong side, exchange left and right");
  }

  const BoundaryComplex& boundary_;
  BoundarySpans spans_;
  std::vector<bool> is_regular_;
  std::vector<Fault> faults_;
};

}  // namespace

std::vector<Fault> check_boundary_geometry(const BoundaryComplex& boundary) { return Geometry(boundary).check(); }

}  // namespace pliant
