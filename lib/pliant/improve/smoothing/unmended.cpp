// lib/pliant/improve/smoothing/unmended.cpp: the reason, as far as the element alone shows it, and its words.
#include "pliant/improve/smoothing/unmended.h"

#include <array>

#include "pliant/geometry/control_net.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/predicates.h"
#include "pliant/mesh/turned_over.h"
#include "pliant/ops/build_triangle.h"

namespace pliant {
namespace {

/// Does the element have a corner between two edges on curves where det J <= 0? These curves alone decide that.
bool has_fixed_bad_corner(const Mesh& mesh, TriangleId t) {
  for (int e = 0; e < 3; ++e) {
    const HalfEdgeId out = half_edge(t, e), in = previous(out);
    if (!mesh.is_constrained(out) || !mesh.is_constrained(in)) continue;
    if (orient2d(mesh.point(mesh.edge_point(in, mesh.degree() - 1)), mesh.point(mesh.origin(out)),
                 mesh.point(mesh.edge_point(out, 1))) <= 0)
      return true;
  }
  return covers_smooth_corner(mesh, t);
}

Point centre_of(const Mesh& mesh, TriangleId t) {
  std::array<double, 2 * net_size(max_degree)> rows;
  const auto ids = mesh.net(t);
  for (std::size_t k = 0; k < ids.size(); ++k) {
    rows[2 * k] = mesh.point(ids[k]).x;
    rows[2 * k + 1] = mesh.point(ids[k]).y;
  }
  std::array<double, 2> centre;
  evaluate_net(mesh.degree(), 2, {rows.data(), 2 * index(mesh.net_size())}, {1.0 / 3, 1.0 / 3, 1.0 / 3}, centre);
  return {centre[0], centre[1]};
}

}  // namespace

std::string describe(Unmended reason, const SmoothMeans& means) {
  switch (reason) {
    case Unmended::smooth_corner:
      return "two edges on curves meet in it at 180 degrees or more; no place of its inner points helps";
    case Unmended::needs_split:
      return std::string("its edge on a curve is too long or too bent") + (means.split ? "" : "; --split would help");
    case Unmended::needs_refinement:
      return "its edge on a curve is too long or too bent, and a split of it alone makes the mesh worse; refine may "
             "help";
    case Unmended::turned_over: {
      const char* help = means.vertices && means.flips ? ""
                         : means.vertices              ? "; --flips may help"
                         : means.flips                 ? "; --vertices may help"
                                                       : "; --vertices or --flips may help";
      return std::string("its straight triangle is turned over or flat") + help;
    }
    case Unmended::no_better_place:
      break;
  }
  return std::string("no better place was found for its points") + (means.vertices ? "" : "; --vertices may help");
}

UnmendedElement explain_unmended(const Mesh& mesh, TriangleId t) {
  return {t, centre_of(mesh, t),
          has_fixed_bad_corner(mesh, t) ? Unmended::smooth_corner
          : is_turned_over(mesh, t)     ? Unmended::turned_over
                                        : Unmended::no_better_place};
}

}  // namespace pliant
