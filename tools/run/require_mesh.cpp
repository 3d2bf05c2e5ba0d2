// tools/run/require_mesh.cpp: refuses meshes that break what a tool needs.
#include "run/require_mesh.h"

#include <string>

#include "pliant/mesh/check_mesh.h"
#include "run/exit_status.h"

namespace pliant {
namespace {

std::string list_elements(const InvalidElements& bad) {
  constexpr std::size_t most = 8;
  std::string text;
  std::size_t count = 0;
  for (const auto* elements : {&bad.invalid, &bad.degenerate})
    for (const TriangleId t : *elements)
      if (count++ < most) text += (text.empty() ? "" : ", ") + std::to_string(t);
  return count > most ? text + ", ..." : text;
}

void refuse_invalid(const InvalidElements& bad, int degree, std::size_t all) {
  if (bad.empty()) return;
  const std::size_t count = bad.invalid.size() + bad.degenerate.size();
  const TriangleId first = bad.invalid.empty() ? bad.degenerate.front() : bad.invalid.front();
  throw BadMesh({{"M3", "/triangles/" + std::to_string(first * net_size(degree)),
                  std::to_string(count) + " of " + std::to_string(all) + " elements are not valid (" +
                      list_elements(bad) + "); smoothcurves may untangle them"}});
}

}  // namespace

void require_mesh(const MeshData& data, bool accepts_tangled) {
  std::vector<Fault> faults = check_structure(data, 3);
  constexpr std::size_t most = 10;
  if (faults.size() > most) faults.resize(most);
  for (Fault& fault : faults) fault.text += " (" + fault.invariant + ")";
  if (!faults.empty()) throw BadMesh(std::move(faults));
  if (!accepts_tangled) refuse_invalid(find_invalid(data), data.degree, data.triangle_faces.size());
}

void require_valid(const Mesh& mesh) {
  refuse_invalid(find_invalid(mesh), mesh.degree(), static_cast<std::size_t>(mesh.triangle_count()));
}

}  // namespace pliant
