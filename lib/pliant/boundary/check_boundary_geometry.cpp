// lib/pliant/boundary/check_boundary_geometry.cpp: the geometric faults of a boundary that is to be meshed.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>

#include "pliant/boundary/boundary_spans.h"
#include "pliant/boundary/box_pairs.h"
#include "pliant/boundary/check_boundary.h"
#include "pliant/boundary/curve_contact.h"

namespace pliant {
namespace {

constexpr std::size_t most_faults = 20;  // two curves that lie on each other would otherwise make one for each span
constexpr double resolution = 1e-9;      // relative to the size of spans: contacts are described and told apart to this

Vector tangent_at(std::span<const Point> polygon, double s) {
  std::vector<Point> points(polygon.begin(), polygon.end());
  for (std::size_t left = points.size(); left > 2; --left)
    for (std::size_t i = 0; i + 1 < left; ++i) points[i] = (1 - s) * points[i] + s * points[i + 1];
  const Vector along = points[1] - points[0];
  return along / length(along);
}

class Geometry {
 public:
  explicit Geometry(const BoundaryComplex& boundary) : boundary_(boundary), spans_(boundary) {}

  std::vector<Fault> check() {
    check_vertices();
    check_spans();
    check_pairs();
    return std::move(faults_);
  }

 private:
  void fault(Fault wrong) {
    if (faults_.size() < most_faults) faults_.push_back(std::move(wrong));
  }
  void fault(std::string place, std::string text) { fault({"boundary", std::move(place), std::move(text)}); }
  std::string place_of(std::size_t i) const { return "/curves/" + std::to_string(spans_[i].curve); }
  std::string parameter(std::size_t i, double s) const {
    const BoundarySpan& span = spans_[i];
    const double length = span.t1 - span.t0;
    return describe_number(span.t0 + s * length, resolution * length);
  }
  std::string at_parameter(std::size_t i, double s) const {
    return describe_curve(boundary_, spans_[i].curve) + " at parameter " + parameter(i, s);
  }
  std::string at(const Point& p, double size) const { return describe_point(p, resolution * size); }
  ContactCurve curve(std::size_t i) const { return {spans_.polygon(i), spans_[i].from, spans_[i].to}; }

  void check_vertices() {
    const std::vector<Point>& all = boundary_.vertices;
    std::vector<std::size_t> order(all.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
      return std::array{all[i].x, all[i].y} < std::array{all[j].x, all[j].y};
    });
    for (std::size_t k = 1; k < order.size(); ++k)
      if (all[order[k - 1]] == all[order[k]]) {
        has_twins_ = true;
        fault("/vertices/" + std::to_string(2 * std::max(order[k - 1], order[k])),
              "vertices " + std::to_string(std::min(order[k - 1], order[k])) + " and " +
                  std::to_string(std::max(order[k - 1], order[k])) + " are the same point " +
                  describe_point(all[order[k]]) + ": curves that meet there should name the same vertex");
      }
  }

  /// Reports one fault for each curve at most, because what else is wrong with the curve may follow from that.
  void check_spans() {
    is_regular_.assign(boundary_.curves.size(), true);
    for (std::size_t i = 0; i < spans_.size(); ++i) {
      const auto c = static_cast<std::size_t>(spans_[i].curve);
      if (!is_regular_[c]) continue;
      const auto polygon = spans_.polygon(i);
      const double size = spans_.box(i).size();
      const bool is_point =
          std::all_of(polygon.begin(), polygon.end(), [&](const Point& p) { return p == polygon[0]; });
      const auto contact = is_point ? std::nullopt : find_self_contact(curve(i));
      if (!is_point && !contact) continue;
      is_regular_[c] = false;
      if (is_point) {
        fault(place_of(i), describe_curve(boundary_, spans_[i].curve) + " at parameters " + parameter(i, 0) + " to " +
                               parameter(i, 1) + ": the span has no length; it stays at " + describe_point(polygon[0]) +
                               ": leave it out");
      } else if (contact->kind == Contact::Kind::turns_back && contact->node < 0) {
        fault(place_of(i), at_parameter(i, contact->s) + ": the curve's derivative vanishes at " +
                               at(contact->place, size) + ": control points coincide there, or it has a cusp");
      } else {
        fault(place_of(i), at_parameter(i, contact->s) + " meets itself at parameter " + parameter(i, contact->t) +
                               ", at " + at(contact->place, size) + ": a curve may only end where it starts");
      }
    }
  }

