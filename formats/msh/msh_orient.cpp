// formats/msh/msh_orient.cpp: turns clockwise triangles, part by part.
#include <algorithm>

#include "formats/msh/msh_mesh.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/net_layout.h"

namespace pliant {

std::size_t orient_triangles(MeshData& mesh) {
  const NetLayout& layout = NetLayout::of(mesh.degree);
  const std::size_t size = index(layout.size()), triangles = mesh.triangle_faces.size();
  const auto corner = [&](std::size_t t, int c) { return mesh.triangles[t * size + index(c % 3)]; };
  const std::vector<HalfEdgeId> twins = twins_by_vertices(mesh);

  // +1 or -1: does a triangle run round as the first one of its part does? The neighbours decide, not the area, so that
  // a tangled triangle among sound ones keeps its direction.
  std::vector<signed char> sense(triangles, 0);
  std::vector<std::size_t> part;
  std::size_t turned = 0;
  for (std::size_t start = 0; start < triangles; ++start) {
    if (sense[start] != 0) continue;
    part.assign(1, start);
    sense[start] = 1;
    double area = 0;
    for (std::size_t done = 0; done < part.size(); ++done) {
      const std::size_t t = part[done];
      const Point a = mesh.points[index(corner(t, 0))];
      area += sense[t] * cross(mesh.points[index(corner(t, 1))] - a, mesh.points[index(corner(t, 2))] - a);
      for (int e = 0; e < 3; ++e) {
        const HalfEdgeId g = twins[3 * t + index(e)];
        if (g == none || sense[index(triangle_of(g))] != 0) continue;
        const bool opposite = corner(index(triangle_of(g)), edge_of(g)) == corner(t, e + 1);
        sense[index(triangle_of(g))] = static_cast<signed char>(opposite ? sense[t] : -sense[t]);
        part.push_back(index(triangle_of(g)));
      }
    }
    for (const std::size_t t : part) {
      if ((sense[t] > 0) == (area >= 0)) continue;
      ++turned;
      std::vector<PointId> net(size);
      for (int k = 0; k < layout.size(); ++k) {
        const auto& exponents = layout.exponents(k);
        net[index(layout.index(exponents[0], exponents[2]))] = mesh.triangles[t * size + index(k)];
      }
      std::copy(net.begin(), net.end(), mesh.triangles.begin() + static_cast<std::ptrdiff_t>(t * size));
    }
  }
  return turned;
}

}  // namespace pliant
