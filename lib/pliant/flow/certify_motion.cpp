// lib/pliant/flow/certify_motion.cpp: the certificate of each element's motion, the least of all.
#include "pliant/flow/certify_motion.h"

#include <vector>

#include "pliant/geometry/validity/swept_validity.h"
#include "pliant/geometry/validity/validity.h"
#include "pliant/mesh/check_mesh.h"

namespace pliant {
namespace {

/// A motion is proved around a cusp only as a whole, by its end: where it is not, this part of it is tried next.
constexpr double part_at_cusp = 0.5;

double certify_element_motion(const Mesh& mesh, std::span<const Point> from, std::span<const Point> to) {
  const int cusp = mesh.boundary().cusps.empty() ? none : cusp_corner(mesh.boundary(), from);
  const double fraction = safe_fraction(mesh.degree(), from, to, cusp);
  if (cusp == none || fraction < 1) return fraction;
  return certify_cusp(mesh.degree(), to, cusp) == Validity::valid ? 1 : part_at_cusp;
}

}  // namespace

MotionCertificate certify_motion(const Mesh& mesh, std::span<const Point> points) {
  MotionCertificate result;
  std::vector<Point> from(static_cast<std::size_t>(mesh.net_size()));
  std::vector<Point> to(from.size());
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (!mesh.is_alive(t)) continue;
    mesh.gather_points(t, from);
    const auto net = mesh.net(t);
    for (std::size_t i = 0; i < net.size(); ++i) to[i] = points[static_cast<std::size_t>(net[i])];
    const double fraction = certify_element_motion(mesh, from, to);
    if (fraction < result.fraction) result = {fraction, t};
  }
  return result;
}

long count_invalid(const Mesh& mesh) {
  long count = 0;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
    if (mesh.is_alive(t) && certify_element(mesh, t) != Validity::valid) ++count;
  return count;
}

}  // namespace pliant