  void check_pairs() {
    std::vector<Box> boxes(spans_.size());
    for (std::size_t i = 0; i < spans_.size(); ++i) boxes[i] = spans_.box(i);
    const std::vector<int> loose = loose_vertices();
    for (const int v : loose) boxes.emplace_back().extend(boundary_.vertices[static_cast<std::size_t>(v)]);
    for (const auto& [first, second] : overlapping_pairs(boxes)) {
      const auto i = static_cast<std::size_t>(first), j = static_cast<std::size_t>(second);
      if (faults_.size() >= most_faults) return;
      if (i >= spans_.size() || !is_regular(i)) continue;
      if (j >= spans_.size()) {
        check_loose_vertex(loose[j - spans_.size()], i);
        continue;
      }
      if (!is_regular(j)) continue;
      const auto contact = find_contact(curve(i), curve(j));
      if (!contact) continue;
      const bool at_vertex = contact->node >= 0 && contact->node < static_cast<int>(boundary_.vertices.size());
      if (contact->kind == Contact::Kind::turns_back && at_vertex) continue;  // a cusp, which is no fault
      const double size = std::max(boxes[i].size(), boxes[j].size());
      if (!is_new(i, j, contact->place, size)) continue;
      const bool turns = contact->kind == Contact::Kind::turns_back;
      fault({"contact", place_of(i),
             at_parameter(i, contact->s) + (turns ? " turns back into " : relation(i, j, *contact)) +
                 at_parameter(j, contact->t) + ", at " + at(contact->place, size) +
                 (turns ? ": a cusp needs a vertex" : ": curves may meet at common vertices only")});
    }
  }

  bool is_regular(std::size_t i) const { return is_regular_[static_cast<std::size_t>(spans_[i].curve)]; }

  /// Whether a contact has not been reported before. Where spans join at a contact, two or four pairs of spans have it.
  bool is_new(std::size_t i, std::size_t j, const Point& place, double size) {
    const std::array<int, 2> pair{spans_[i].curve, spans_[j].curve};
    for (const auto& [known, where] : contacts_)
      if (known == pair && distance(where, place) <= 10 * resolution * size) return false;
    contacts_.emplace_back(pair, place);
    return true;
  }

  const char* relation(std::size_t i, std::size_t j, const Contact& contact) const {
    const auto inside = [](double s) { return resolution < s && s < 1 - resolution; };
    if (!inside(contact.s) || !inside(contact.t)) return " meets ";
    const double sine = cross(tangent_at(spans_.polygon(i), contact.s), tangent_at(spans_.polygon(j), contact.t));
    return std::fabs(sine) > 1e-4 ? " crosses " : " touches or overlaps ";
  }

  /// The vertices where no curve ends. They become vertices of the mesh, which is a fault only if they lie on a curve.
  std::vector<int> loose_vertices() const {
    std::vector<bool> is_used(boundary_.vertices.size(), false);
    for (const Curve& curve : boundary_.curves)
      for (const int v : {curve.start, curve.end})
        if (v != no_vertex) is_used[static_cast<std::size_t>(v)] = true;
    std::vector<int> loose;
    if (has_twins_) return loose;  // vertices at the same point would be reported a second time
    for (std::size_t v = 0; v < is_used.size(); ++v)
      if (!is_used[v]) loose.push_back(static_cast<int>(v));
    return loose;
  }

  void check_loose_vertex(int v, std::size_t i) {
    const Point p = boundary_.vertices[static_cast<std::size_t>(v)];
    const std::array<Point, 2> stays{p, p};
    const int nodes = static_cast<int>(spans_.nodes().size());
    const auto contact = find_contact({stays, nodes, nodes + 1}, curve(i));
    if (!contact || !reported_.insert(v).second) return;  // where spans join, both find the vertex
    fault("/vertices/" + std::to_string(2 * v), describe_node(boundary_, spans_, v) + ", no curve's end, lies on " +
                                                    at_parameter(i, contact->t) +
                                                    ": divide the curve there, or leave the vertex out");
  }

  const BoundaryComplex& boundary_;
  BoundarySpans spans_;
  std::set<int> reported_;        // loose vertices
  bool has_twins_ = false;        // some vertices are at the same point
  std::vector<bool> is_regular_;  // for each curve, whether check_spans found no fault
  std::vector<std::pair<std::array<int, 2>, Point>> contacts_;
  std::vector<Fault> faults_;
};

}  // namespace

std::vector<Fault> check_boundary_geometry(const BoundaryComplex& boundary) { return Geometry(boundary).check(); }

}  // namespace pliant
