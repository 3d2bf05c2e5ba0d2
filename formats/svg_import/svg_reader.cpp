// formats/svg_import/svg_reader.cpp: from the filled shapes to faces, curves and vertices.
#include "formats/svg_import/svg_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "formats/svg_import/areas/loops.h"
#include "formats/svg_import/areas/nesting.h"
#include "formats/svg_import/areas/painted_strokes.h"
#include "formats/svg_import/element_tree.h"
#include "formats/svg_import/scene.h"
#include "pliant/boundary/arrangement.h"
#include "pliant/boundary/boundary_spans.h"
#include "pliant/boundary/check_boundary.h"

namespace pliant {
namespace {

using namespace svg;

constexpr double most_snap = 1e-5;  // curves farther apart than this part of the drawing's size never run together

constexpr const char* not_apart =
    "shapes cross, touch or lie over each other; import-svg --planar makes disjoint faces of what is seen of them";

/// The diagonal of the box of all control points and of points on the arcs.
double size_of(const std::vector<Shape>& shapes) {
  Box box;
  for (const Shape& shape : shapes) extend(box, box_of(shape));
  return box.size();
}

/// Arranges the faces. Curves are exact only to the import's tolerance, so curves closer than that run together. Where
/// so coarse a snap leaves no arrangement, finer ones are tried; the faults are those of the first try.
Arrangement arrange_drawing(const PaintedLayers& layers, double tolerance) {
  constexpr double finer = 1.0 / 16;
  ArrangeOptions options;
  const double finest = options.tolerance;
  options.tolerance = options.coarsest = std::clamp(tolerance, finest, most_snap);
  options.sliver = std::max(options.sliver, 4 * options.tolerance);
  options.tip = std::max(options.tip, options.tolerance / 4);
  Arrangement first;
  for (bool is_first = true;; is_first = false) {
    Arrangement found = arrange_layers(layers, options);
    if (found.faults.empty()) return found;
    if (is_first) first = std::move(found);
    if (options.tolerance <= finest) return first;
    options.tolerance = options.coarsest = std::max(finer * options.tolerance, finest);
  }
}

/// All loops of all shapes, and the curves that they become.
class Drawing {
 public:
  /// `tolerance` is a length.
  Drawing(const Scene& scene, const SvgReadOptions& options, double tolerance, SvgImport& import)
      : scene_(scene), shapes_(scene.shapes), import_(import), tolerance_(options.tolerance) {
    loop_options_.degree = options.degree;
    loop_options_.size = import.size;
    loop_options_.tolerance = tolerance;
    all_.reserve(shapes_.size());
    for (const Shape& shape : shapes_) all_.push_back(make_loops(shape.outline, loop_options_, counts_));
    for (std::size_t s = 0; s < shapes_.size(); ++s)
      for (const Loop& loop : all_[s]) loops_.push_back({static_cast<int>(s), &loop});
    import.no_area = counts_.no_area;
    import.pieces = counts_.pieces;
    import.fitted = counts_.fitted;
    import.smooth = counts_.smooth;
    import.corners = counts_.corners;
    import.error = counts_.fit_error + counts_.join_error;
  }

  bool empty() const { return loops_.empty(); }
  const LoopCounts& counts() const { return counts_; }

