// lib/pliant/flow/mesh_flow.h: the velocity field of another mesh, or of a series of them, as a function.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "pliant/flow/velocity_field.h"
#include "pliant/mesh/mesh.h"

namespace pliant {

/// A velocity that frames carry, each a mesh with a field of two components (continuous or by face): linear in time
/// between frames, and in each frame the field's value in the element that contains the place. A single frame is a
/// flow that does not change.
///
/// A place within 1e-9 of a mesh's size from its outer boundary counts as inside; beyond, and before the first and
/// after the last frame (up to rounding), there is no velocity, or that of the nearest place and frame.
///
/// Units       of the documents, also where a frame's mesh is in another unit (normalize_unit)
/// Complexity  expected O(1) for a place near the last one; all frames are held in memory
class MeshFlow {
 public:
  enum class Outside { refuse, nearest };
  /// `name` is for the texts of NoVelocity.
  MeshFlow(std::string name, Outside policy);
  ~MeshFlow();
  MeshFlow(const MeshFlow&) = delete;
  MeshFlow& operator=(const MeshFlow&) = delete;

  /// Adds a frame.
  /// Requires    a time later than that of the frame before; a valid mesh that is not empty
  void add(Mesh mesh, int field);
  bool empty() const { return frames_.empty(); }
  double last_time() const;  ///< of the frames so far

  /// Remembers where the last place was found, which makes it faster but never changes what it returns; one thread at a
  /// time.
  /// Throws      NoVelocity
  Vector velocity(const Point& place, double time);

 private:
  struct Frame;
  Vector in_frame(Frame& frame, const Point& place, double time);
  double clamp_time(double time) const;

  std::string name_;
  Outside outside_;
  std::vector<std::unique_ptr<Frame>> frames_;
};

}  // namespace pliant
