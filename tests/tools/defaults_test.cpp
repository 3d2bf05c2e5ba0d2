// tests/tools/defaults_test.cpp: library calls without options do, to the bit, what the bare tools do.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <string>

#include "pliant/flow/advect_to.h"
#include "pliant/generate/mesh_from_boundary.h"
#include "pliant/generate/refine_first_mesh.h"
#include "pliant/generate/smooth_or_remesh.h"
#include "pliant/improve/coarsen.h"
#include "pliant/improve/enforce_delaunay.h"
#include "pliant/improve/refine.h"
#include "run_tools.h"
#include "support/sample_meshes.h"

using namespace pliant;
using namespace pliant::testing;

namespace {

std::string after(const std::string& document, const std::function<void(Mesh&)>& pass) {
  Mesh mesh = mesh_of(document);
  pass(mesh);
  return document_of(mesh);
}

/// Each pass without options, on a document as the tools would read it.
void check_passes(const std::string& document) {
  const bool delaunay =
      after(document, [](Mesh& mesh) { enforce_delaunay(mesh); }) == output_of({{"flipdelaunay"}}, document);
  CHECK(delaunay);
  const bool refined = after(document, [](Mesh& mesh) { refine(mesh); }) == output_of({{"refine"}}, document);
  CHECK(refined);
  const bool coarsened = after(document, [](Mesh& mesh) { coarsen(mesh); }) == output_of({{"coarsen"}}, document);
  CHECK(coarsened);
  const bool smoothed =
      after(document, [](Mesh& mesh) { smooth_or_remesh(mesh); }) == output_of({{"smoothcurves"}}, document);
  CHECK(smoothed);
  const bool moved = after(document, [](Mesh& mesh) {
                       AdvectOptions options;
                       options.dt = 0.1;
                       advect_to(mesh, make_flow("shear", {}), options);
                     }) == output_of({{"advect", "--flow", "shear", "--dt", "0.1"}}, document);
  CHECK(moved);
}

}  // namespace

TEST_CASE("a pass without options does what the bare tool does", "[tools]") {
  const int degree = GENERATE(1, 2, 3, 4);
  CAPTURE(degree);
  const std::string document = degree == 1 ? document_of(Mesh(samples::three_disks(1))) : three_cells(degree);
  SECTION("to a first mesh") { check_passes(document); }
  SECTION("to a mesh that was moved, so that each pass has work") {
    const Words moved{"advect", "--vx", "0.5*sin(2*y)", "--vy", "0.4*sin(2*x)", "--dt", "1", "--limit"};
    check_passes(output_of(
        {moved, {"refine", "--max-area", "0.02"}, {"advect", "--vx", "y", "--vy", "0", "--dt", "0.4", "--limit"}},
        document));
  }
  SECTION("to a mesh that promises something") {
    check_passes(output_of({{"refine", "--max-area", "0.1", "--face-area", degree == 1 ? "upper=0.2" : "close=0.03",
                             "--max-turning", "25", "--min-angle", "25", "--thin", "keep", "--min-size", "1e-3"}},
                           document));
  }
}

TEST_CASE("smoothing without options meshes anew what stays tangled, as the bare tool does", "[tools]") {
  const std::string swirl = "*7*(1-x*x-y*y)";
  const std::string tangled =
      output_of({{"refine", "--max-area", "0.06"},
                 {"advect", "--vx", "-y" + swirl, "--vy", "x" + swirl, "--dt", "1", "--substeps", "50", "--force"}},
                document_of(Mesh(samples::disk(2))));
  Mesh mesh = mesh_of(tangled);
  const SmoothOutcome outcome = smooth_or_remesh(mesh);
  CHECK(outcome.invalid.empty());
  CHECK(outcome.report.values.back().first == "patches_remeshed");
  CHECK(outcome.report.values.back().second > 0);
  const bool same = document_of(mesh) == output_of({{"smoothcurves"}}, tangled);
  CHECK(same);
}

TEST_CASE("the first mesh of a boundary, refined without options, is that of the bare tool", "[tools]") {
  for (const char* const name : {"three-cells/cells.json", "examples/disk.json"}) {
    CAPTURE(name);
    const std::string text = sample(name);
    Mesh mesh;
    REQUIRE(mesh_from_boundary(read_boundary(text), {}, mesh).ok);
    refine_first_mesh(mesh);
    const bool same = document_of(mesh) == output_of({{"bspline2mesh"}}, text);
    CHECK(same);
  }
}

TEST_CASE("passes without options refuse a size that only the caller can compile", "[tools]") {
  Mesh mesh(samples::disk(2));
  mesh.criteria.size = "0.1+x*x";
  CHECK_THROWS_AS(refine(mesh), std::invalid_argument);
  CHECK_THROWS_AS(coarsen(mesh), std::invalid_argument);
}
