// tests/improve/monotone_test.cpp: no further option of smoothing leaves a mesh worse.
#include <catch2/catch.hpp>
#include <cstdlib>

#include "improve/tangled_meshes.h"
#include "pliant/improve/smooth_curves.h"
#include "pliant/quality/quality_summary.h"

using namespace pliant;
using namespace pliant::improve_meshes;

namespace {

/// How many meshes are tried at degree 1 and 2: as many as PLIANT_SMOOTHINGS says, or 8.
std::uint64_t mesh_count() {
  const char* const text = std::getenv("PLIANT_SMOOTHINGS");
  return text ? static_cast<std::uint64_t>(std::atoi(text)) : 8;
}

struct Result {
  QualitySummary quality;
  std::string text;
};
Result smoothed(Mesh mesh, const SmoothMeans& means) {
  SmoothOptions options;
  options.vertices = means.vertices;
  options.flips = means.flips;
  options.split = means.split;
  const SmoothOutcome outcome = smooth_curves(mesh, options);
  Result result{summarize_quality(mesh.to_data()), text_of(mesh)};
  CHECK(result.quality.invalid + result.quality.degenerate == static_cast<std::int64_t>(outcome.invalid.size()));
  for (const Fault& fault : check_mesh(mesh)) FAIL_CHECK(fault.place << ": " << fault.text);
  return result;
}

/// Compares what the quality report says, to the last bit.
void check_no_worse(const Result& more, const Result& less) {
  CHECK(more.quality.invalid + more.quality.degenerate <= less.quality.invalid + less.quality.degenerate);
  CHECK(more.quality.min_shape >= less.quality.min_shape);
  CHECK(more.quality.min_scaled_jacobian >= less.quality.min_scaled_jacobian);
}

/// Returns whether any option found something to do.
bool check_options(const Mesh& mesh) {
  const Result none = smoothed(mesh, {});
  const Result vertices = smoothed(mesh, {true, false, false}), flips = smoothed(mesh, {false, true, false});
  const Result split = smoothed(mesh, {false, false, true}), two = smoothed(mesh, {true, true, false});
  const Result all = smoothed(mesh, {true, true, true});
  check_no_worse(vertices, none);
  check_no_worse(flips, none);
  check_no_worse(split, none);
  check_no_worse(two, vertices);
  check_no_worse(all, two);
  return all.text != none.text;
}

}  // namespace

TEST_CASE(
    "an option more never leaves the least shape, the least scaled Jacobian or the number of invalid elements worse",
    "[improve][property][long]") {
  const int degree = GENERATE(1, 2, 3, 4);
  std::uint64_t with_more_to_do = 0;
  const std::uint64_t count = std::max<std::uint64_t>(2, mesh_count() / (degree > 3 ? 8 : degree == 3 ? 2 : 1));
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    const Tangled made = tangled(degree, seed);
    CAPTURE(degree, seed, made.name);
    with_more_to_do += check_options(made.mesh);
  }
  if (degree == 2) CHECK(10 * with_more_to_do >= count);  // at higher degrees edges alone may mend all of a short run
}

TEST_CASE("a mesh of Gmsh with thin tangled elements is left no worse by a further option", "[improve]") {
  check_options(mesh_of_gmsh("thin.msh"));
}
