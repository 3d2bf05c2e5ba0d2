// tests/improve/three_cells_test.cpp: the cells of the sample `three-cells` pass their obstacle for some steps; the
// mesh is checked after every pass.
#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>

#include "improve/improve_meshes.h"
#include "pliant/flow/advect.h"
#include "pliant/improve/coarsen.h"
#include "pliant/improve/enforce_delaunay.h"
#include "pliant/improve/refine.h"
#include "pliant/improve/smooth_curves.h"

using namespace pliant;
using namespace pliant::improve_meshes;

namespace {

BoundaryComplex three_cells() {
  std::ifstream file(PLIANT_SAMPLES "/three-cells/cells.json");
  REQUIRE(file);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  BoundaryComplex boundary = read_boundary(text);
  return boundary;
}

/// The passes of a step as in the sample: the defaults of the tools, and `coarsen --keep-area`.
void repair(Mesh& mesh) {
  enforce_delaunay(mesh);
  check_left(mesh);
  RefineOptions fine;
  fine.goals = goals_of(mesh, {});
  refine(mesh, fine);
  check_left(mesh);
  CoarsenOptions coarse;
  coarse.goals = fine.goals;
  coarse.tolerance = 1e-3 * mesh.size();
  coarse.step_tolerance = 0.1 * *coarse.tolerance;
  coarse.keep_area = true;
  coarsen(mesh, coarse);
  check_left(mesh);
  CHECK(smooth_curves(mesh).invalid.empty());
  check_left(mesh);
}

}  // namespace

TEST_CASE("three cells pass the checker after every pass of every step", "[improve]") {
  const int degree = GENERATE(2, 3);
  const double start = GENERATE(0.0, 3.2);  // 3.2: when the cells are stretched most, reached in longer steps
  CAPTURE(degree, start);
  const VelocityField flow = make_flow("cylinder", {{"radius", 1.0}, {"speed", 1.0}});
  Mesh mesh;
  GenerateOptions options;
  options.degree = degree;
  REQUIRE(mesh_from_boundary(three_cells(), options, mesh).ok);
  MeshData data = mesh.to_data();
  data.criteria.max_area = 0.03;
  samples::add_field(data, "one", 1, [](const Point&) { return std::vector<double>{1}; });
  mesh = Mesh(std::move(data));
  std::vector<double> area;
  for (const Curve& curve : mesh.boundary().curves) area.push_back(curve.spline.area());
  repair(mesh);

  AdvectOptions step;
  step.keep_area = true;
  while (mesh.time < start) {
    step.dt = std::min(0.16, start - mesh.time);
    REQUIRE(advect(mesh, flow, step).status == AdvectOutcome::Status::done);
    repair(mesh);
  }
  step.dt = 0.04;
  for (int k = 0; k < 10; ++k) {
    CAPTURE(k);
    REQUIRE(advect(mesh, flow, step).status == AdvectOutcome::Status::done);
    check_left(mesh);
    repair(mesh);
    for (std::size_t c = 0; c < area.size(); ++c)
      CHECK(mesh.boundary().curves[c].spline.area() == Approx(area[c]).epsilon(1e-11));
    CHECK(area_of(mesh) == Approx(area[0] + area[1] + area[2]).epsilon(1e-11));
    double off = 0;
    for (const double value : mesh.fields()[0].values) off = std::max(off, std::abs(value - 1));
    CHECK(off < 1e-12);
  }
}
