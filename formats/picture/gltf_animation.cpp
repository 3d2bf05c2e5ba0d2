// formats/picture/gltf_animation.cpp: the frames of a series, one after the other.
#include "formats/picture/gltf_animation.h"

#include <utility>

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>

namespace pliant {

void animate_frames(tinygltf::Model& model, GltfBuffer& buffer, const std::vector<int>& frames,
                    double frames_per_second) {
  const auto key = [frames_per_second](std::size_t i) { return static_cast<float>(double(i) / frames_per_second); };
  const std::size_t count = frames.size();
  tinygltf::Animation animation;
  animation.name = "series";
  const int first = buffer.add_scales({1, 0}), middle = count > 2 ? buffer.add_scales({0, 1, 0}) : -1,
            last = buffer.add_scales({0, 1, 1});
  for (std::size_t i = 0; i < count; ++i) {
    tinygltf::AnimationSampler sampler;
    sampler.interpolation = "STEP";
    // The last frame has a second key at its end, which gives it its time on the screen.
    sampler.input = i == 0 ? buffer.add_keys({0, key(1)}) : buffer.add_keys({0, key(i), key(i + 1)});
    sampler.output = i == 0 ? first : i + 1 == count ? last : middle;
    tinygltf::AnimationChannel channel;
    channel.sampler = static_cast<int>(i);
    channel.target_node = frames[i];
    channel.target_path = "scale";
    animation.samplers.push_back(std::move(sampler));
    animation.channels.push_back(std::move(channel));
  }
  model.animations.push_back(std::move(animation));
}

}  // namespace pliant
