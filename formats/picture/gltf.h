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
  std::optional<ValueRange> range;      ///< the values of the first and last colour; by default the range of all frames
  int subdivide = 0;                    ///< pieces of every edge; 0: as many as curvature and colours need
  double tolerance = 2e-4;              ///< how far chords may be from curved edges, as a part of the first mesh's size
  std::optional<double> outline_width;  ///< of constrained edges; by default 1/400 of the first mesh's size
  double frames_per_second = 25;
  bool edges = true;
  bool quantize = true;           ///< positions in 16 bits (KHR_mesh_quantization); otherwise in single precision
  std::optional<ColorBy> height;  ///< a field that lifts the surface; the plane is at its least value of all frames
  std::optional<double> height_scale;  ///< height of the value 1, in mesh units; by default the field's range of all
                                       ///< frames is a quarter of the first mesh's size
  bool lit = false;  ///< normals, and materials that want light, for elements; otherwise colours are shown as they are
  std::vector<Circle> circles;
};

/// Collects the frames of a series; the meshes themselves are not kept.
///
/// Vertices are in single precision and relative to the centre of the first mesh's box. The scene's top node moves them
/// back to their place, and scales them where the mesh has a size that viewers are not made for. Below it is one node
/// for each frame, which the animation scales to 1 during its frame and to 0 otherwise.
class GltfWriter {
 public:
  explicit GltfWriter(GltfOptions options);
  ~GltfWriter();
  /// Requires    M1 and M2 (check_structure); the mesh may be tangled
  /// Throws      std::invalid_argument where the mesh has no such field (ElementValues); InputError for frames too far
  ///             from the first mesh, too large or too small beside it for single precision
  void add(const MeshData& mesh);
  /// The file: binary (.glb), or JSON with its buffer inside (.gltf). To be called once, after at least one frame.
  std::string finish(bool binary);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace pliant