  /// The boundary of shapes that are apart: the faces that their loops separate.
  /// Throws      InputError for shapes that meet
  void make_boundary() {
    require_apart();
    std::vector<bool> even_odd;
    for (const Shape& shape : shapes_) even_odd.push_back(shape.even_odd);
    const Nesting nesting = nest(loops_, even_odd);
    if (!nesting.overlaps.empty()) refuse_overlaps(nesting.overlaps);
    std::vector<int> faces(shapes_.size(), outside);
    for (std::size_t s = 0; s < shapes_.size(); ++s) {
      const auto bounds = [&](const Sides& sides) {
        return sides.inner != sides.outer && (sides.inner == static_cast<int>(s) || sides.outer == static_cast<int>(s));
      };
      bool is_bounded = false;
      for (; next_loop_ < loops_.size() && loops_[next_loop_].shape == static_cast<int>(s); ++next_loop_)
        is_bounded = is_bounded || bounds(nesting.sides[next_loop_]);
      if (!is_bounded) continue;
      faces[s] = static_cast<int>(import_.boundary.faces.size());
      import_.boundary.faces.push_back({shapes_[s].name, {}});
    }
    for (std::size_t l = 0; l < loops_.size(); ++l) {
      const Sides& sides = nesting.sides[l];
      if (sides.inner == sides.outer) {
        ++import_.no_border;
        continue;
      }
      const auto face = [&](int shape) { return shape == nothing ? outside : faces[static_cast<std::size_t>(shape)]; };
      const int inner = face(sides.inner), outer = face(sides.outer);
      const bool ccw = sides.is_counterclockwise;
      add_curves(l, ccw ? inner : outer, ccw ? outer : inner, import_.boundary);
    }
  }

  /// The boundary of shapes that may meet: a face is what is seen of its shape, and faces are disjoint.
  /// Throws      InputError where the curves cannot be arranged
  void arrange_boundary() {
    PaintedLayers layers;
    std::vector<int> faces_before{0};  // of each shape; one more at the end
    for (std::size_t s = 0; s < shapes_.size(); ++s) {
      FilledFace face = filled(shapes_[s], all_[s]);
      if (!face.curves.empty()) layers.faces.push_back(std::move(face));
      faces_before.push_back(static_cast<int>(layers.faces.size()));
    }
    for (const Clip& clip : scene_.clips) {
      ClipArea area{{}, clip.clips};
      for (const Shape& part : clip.parts)
        area.parts.push_back(filled(part, make_loops(part.outline, loop_options_, clip_counts_)));
      layers.clips.push_back(std::move(area));
    }
    for (const StrokeLine& line : scene_.lines)
      for (BSpline& curve : make_lines(line.outline, loop_options_, clip_counts_))
        layers.lines.push_back(
            {line.name, std::move(curve), faces_before[static_cast<std::size_t>(line.above)], line.clips});
    import_.error = std::max(import_.error, clip_counts_.fit_error + clip_counts_.join_error);
    import_.lines = static_cast<long>(layers.lines.size());
    Arrangement arrangement = arrange_drawing(layers, tolerance_);
    if (!arrangement.faults.empty()) {
      std::string text = "the shapes cannot be arranged";
      for (const Fault& fault : arrangement.faults) text += "\n" + fault.text;
      throw InputError("", text);
    }
    import_.boundary = std::move(arrangement.boundary);
    import_.intersections = arrangement.intersections;
    import_.snapped = arrangement.tolerance * import_.size;
    import_.slivers = arrangement.slivers;
    import_.sliver_area = arrangement.sliver_area;
    if (import_.slivers > 0)
      import_.warnings.push_back(std::to_string(import_.slivers) + (import_.slivers == 1 ? " sliver" : " slivers") +
                                 " between shapes that nearly meet closed, of an area of " +
                                 describe_number(import_.sliver_area) + " at most");
    import_.covered = static_cast<long>(layers.faces.size() - import_.boundary.faces.size());
    import_.bare_lines = arrangement.bare_lines;
    if (import_.bare_lines > 0)
      import_.warnings.emplace_back("strokes run outside of all faces, and are left out there");
    if (import_.boundary.faces.empty())
      throw InputError(
          "", "nothing is seen: clip paths cut off all that is filled, or it is thinner than four times the tolerance");
  }

 private:
  static FilledFace filled(const Shape& shape, const std::vector<Loop>& loops) {
    FilledFace face;
    face.name = shape.name;
    face.rule = shape.even_odd ? FillRule::evenodd : FillRule::nonzero;
    face.clips = shape.clips;
    for (const Loop& loop : loops) face.curves.insert(face.curves.end(), loop.curves.begin(), loop.curves.end());
    return face;
  }

