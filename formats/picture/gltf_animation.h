// formats/picture/gltf_animation.h: the frames of a series, one after the other.
#pragma once
#include <vector>

#include "formats/picture/gltf_buffer.h"

namespace pliant {

/// Animates the frames' nodes: each is shown (scale 1) during its frame and hidden (scale 0) otherwise.
/// Requires    at least two
void animate_frames(tinygltf::Model& model, GltfBuffer& buffer, const std::vector<int>& frames,
                    double frames_per_second);

}  // namespace pliant
