// tests/ops/pinched_test.cpp: operations on lobes that touch each other in one vertex.
#include "mesh/same_mesh.h"
#include "ops/carried_domains.h"
#include "pliant/mesh/star.h"

using namespace pliant;

namespace {

/// Two lobes, each bounded by one curve that starts and ends at the vertex in the origin.
BoundaryComplex figure_eight(int degree) {
  BoundaryComplex b = samples::with_faces({"right", "left"});
  b.vertices = {{0, 0}};
  for (int lobe = 0; lobe < 2; ++lobe) {
    const double side = lobe == 0 ? 1 : -1;
    const int spans = 5;
    std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0.0);
    for (int k = 1; k < spans; ++k) knots.push_back(k);
    knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, spans);
    const int count = spans + degree;
    std::vector<Point> points;
    for (int k = 0; k < count; ++k) {
      const double a = -2.4 + 4.8 * k / (count - 1);
      points.push_back(side * Point{1.2 + std::cos(a), std::sin(a)});
    }
    points.front() = points.back() = Point{0, 0};
    Curve curve =
        samples::closed_curve(lobe == 0 ? "right" : "left", BSpline(degree, false, knots, std::move(points)), lobe);
    curve.start = curve.end = 0;
    b.curves.push_back(std::move(curve));
  }
  return b;
}
const Domain eight{"two lobes", figure_eight};

PointId pinch_of(const Mesh& mesh) {
  PointId found = none;
  for (PointId p = 0; p < mesh.point_slots(); ++p)
    if (mesh.is_point_alive(p) && mesh.is_vertex(p) && mesh.is_pinched(p)) {
      CHECK(found == none);
      found = p;
    }
  REQUIRE(found != none);
  return found;
}

/// Checks the star of v, and which vertices edges join it to, by a look at all triangles.
void check_star(const Mesh& mesh, PointId v) {
  Star star;
  find_star(mesh, v, star);
  CHECK(star.components == 2);
  CHECK(!star.is_closed);
  std::vector<HalfEdgeId> wanted;
  std::vector<char> joined(static_cast<std::size_t>(mesh.point_slots()), 0);
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
    for (int e = 0; e < 3 && mesh.is_alive(t); ++e)
      if (mesh.origin(half_edge(t, e)) == v) {
        const HalfEdgeId h = half_edge(t, e);
        wanted.push_back(h);
        joined[static_cast<std::size_t>(mesh.target(h))] = joined[static_cast<std::size_t>(mesh.apex(h))] = 1;
        CHECK(find_half_edge(mesh, v, mesh.target(h)) == h);
        CHECK(find_half_edge(mesh, mesh.apex(h), v) == previous(h));
      }
  std::sort(star.outgoing.begin(), star.outgoing.end());
  CHECK(star.outgoing == wanted);
  for (PointId p = 0; p < mesh.point_slots(); ++p)
    if (p != v && mesh.is_vertex(p)) CHECK(are_joined(mesh, v, p) == (joined[static_cast<std::size_t>(p)] != 0));
}

}  // namespace

TEST_CASE("every component of a pinched vertex's star is seen, whatever operations go on around it",
          "[ops][property]") {
  const int degree = GENERATE(1, 2, 3);
  CAPTURE(degree);
  Mesh mesh = carried(eight, degree);
  const std::vector<double> before = kept_sums(mesh);
  check_star(mesh, pinch_of(mesh));
  RandomOperations operations(mesh, 29, 4 * mesh.triangle_count());
  for (int block = 0; block < 20; ++block) {
    operations.run(50);
    require_every_invariant(mesh);
    const PointId v = pinch_of(mesh);
    check_star(mesh, v);
    const MeshData data = mesh.to_data();
    CHECK(remove_inner_vertex(mesh, v) == Outcome::constrained);
    CHECK(remove_curve_vertex(mesh, v, {HUGE_VAL}).outcome == Outcome::corner);
    CHECK(same_document(data, mesh.to_data()));
    const Mesh read(data);
    mesh.compact();
    CHECK(difference(mesh, read) == "");
    check_star(mesh, pinch_of(mesh));
  }
  CHECK(operations.done > 200);
  const std::vector<double> after = kept_sums(mesh);
  for (std::size_t k = 0; k < after.size(); ++k) CHECK(after[k] == Approx(before[k]).margin(1e-10));
}

TEST_CASE("a flip joins no vertices that an edge of another component joins already", "[ops]") {
  // A square of two triangles, and a third triangle that touches it at its upper and its lower corner: the side between
  // these goes round the square.
  samples::MeshBuilder builder(2);
  BoundaryComplex& boundary = builder.data().boundary;
  boundary = samples::with_faces({"face"});
  boundary.vertices = {{-1, 0}, {0, -1}, {1, 0}, {0, 1}, {6, 0}};
  const int a = 0, down = 1, b = 2, up = 3, right = 4;
  for (const Point& p : boundary.vertices) builder.add_vertex(p);
  const auto add_side = [&](int from, int to, const Point& bend) {
    const Point& p = builder.at(from);
    const Point& q = builder.at(to);
    const Point middle = 0.5 * (p + q) + bend;
    builder.data().constrained_edges.push_back(
        {static_cast<CurveId>(boundary.curves.size()), 0, builder.curved_edge(from, to, {p, middle, q})});
    boundary.curves.push_back(
        samples::open_curve(boundary, "side " + std::to_string(boundary.curves.size()), from, to, {middle}, 0));
  };
  add_side(a, down, {}), add_side(down, b, {}), add_side(b, up, {}), add_side(up, a, {});
  add_side(down, right, {}), add_side(right, up, {}), add_side(up, down, {3, 0});
  builder.add_triangle(a, b, up, 0);
  builder.add_triangle(b, a, down, 0);
  builder.add_triangle(down, right, up, 0);
  Mesh mesh(std::move(builder.data()));
  require_every_invariant(mesh);
  CHECK(mesh.is_pinched(up));
  CHECK(mesh.is_pinched(down));
  CHECK(flip_edge(mesh, find_half_edge(mesh, a, b)) == Outcome::edge_exists);
  // Once that side is split, the flip makes the only edge between the two corners.
  REQUIRE(split_edge(mesh, find_half_edge(mesh, up, down), 0.5).outcome == Outcome::done);
  CHECK(flip_edge(mesh, find_half_edge(mesh, a, b)) == Outcome::done);
  require_every_invariant(mesh);
  // After the flip, the split cannot be undone.
  const HalfEdgeId h = find_half_edge(mesh, up, down);
  REQUIRE(h != none);
  Star star;
  find_star(mesh, up, star);
  int refused = 0;
  for (PointId v = 0; v < mesh.point_slots(); ++v)
    if (mesh.is_point_alive(v) && mesh.is_vertex(v))
      refused += remove_curve_vertex(mesh, v, {HUGE_VAL}).outcome == Outcome::edge_exists;
  CHECK(refused == 1);
  require_every_invariant(mesh);
}