  const Shape& shape_of(std::size_t loop) const { return shapes_[static_cast<std::size_t>(loops_[loop].shape)]; }

  void add_curves(std::size_t l, int left, int right, BoundaryComplex& boundary) const {
    const Loop& loop = *loops_[l].loop;
    const int first = static_cast<int>(boundary.vertices.size());
    const int count = static_cast<int>(loop.curves.size());
    for (int k = 0; k < count; ++k) {
      Curve curve;
      curve.name = shape_of(l).name;
      curve.spline = loop.curves[static_cast<std::size_t>(k)];
      curve.left = left;
      curve.right = right;
      if (!curve.spline.closed()) {
        curve.start = first + k;
        curve.end = first + (k + 1) % count;
        if (loop.cusps[static_cast<std::size_t>(k)]) boundary.cusps.push_back(curve.start);
        boundary.vertices.push_back(curve.spline.points().front());
      }
      boundary.curves.push_back(std::move(curve));
    }
  }

  /// Checks the loops as a boundary of one face, which lies inside of every loop: they must not cross or touch.
  /// Throws      InputError
  void require_apart() const {
    BoundaryComplex alone;
    for (std::size_t l = 0; l < loops_.size(); ++l) {
      double area = 0;
      for (const BSpline& curve : loops_[l].loop->curves) area += curve.area();
      add_curves(l, area > 0 ? 0 : outside, area > 0 ? outside : 0, alone);
    }
    for (std::size_t l = 0, c = 0; l < loops_.size(); ++l)  // a fault names its curve, and so the shape's line
      for (std::size_t k = 0; k < loops_[l].loop->curves.size(); ++k)
        alone.curves[c++].name += ", line " + std::to_string(shape_of(l).line);
    alone.faces.push_back({"all", {}});
    std::vector<Fault> faults = check_boundary(alone);
    if (faults.empty()) faults = check_boundary_geometry(alone);
    if (faults.empty()) return;
    std::string text = not_apart;
    for (const Fault& fault : faults)  // other faults (vertices at one place, areas) only follow from these
      if (fault.place.rfind("/curves", 0) == 0) text += "\n" + fault.text;
    throw InputError("", text);
  }

  [[noreturn]] void refuse_overlaps(const std::vector<Overlap>& overlaps) const {
    std::string text = not_apart;
    for (const Overlap& overlap : overlaps) {
      const Shape& over = shapes_[static_cast<std::size_t>(overlap.over)];
      const Shape& under = shapes_[static_cast<std::size_t>(overlap.under)];
      text += "\n'" + over.name + "' (line " + std::to_string(over.line) + ") lies over '" + under.name + "' (line " +
              std::to_string(under.line) + "), at " + describe_point(overlap.place);
    }
    throw InputError("", text);
  }

