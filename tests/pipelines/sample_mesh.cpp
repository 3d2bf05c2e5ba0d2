// tests/pipelines/sample_mesh.cpp: writes a mesh document made without any tool: sample_mesh KIND DEGREE [TIME].
#include <cstdio>
#include <cstdlib>
#include <string>

#include "formats/document/mesh_document.h"
#include "support/carried_members.h"
#include "support/sample_meshes.h"

int main(int argc, char** argv) {
  using namespace pliant;
  if (argc < 3) return 2;
  const std::string kind = argv[1];
  const int degree = std::atoi(argv[2]);
  MeshData data = kind == "three" ? samples::three_disks(degree) : samples::disk(degree);
  if (argc > 3) data.time = std::atof(argv[3]);
  samples::add_field(data, "u", 1, [](const Point& p) { return std::vector<double>{p.x / 3 - 0.1 * p.y}; });
  data.extra = samples::carried({{"step", "7"}});
  if (kind == "tangled") {
    // The middle vertex far out of its star: elements there turn over, the structure stays.
    for (Point& p : data.points)
      if (p == Point{0, 0}) p = {5, 5};
  }
  std::string text;
  write_mesh(data, text);
  std::fwrite(text.data(), 1, text.size(), stdout);
  return 0;
}
