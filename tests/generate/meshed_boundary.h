// tests/generate/meshed_boundary.h: a first mesh that is checked for all that every first mesh promises.
#pragma once
#include <catch2/catch.hpp>
#include <vector>

#include "pliant/boundary/check_boundary.h"
#include "pliant/generate/mesh_from_boundary.h"
#include "pliant/geometry/validity/jacobian.h"
#include "pliant/mesh/check_mesh.h"

namespace pliant {

/// The area of each face, by Green's theorem on its curves.
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

/// The first mesh of a sound boundary. Checks that its structure has no fault, that every element is certified valid,
/// and that every face has the area which its curves enclose.
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
  for (const Fault& fault : check_mesh(mesh)) {  // in the document, and in what the mesh derives from it
    CAPTURE(fault.invariant, fault.place, fault.text);
    CHECK(false);
  }
  CHECK(find_invalid(mesh).empty());
  const std::vector<double> area = meshed_areas(mesh), expected = enclosed_areas(boundary);
  // The area of a band much longer than wide is a small difference of large terms, so rounding is relative to the box.
  const double rounding = 1e-15 * mesh.size() * mesh.size();
  for (std::size_t f = 0; f < area.size(); ++f) CHECK(area[f] == Approx(expected[f]).epsilon(1e-13).margin(rounding));
  return mesh;
}

}  // namespace pliant
