// tests/install/consumer/consumer.cpp: A project's own program on the installed library: reads a boundary, meshes it,
// refines it, and checks what it got.
#include <cmath>
#include <cstdio>
#include <string>

#include "formats/document/mesh_document.h"
#include "pliant/generate/mesh_from_boundary.h"
#include "pliant/improve/refine.h"
#include "pliant/quality/quality_report.h"

namespace {

// A closed quadratic B-spline whose control points are the corners of the unit square. Its arcs join the midpoints of
// the sides and cut a third off each corner's triangle of area 1/8, so its area is 1 - 4/24 = 5/6.
const char* const boundary_text = R"({"format": "pliant-boundary", "version": 1, "vertices": [],
  "faces": [{"name": "cell"}],
  "curves": [{"name": "membrane", "degree": 2, "closed": true, "knots": [0, 1, 2, 3, 4],
              "points": [0, 0, 1, 0, 1, 1, 0, 1], "start": null, "end": null, "left": 0, "right": null,
              "removal_error": 0}],
  "cusps": []})";

}  // namespace

int main() {
  const pliant::BoundaryComplex boundary = pliant::read_boundary(boundary_text);
  pliant::Mesh mesh;
  const pliant::GenerateOutcome outcome = pliant::mesh_from_boundary(boundary, {}, mesh);
  if (!outcome.ok) {
    std::fprintf(stderr, "no mesh: %s\n", outcome.failure.c_str());
    return 1;
  }
  pliant::RefineOptions options;
  options.goals.emplace().max_area = 0.01;
  pliant::refine(mesh, options);

  const pliant::MeshData data = mesh.to_data();
  std::string text;
  pliant::write_mesh(data, text);
  std::string again;
  pliant::write_mesh(pliant::read_mesh(text), again);
  const pliant::QualityReport report = pliant::report_quality(data);
  std::printf("%lld triangles, area %.17g\n", static_cast<long long>(report.triangles), report.area);
  const bool is_right = report.triangles > 83 && report.invalid == 0 && report.faults.empty() &&
                        std::abs(report.area - 5.0 / 6.0) < 1e-12 && again == text;
  return is_right ? 0 : 1;
}
