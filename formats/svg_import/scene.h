// formats/svg_import/scene.h: what a drawing fills: groups, transforms, viewports, `use` and styles resolved.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "formats/svg_import/areas/outline.h"
#include "formats/svg_import/areas/stroke.h"
#include "formats/svg_import/element_tree.h"
#include "formats/svg_import/svg_reader.h"

namespace pliant::svg {

inline constexpr std::size_t max_steps = 2'000'000;  ///< steps of all outlines together, each copy by `use` counted
inline constexpr long max_visits = 1'000'000;        ///< visits of elements, those in copies counted each time
inline constexpr std::size_t max_dash_lengths = 2'000'000;  ///< numbers in the dash lists of all strokes together
inline constexpr double max_coordinate = 1e60;              ///< largest coordinate: its fourth power is finite

/// One filled shape.
struct Shape {
  std::string name;  ///< id of the element or of the `use` that shows it, else its kind and number; no two alike
  long line = 0;     ///< of its element in the document
  bool even_odd = false;
  Outline outline;           ///< in the units of the result, y upwards
  std::vector<int> clips{};  ///< it is seen only inside of all of these clip paths
  /// The shape is what a stroke paints along `outline`, which is in coordinates of its own; `map` leads to the result.
  std::optional<StrokeStyle> stroke{};
  Affine map{};
};

/// A stroke as the curve that it follows.
struct StrokeLine {
  std::string name;
  Outline outline;           ///< in the units of the result, y upwards
  int above = 0;             ///< how many of the shapes are painted before it
  std::vector<int> clips{};  ///< as in Shape
};

/// A clip path where an element refers to it: the union of its parts, as far as it lies in all of `clips`.
struct Clip {
  std::vector<Shape> parts;
  std::vector<int> clips{};  ///< clip paths that come before this one, as those of the parts do
};

/// What is read of a drawing beside its fills.
struct SceneOptions {
  LengthUnit unit = LengthUnit::user;
  Strokes strokes = Strokes::left_out;
  bool clips = false;  ///< without it clip paths are only named
};

struct Scene {
  std::vector<Shape> shapes;  ///< in the order in which they are painted
  std::vector<StrokeLine> lines;
  std::vector<Clip> clips;
  long unfilled = 0, hidden = 0;  ///< shapes that were left out
  long strokes = 0;               ///< shapes with a stroke
  std::vector<std::string> warnings;
};

/// Walks the document in the order in which it is painted, and collects what it fills, and strokes.
/// Throws      InputError with the element's line and column: bad attributes, `use` that contains itself, a clip path
///             that clips itself, limits
Scene read_scene(const ElementTree& tree, const SceneOptions& options = {});

}  // namespace pliant::svg
