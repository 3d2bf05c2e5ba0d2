// tests/generate/meshed_boundary.h: a first mesh, held to all that every first mesh promises.
#pragma once
#include <catch2/catch.hpp>
#include <vector>

#include "pliant/boundary/check_boundary.h"
#include "pliant/generate/mesh_from_boundary.h"
#include "pliant/geometry/validity/jacobian.h"
#include "pliant/mesh/check_mesh.h"

namespace pliant {

/// Area of each face by Green's theorem on its curves.
inline std::vector<double> enclosed_areas(const BoundaryComplex& boundary) {
  std::vector<double> area(boundary.faces.size(), 0);
  for (const Curve& curve : boundary.curves) {
    if (curve.left != outside) area[static_cast<std::size_t>(curve.left)] += curve.spline.area();
    if (curve.right != outside) area[static_cast<std::size_t>(curve.right)] -= curve.spline.area();
  }
  return area;
}

inline std::vector<double> meshed_areas(const Mesh& mesh) {
  std::vector<double> area(mesh.boundary().faces.size(), 0);
  std::vector<Point> net(static_cast<std::size_t>(mesh.net_size()));
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    mesh.gather_points(t, net);
    area[static_cast<std::size_t>(mesh.face(t))] += element_area(mesh.degree(), net);
  }
  return area;
}

/// The first mesh of a boundary without fault: clean in structure, every element certified, every area that of its
/// curves.
inline Mesh meshed(const BoundaryComplex& boundary, int degree = 0) {
  for (const std::vector<Fault>& faults : {check_boundary(boundary), check_boundary_geometry(boundary)})
    for (const Fault& fault : faults) {
      CAPTURE(fault.place, fault.text);
      REQUIRE(false);
    }
  Mesh mesh;
  const GenerateOutcome outcome = mesh_from_boundary(boundary, {degree}, mesh);
  CAPTURE(outcome.failure);
  REQUIRE(outcome.ok);
  for (const Fault& fault : check_mesh(mesh)) {  // of the document, and of what the mesh derives from it
    CAPTURE(fault.invariant, fault.place, fault.text);
    CHECK(false);
  }
  CHECK(find_invalid(mesh).empty());
  const std::vector<double> area = meshed_areas(mesh), expected = enclosed_areas(boundary);
  // A band much longer than wide encloses little of what its sums add up: rounding is relative to the whole.
  const double rounding = 1e-15 * mesh.size() * mesh.size();
  for (std::size_t f = 0; f < area.size(); ++f) CHECK(area[f] == Approx(expected[f]).epsilon(1e-13).margin(rounding));
  return mesh;
}

}  // namespace pliant
