#include "pliant/boundary/check_boundary.h"  // lib/pliant/boundary/check_boundary.cpp: the structural faults

#include <map>
#include <set>
#include <string>

#include "pliant/boundary/boundary_spans.h"

namespace pliant {
namespace {

class Structure {
 public:
  explicit Structure(const BoundaryComplex& boundary) : boundary_(boundary) {}

  std::vector<Fault> check() {
    check_vertices();
    check_faces();
    for (std::size_t c = 0; c < boundary_.curves.size(); ++c) check_curve(c);
    check_sides();
    // Chains are only meaningful where every index is.
    if (faults_.empty()) check_chains();
    return std::move(faults_);
  }

 private:
  void fault(std::string place, std::string text) {
    faults_.push_back({"boundary", std::move(place), std::move(text)});
  }
  static std::string curve_place(std::size_t c, const char* member) {
    return "/curves/" + std::to_string(c) + "/" + member;
  }
  bool is_vertex(int v) const { return 0 <= v && v < static_cast<int>(boundary_.vertices.size()); }

  void check_vertices() {
    for (std::size_t v = 0; v < boundary_.vertices.size(); ++v)
      if (!is_finite(boundary_.vertices[v]))
        fault("/vertices/" + std::to_string(2 * v), "vertex " + std::to_string(v) + " is not finite");
    for (std::size_t i = 0; i < boundary_.cusps.size(); ++i)
      if (!is_vertex(boundary_.cusps[i]))
        fault("/cusps/" + std::to_string(i), "there is no vertex " + std::to_string(boundary_.cusps[i]));
  }

  void check_faces() {
    std::map<std::string, std::size_t> seen;
    for (std::size_t f = 0; f < boundary_.faces.size(); ++f) {
      const std::string& name = boundary_.faces[f].name;
      const std::string place = "/faces/" + std::to_string(f) + "/name";
      if (name.empty()) fault(place, "a face needs a name");
      const auto [first, is_new] = seen.emplace(name, f);
      if (!is_new && !name.empty())
        fault(place, "the name '" + name + "' is face " + std::to_string(first->second) + "'s already");
    }
  }

  void check_curve(std::size_t c) {
    const Curve& curve = boundary_.curves[c];
    const BSpline& spline = curve.spline;
    if (const auto wrong = BSpline::fault(spline.degree(), spline.closed(), spline.knots(), spline.points())) {
      fault("/curves/" + std::to_string(c), *wrong);
      return;
    }
    if (!std::isfinite(curve.removal_error) || curve.removal_error < 0)
      fault(curve_place(c, "removal_error"), "a removal error is a finite length, at least 0");
    if (spline.closed()) {
      if (curve.start != no_vertex) fault(curve_place(c, "start"), "a closed curve has no start");
      if (curve.end != no_vertex) fault(curve_place(c, "end"), "a closed curve has no end");
      return;
    }
    check_end(c, "start", curve.start, spline.points().front());
    check_end(c, "end", curve.end, spline.points().back());
  }

  void check_end(std::size_t c, const char* which, int v, const Point& p) {
    const std::string place = curve_place(c, which);
    if (v == no_vertex) return fault(place, "an open curve needs a vertex here, at " + describe_point(p));
    if (!is_vertex(v)) return fault(place, "there is no vertex " + std::to_string(v));
    const Point& vertex = boundary_.vertices[static_cast<std::size_t>(v)];
    if (!(vertex == p))
      fault(place, "the curve's end " + describe_point(p) + " differs from vertex " + std::to_string(v) + " at " +
                       describe_point(vertex));
  }

  void check_sides() {
    const int faces = static_cast<int>(boundary_.faces.size());
    std::set<int> bounded;
    for (std::size_t c = 0; c < boundary_.curves.size(); ++c) {
      const Curve& curve = boundary_.curves[c];
      for (const auto& [side, which] : {std::pair(curve.left, "left"), std::pair(curve.right, "right")}) {
        if (side < outside || side >= faces) fault(curve_place(c, which), "there is no face " + std::to_string(side));
        bounded.insert(side);
      }
      if (curve.left == outside && curve.right == outside)
        fault(curve_place(c, "left"), "the curve has no face on either side");
    }
    for (int f = 0; f < faces; ++f)
      if (bounded.count(f) == 0)
        fault("/faces/" + std::to_string(f),
              "no curve bounds face '" + boundary_.faces[static_cast<std::size_t>(f)].name + "'");
  }

  /// At every vertex as many pieces of a face's boundary arrive as leave, the face on their left.
  void check_chains() {
    std::map<std::pair<int, int>, int> balance;  // (vertex, face) -> pieces that leave minus those that arrive
    for (const Curve& curve : boundary_.curves) {
      if (curve.spline.closed()) continue;
      ++balance[{curve.start, curve.left}];
      --balance[{curve.end, curve.left}];
      ++balance[{curve.end, curve.right}];
      --balance[{curve.start, curve.right}];
    }
    for (const auto& [key, count] : balance) {
      const auto [v, f] = key;
      if (count == 0 || f == outside) continue;
      fault("/vertices/" + std::to_string(2 * v),
            "the boundary of face '" + boundary_.faces[static_cast<std::size_t>(f)].name + "' " +
                (count > 0 ? "starts" : "ends") + " at vertex " + std::to_string(v) + " " +
                describe_point(boundary_.vertices[static_cast<std::size_t>(v)]) + ": its curves do not close");
    }
  }

  const BoundaryComplex& boundary_;
  std::vector<Fault> faults_;
};

}  // namespace

std::vector<Fault> check_boundary(const BoundaryComplex& boundary) { return Structure(boundary).check(); }

}  // namespace pliant
