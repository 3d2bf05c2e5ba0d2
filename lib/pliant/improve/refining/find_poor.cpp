// lib/pliant/improve/refining/find_poor.cpp: the triangles that are to be flipped or cut before a round of refinement.
#include "pliant/improve/refining/find_poor.h"

#include <algorithm>

#include "pliant/improve/refining/quick_goals.h"
#include "pliant/mesh/turned_over.h"

namespace pliant {

double longest_edge(const Mesh& mesh, TriangleId t) {
  double longest = 0;
  for (int e = 0; e < 3; ++e)
    longest = std::max(longest, distance(mesh.point(mesh.corner(t, e)), mesh.point(mesh.corner(t, (e + 1) % 3))));
  return longest;
}

bool is_excused(const Mesh& mesh, TriangleId t, const SharpCorners& corners) {
  return !corners.empty() && corners.excuses(mesh, shortest_edge(mesh, t), longest_edge(mesh, t));
}

std::vector<TriangleId> find_bad(const Mesh& mesh, const QualityGoals& goals) {
  const QuickGoals quick(mesh, goals);
  std::vector<TriangleId> bad;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
    if (mesh.is_alive(t) && !quick.are_surely_met(t) && (is_turned_over(mesh, t) || attack_on(mesh, t, goals).reason))
      bad.push_back(t);
  return bad;
}

std::vector<TriangleId> find_poor(const Mesh& mesh, const QualityGoals& goals, const std::vector<TriangleId>& bad) {
  std::vector<TriangleId> poor;
  for (const TriangleId t : bad)
    if (is_turned_over(mesh, t) || attack_on(mesh, t, goals).is_poor) poor.push_back(t);
  if (poor.empty()) return poor;
  const SharpCorners corners(mesh);
  std::erase_if(poor, [&](TriangleId t) { return is_excused(mesh, t, corners); });
  return poor;
}

}  // namespace pliant