  const Scene& scene_;
  const std::vector<Shape>& shapes_;
  SvgImport& import_;
  double tolerance_;  // as a part of the drawing's size
  LoopOptions loop_options_;
  LoopCounts counts_, clip_counts_;
  std::vector<std::vector<Loop>> all_;
  std::vector<ShapeLoop> loops_;
  std::size_t next_loop_ = 0;
};

LoopCounts count_pieces(const std::vector<Shape>& shapes, int degree, double tolerance, double size) {
  LoopOptions options;
  options.degree = degree;
  options.size = size;
  options.tolerance = tolerance * size;
  LoopCounts counts;
  for (const Shape& shape : shapes) make_loops(shape.outline, options, counts);
  return counts;
}

/// "60 cubic curves and arcs"
std::string describe_curves(const LoopCounts& counts) {
  const std::string number = std::to_string(counts.curves);
  if (counts.arcs == 0) return number + (counts.curves == 1 ? " cubic curve" : " cubic curves");
  if (counts.arcs == counts.curves) return number + (counts.curves == 1 ? " arc" : " arcs");
  return number + " cubic curves and arcs";
}

/// Notes what the tolerance costs where it multiplies the curves: many small elements are often the price of one that
/// nobody needs.
void note_cost(const std::vector<Shape>& shapes, const SvgReadOptions& options, const LoopCounts& counts,
               SvgImport& import) {
  constexpr long worth_a_word = 3;  // spans for each curve
  constexpr double looser = 100;
  if (counts.fitted < worth_a_word * counts.curves || counts.curves == 0) return;
  const double tolerance = std::min(1.0, looser * options.tolerance);
  std::array<char, 32> now{}, then{};
  std::snprintf(now.data(), now.size(), "%.3g", options.tolerance);
  std::snprintf(then.data(), then.size(), "%.3g", tolerance);
  std::string text = std::string("tolerance ") + now.data() + " made " + std::to_string(counts.fitted) + " spans of " +
                     describe_curves(counts) + "; ";
  if (options.degree == 2) {
    const LoopCounts cubic = count_pieces(shapes, 3, options.tolerance, import.size);
    text += cubic.fitted == 0 ? "--degree 3 keeps them exactly"
                              : "--degree 3 takes " + std::to_string(cubic.pieces) + " instead of " +
                                    std::to_string(counts.pieces) + " spans in all";
    text += ", ";
  }
  const LoopCounts loose = count_pieces(shapes, options.degree, tolerance, import.size);
  text += std::string("--tolerance ") + then.data() + (options.degree == 2 ? " " : " takes ") +
          std::to_string(loose.pieces) + " spans in all";
  import.costs.push_back(std::move(text));
}

/// Why a drawing of which nothing is filled is refused.
std::string describe_nothing(const Scene& scene, Strokes strokes) {
  // With --strokes area, strokes are shapes too.
  const std::size_t shapes =
      scene.shapes.size() -
      (strokes == Strokes::area ? std::min(scene.shapes.size(), static_cast<std::size_t>(scene.strokes)) : 0);
  std::string text = "nothing is filled: " + std::to_string(shapes) + " filled shape" + (shapes == 1 ? "" : "s") +
                     " without an interior, " + std::to_string(scene.unfilled) + " without a fill, " +
                     std::to_string(scene.hidden) + " hidden";
  if (scene.strokes == 0) return text;
  text += "; " + std::to_string(scene.strokes) + (scene.strokes == 1 ? " has a stroke" : " have strokes");
  if (strokes == Strokes::area)
    text += ", but no area is painted";
  else
    text += strokes == Strokes::curves ? ", but curves of strokes only cut faces, and there are none"
                                       : ", which --strokes area reads as the area that it paints";
  return text;
}

}  // namespace

SvgImport read_svg(std::string_view bytes, const SvgReadOptions& options) {
  SvgImport import;
  const bool is_planar = options.planar || options.strokes != Strokes::left_out;
  Scene scene = read_scene(ElementTree(bytes), {options.unit, options.strokes, is_planar});
  import.warnings = scene.warnings;
  import.shapes = static_cast<long>(scene.shapes.size());
  import.unfilled = scene.unfilled;
  import.hidden = scene.hidden;
  import.size = size_of(scene.shapes);
  constexpr double least_size = 1e-60;  // squares of small parts of it do not underflow to 0
  if (import.size > 0 && import.size < least_size) throw InputError("", "the drawing is smaller than 1e-60");
  const double tolerance = paint_strokes(scene, options.tolerance * import.size);
  Drawing drawing(scene, options, tolerance, import);
  if (tolerance < options.tolerance * import.size) import.error += options.tolerance * import.size - tolerance;
  if (drawing.empty()) throw InputError("", describe_nothing(scene, options.strokes));
  note_cost(scene.shapes, options, drawing.counts(), import);
  if (is_planar)
    drawing.arrange_boundary();
  else
    drawing.make_boundary();
  return import;
}

}  // namespace pliant
