// formats/svg_import/clip_paths.h: clip paths, as areas where elements refer to them.
#pragma once
#include <array>
#include <functional>
#include <map>
#include <string_view>
#include <vector>

#include "formats/svg_import/context.h"
#include "formats/svg_import/scene.h"

namespace pliant::svg {

inline constexpr int most_nested_clips = 50;  ///< clip paths that clip each other

class ClipPaths {
 public:
  /// Areas are added to `clips`.
  ClipPaths(const ElementTree& tree, const StyleSheets& sheets, Notices& notices, std::vector<Clip>& clips)
      : tree_(tree), sheets_(sheets), notices_(notices), clips_(clips), open_(static_cast<std::size_t>(tree.size())) {}

  /// The number of the area that the value of `clip-path` of an element means, with the element's context, its own
  /// transform included; no_clip where it clips nothing. `box` gives the element's box in its own coordinates.
  /// Throws      InputError where a clip path clips itself, or has bad attributes
  int of(std::string_view value, const Element& element, const Context& context, const std::function<Box()>& box);

  /// Is it certain that a box lies in the area?
  bool contains(int clip, const Box& box) const;

  static constexpr int no_clip = -1;

 private:
  /// How an area is told from others: the clip path's element, and the map from its coordinates.
  using Key = std::pair<int, std::array<double, 6>>;

  int make(int target, const Element& element, const Affine& map);
  void add_part(int child, const Context& context, const Affine& map, bool is_used, Clip& clip);
  Context context_of(int index);

  const ElementTree& tree_;
  const StyleSheets& sheets_;
  Notices& notices_;
  std::vector<Clip>& clips_;
  std::vector<bool> open_;  ///< the clip paths that are being made
  int depth_ = 0;
  long visits_ = 0;
  std::size_t steps_ = 0;
  std::map<Key, int> known_;
};

}  // namespace pliant::svg
