// formats/picture/gltf.h: a mesh, or a series as an animation, as glTF 2.0 (formats/gltf.md).
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "formats/picture/coloring.h"
#include "pliant/mesh/mesh_data.h"

namespace pliant {

struct GltfOptions {
  ColorBy color;
  const Colormap* map = colormaps().data();
  std::optional<ValueRange> range;      ///< otherwise that of all frames
  int subdivide = 0;                    ///< pieces of every edge; 0: as many as curvature and colours take
  double tolerance = 2e-4;              ///< of curved edges, as a part of the size of the first mesh
  std::optional<double> outline_width;  ///< of constrained edges, in mesh units; otherwise 1/400 of that size
  double frames_per_second = 25;
  bool edges = true;
  bool quantize = false;  ///< positions in 16 bits (KHR_mesh_quantization)
  std::vector<Circle> circles;
};

/// Collects the frames of a series; the meshes themselves are not kept.
///
/// The scene has a node that puts the centre of the first mesh's box back in place, and back to its size where that is
/// none that viewers are made for (vertices are single precision, relative to it); below it a node a frame, which the
/// animation scales to 1 during its frame and to 0 otherwise.
class GltfWriter {
 public:
  explicit GltfWriter(GltfOptions options);
  ~GltfWriter();
  /// Requires    M1 and M2 (check_structure); the mesh may be tangled
  /// Throws      std::invalid_argument where the mesh has no such field (ElementValues); InputError for what single
  ///             precision cannot show beside the first mesh
  void add(const MeshData& mesh);
  /// The file: binary (.glb), or JSON with its buffer inside (.gltf). Once, after at least one frame.
  std::string finish(bool binary);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace pliant
