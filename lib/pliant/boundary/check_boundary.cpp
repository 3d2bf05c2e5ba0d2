// lib/pliant/boundary/check_boundary.cpp: the structural faults.
#include "pliant/boundary/check_boundary.h"

#include <map>
#include <set>
#include <string>
#include <string_view>

#include "pliant/boundary/boundary_spans.h"

namespace pliant {
namespace {

constexpr std::size_t most_chain_faults = 20;

class Structure {
 public:
  explicit Structure(const BoundaryComplex& boundary) : boundary_(boundary) {}

  std::vector<Fault> check() {
    check_vertices();
    check_faces();
    for (std::size_t c = 0; c < boundary_.curves.size(); ++c) check_curve(c);
    check_sides();
    // Chains can only be checked if every index is valid.
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
    if (const auto wrong =
            BSpline::fault(spline.degree(), spline.closed(), spline.knots().to_vector(), spline.points().to_vector())) {
      fault("/curves/" + std::to_string(c), describe(c) + ": " + *wrong);
      return;
    }
    if (!std::isfinite(curve.removal_error) || curve.removal_error < 0)
      fault(curve_place(c, "removal_error"), describe(c) + ": a removal error is a finite length, at least 0");
    if (spline.closed()) {
      if (curve.start != no_vertex) fault(curve_place(c, "start"), describe(c) + " is closed: it has no start");
      if (curve.end != no_vertex) fault(curve_place(c, "end"), describe(c) + " is closed: it has no end");
      return;
    }
    check_end(c, "start", curve.start, spline.points().front());
    check_end(c, "end", curve.end, spline.points().back());
  }

  std::string describe(std::size_t c) const { return describe_curve(boundary_, static_cast<int>(c)); }
  /// One end of a curve: "curve 'wall' (2) at parameter 0, (1, 0)".
  std::string describe_end(std::size_t c, bool start) const {
    const BSpline& spline = boundary_.curves[c].spline;
    return describe(c) + " at parameter " +
           describe_number(start ? spline.first_parameter() : spline.last_parameter()) + ", " +
           describe_point(start ? spline.points().front() : spline.points().back());
  }

  void check_end(std::size_t c, const char* which, int v, const Point& p) {
    const std::string place = curve_place(c, which), end = describe_end(c, which == std::string_view("start"));
    if (v == no_vertex) return fault(place, end + ": an open curve needs a vertex here");
    if (!is_vertex(v)) return fault(place, end + ": there is no vertex " + std::to_string(v));
    const Point& vertex = boundary_.vertices[static_cast<std::size_t>(v)];
    if (!(vertex == p))
      fault(place, end + ", should end in vertex " + std::to_string(v) + ", but that is at " + describe_point(vertex) +
                       ", " + describe_number(distance(vertex, p)) + " away: both need the same coordinates");
  }

  void check_sides() {
    const int faces = static_cast<int>(boundary_.faces.size());
    std::set<int> bounded;
    for (std::size_t c = 0; c < boundary_.curves.size(); ++c) {
      const Curve& curve = boundary_.curves[c];
      for (const auto& [side, which] : {std::pair(curve.left, "left"), std::pair(curve.right, "right")}) {
        if (side < outside || side >= faces)
          fault(curve_place(c, which), describe(c) + ": there is no face " + std::to_string(side));
        bounded.insert(side);
      }
      if (curve.left == outside && curve.right == outside)
        fault(curve_place(c, "left"), describe_end(c, true) +
                                          ": the curve has no face on either side; name one, or "
                                          "leave the curve out");
    }
    for (int f = 0; f < faces; ++f)
      if (bounded.count(f) == 0)
        fault("/faces/" + std::to_string(f), "no curve bounds " + face_name(f) + ": none has it as left or right");
  }

  std::string face_name(int f) const { return "face '" + boundary_.faces[static_cast<std::size_t>(f)].name + "'"; }

  /// Checks that at every vertex as many curves of a face arrive as leave, when they run with the face on their left.
  void check_chains() {
    std::map<std::pair<int, int>, int> balance;  // (face, vertex) -> curves that leave minus curves that arrive
    for (const Curve& curve : boundary_.curves) {
      if (curve.spline.closed()) continue;
      ++balance[{curve.left, curve.start}];
      --balance[{curve.left, curve.end}];
      ++balance[{curve.right, curve.end}];
      --balance[{curve.right, curve.start}];
    }
    std::erase_if(balance, [](const auto& entry) { return entry.second == 0 || entry.first.first == outside; });
    for (const auto& [key, count] : balance) {
      const auto [f, v] = key;
      if (faults_.size() >= most_chain_faults) return;
      fault("/vertices/" + std::to_string(2 * v),
            "the boundary of " + face_name(f) + (count > 0 ? " starts" : " ends") + " at vertex " + std::to_string(v) +
                " " + describe_point(point(v)) + " and does not close there: " + describe_vertex(v) +
                describe_rest(balance, f, v, count));
    }
  }

  const Point& point(int v) const { return boundary_.vertices[static_cast<std::size_t>(v)]; }

  /// The curves that end at a vertex, and the faces beside them.
  std::string describe_vertex(int v) const {
    const auto side = [this](int f) { return f == outside ? std::string("the outside") : face_name(f); };
    std::string text;
    std::size_t count = 0;
    constexpr std::size_t most = 4;
    for (std::size_t c = 0; c < boundary_.curves.size(); ++c)
      for (const bool starts : {true, false}) {
        const Curve& curve = boundary_.curves[c];
        if ((starts ? curve.start : curve.end) != v || ++count > most) continue;
        const BSpline& spline = curve.spline;
        text += (text.empty() ? "" : "; ") + describe(c) +
                (starts ? " starts there, at parameter " : " ends there, at parameter ") +
                describe_number(starts ? spline.first_parameter() : spline.last_parameter()) + ", " + side(curve.left) +
                " on its left, " + side(curve.right) + " on its right";
      }
    return count > most ? text + "; and " + std::to_string(count - most) + " more" : text;
  }

  /// Where the rest of an open boundary of face f is, as seen from the vertex where it starts or ends.
  std::string describe_rest(const std::map<std::pair<int, int>, int>& balance, int f, int v, int count) const {
    int nearest = no_vertex;
    for (auto it = balance.lower_bound({f, no_vertex}); it != balance.end() && it->first.first == f; ++it) {
      const int other = it->first.second;
      if ((it->second > 0) == (count > 0)) continue;
      if (nearest == no_vertex || distance(point(other), point(v)) < distance(point(nearest), point(v)))
        nearest = other;
    }
    if (nearest == no_vertex) return {};
    const double gap = distance(point(nearest), point(v));
    return std::string(". It ") + (count > 0 ? "ends" : "starts") + " at vertex " + std::to_string(nearest) + " " +
           describe_point(point(nearest)) +
           (gap == 0 ? ", the same point: one vertex should stand for both"
                     : ", " + describe_number(gap, 1e-6 * gap) + " away");
  }

  const BoundaryComplex& boundary_;
  std::vector<Fault> faults_;
};

}  // namespace

std::vector<Fault> check_boundary(const BoundaryComplex& boundary) { return Structure(boundary).check(); }

}  // namespace pliant
