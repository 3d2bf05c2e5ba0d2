// formats/svg_import/scene.cpp: what a drawing fills: groups, transforms, viewports, `use` and styles resolved.
#include "formats/svg_import/scene.h"

#include <unordered_map>
#include <unordered_set>

#include "formats/svg_import/areas/painted_strokes.h"
#include "formats/svg_import/clip_paths.h"
#include "formats/svg_import/context.h"
#include "formats/svg_import/paint.h"
#include "formats/svg_import/painting.h"
#include "formats/svg_import/shape_name.h"
#include "formats/svg_import/viewport.h"
#include "pliant/boundary/fault.h"

namespace pliant::svg {
namespace {

constexpr int max_nesting = 400;  // depth of elements as they are painted, through `use`

/// Elements that paint nothing themselves: they hold what others refer to, or what is never seen.
const std::unordered_set<std::string_view> silent{
    "defs",          "symbol",  "title",     "desc",           "metadata",       "style",       "clipPath", "mask",
    "marker",        "pattern", "filter",    "linearGradient", "radialGradient", "solidColor",  "view",     "cursor",
    "color-profile", "font",    "font-face", "script",         "hatch",          "meshgradient"};

class Walker {
 public:
  Walker(const ElementTree& tree, const SceneOptions& options)
      : tree_(tree),
        options_(options),
        sheets_(tree),
        names_(tree),
        clip_paths_(tree, sheets_, notices_, scene_.clips),
        in_use_(static_cast<std::size_t>(tree.size())) {}

  Scene walk() {
    Context context;
    context.viewport = root_viewport(tree_[0], Viewport::medium);
    const double px = length_of_px(options_.unit);
    context.map = {px, 0, 0, -px, 0, 0};  // y of the result points upwards
    visit(0, context);
    if (tree_.names_sheets()) notices_.add("style sheets of other files are not read", 1);
    for (const auto& [what, times] : sheets_.unread()) notices_.add(what + " are not read", times);
    scene_.warnings = notices_.sentences();
    return std::move(scene_);
  }

 private:
  void visit(int index, Context context) {
    const Element& element = tree_[index];
    if (element.name.empty()) return;
    if (++visits_ > max_visits)
      refuse(element, "the drawing shows more than " + std::to_string(max_visits) + " elements, copies by use counted");
    if (++context.depth > max_nesting)
      refuse(element, "elements are nested deeper than " + std::to_string(max_nesting) + ", copies by use counted");
    if (silent.count(element.name) != 0) return note_silent(element);
    const Declarations declared = sheets_.declarations_of(element);
    if (own(declared, Property::display) == "none") return count_hidden(index);
    if (!meets_conditions(element)) {
      notices_.add("what is for other languages than English, or for extensions of SVG, is left out", element);
      return count_hidden(index);
    }
    inherit(context, element, declared, notices_);
    // Lengths in units of the root's font are known only now that its font size is.
    if (index == 0 && context.depth == 1) context.viewport = root_viewport(element, context.viewport.font_size);
    context.map = context.map * transform_of(element, declared, context.viewport, notices_);
    const std::size_t first = scene_.shapes.size(), first_line = scene_.lines.size();
    show(index, declared, context);
    clip(element, declared, context, first, first_line);
  }

  void show(int index, const Declarations& declared, const Context& context) {
    const Element& element = tree_[index];
    if (is_shape(element.name)) {
      for (const int child : element.children) note_animation(tree_[child]);
      if (!has_geometry(declared)) return add_shape(element, declared, context);
      return add_shape(with_geometry_of_style(element, declared, notices_), declared, context);
    }
    if (element.name == "svg") return visit_svg(element, declared, context, nullptr, index == 0);
    if (element.name == "use") return visit_use(index, declared, context);
    if (element.name == "switch") return visit_switch(element, declared, context);
    if (element.name == "g" || element.name == "a") {
      note_effects(element, declared);
      return visit_children(element, context);
    }
    if (element.name == "text" || element.name == "image" || element.name == "foreignObject")
      return notices_.add(element.name + " is not read", element);
    if (note_animation(element)) return;
    notices_.add("elements " + element.name + " are not read", element);
  }

  /// Clips what an element has shown, which are the shapes and lines from these numbers on, by its clip path.
  void clip(const Element& element, const Declarations& declared, const Context& context, std::size_t first,
            std::size_t first_line) {
    if (!options_.clips || (first == scene_.shapes.size() && first_line == scene_.lines.size())) return;
    const std::string_view value = own(declared, Property::clip_path);
    if (value.empty() || value == "none") return;
    const auto box = [&] {
      Box all;
      const Affine back = context.map.determinant() == 0 ? Affine{} : context.map.inverse();
      for (std::size_t s = first; s < scene_.shapes.size(); ++s)
        extend(all, tight_box_of(scene_.shapes[s].outline, back * scene_.shapes[s].map));
      for (std::size_t l = first_line; l < scene_.lines.size(); ++l)
        extend(all, tight_box_of(scene_.lines[l].outline, back));
      return all;
    };
    const int number = clip_paths_.of(value, element, context, box);
    if (number < 0) return;
    for (std::size_t s = first; s < scene_.shapes.size(); ++s)
      if (scene_.shapes[s].stroke || !clip_paths_.contains(number, box_of(scene_.shapes[s])))
        scene_.shapes[s].clips.push_back(number);
    for (std::size_t l = first_line; l < scene_.lines.size(); ++l)
      if (!clip_paths_.contains(number, box_of(scene_.lines[l].outline))) scene_.lines[l].clips.push_back(number);
  }

  bool note_animation(const Element& element) {
    const bool is_animation = element.name.rfind("animate", 0) == 0 || element.name == "set";
    if (is_animation) notices_.add("animation is not run", element);
    return is_animation;
  }

  void visit_children(const Element& element, const Context& context) {
    for (const int child : element.children) visit(child, context);
  }

  void visit_switch(const Element& element, const Declarations& declared, const Context& context) {
    note_effects(element, declared);
    for (const int child : element.children) {
      const Element& candidate = tree_[child];
      if (candidate.name.empty() || candidate.name == "foreignObject" || !meets_conditions(candidate)) continue;
      return visit(child, context);
    }
  }

  /// Visits the root element. Without --unit its user units are those of the result.
  void visit_root(const Element& root, const Declarations& declared, Context context) {
    if (options_.unit != LengthUnit::user) context.map = context.map * page_map(root, context.viewport);
    const std::size_t first = scene_.shapes.size();
    visit_children(root, context);
    const ViewBox page = view_box_of(root).value_or(ViewBox{0, 0, context.viewport.width, context.viewport.height});
    if (page.width == 0 || page.height == 0)
      return notices_.add("a page without width or height would show nothing, but is read", root);
    note_cut(root, declared, first, context.map * Affine{1, 0, 0, 1, page.x, page.y}, page.width, page.height,
             "what juts out of the page is not cut off");
  }

  /// Adds the notice `what` if a shape from number `first` on juts out of the viewport (0, 0, width, height), where it
  /// would not be seen.
  void note_cut(const Element& element, const Declarations& declared, std::size_t first, const Affine& map,
                double width, double height, const char* what) {
    const std::string_view overflow = own(declared, Property::overflow);
    if (overflow == "visible" || overflow == "auto" || map.determinant() == 0) return;
    if (!std::isfinite(width) || !std::isfinite(height)) return;
    const Affine back = map.inverse();
    const double margin = 1e-6 * std::hypot(width, height);
    const auto is_out = [&](double x, double y) {
      return x < -margin || y < -margin || x > width + margin || y > height + margin;
    };
    for (std::size_t s = first; s < scene_.shapes.size(); ++s) {
      const Box box = box_of(scene_.shapes[s], back);
      if (is_out(box.low.x, box.low.y) || is_out(box.high.x, box.high.y)) return notices_.add(what, element);
    }
  }

  /// Visits a nested svg element. `size` is the `use` that shows it, whose width and height go before its own, or null.
  void visit_svg(const Element& element, const Declarations& declared, Context context, const Element* size,
                 bool is_root) {
    note_effects(element, declared);
    if (is_root && size == nullptr) return visit_root(element, declared, context);
    const auto length = [&](const char* attribute, Along along, double whole) {
      const Element& from = size != nullptr && size->find(attribute) != nullptr ? *size : element;
      const std::string* value = from.find(attribute);
      if (value == nullptr || *value == "auto") return whole;
      return length_of(from, attribute, along, context.viewport);
    };
    if (element.name == "svg") {
      const double x = length_of(element, "x", Along::x, context.viewport);
      const double y = length_of(element, "y", Along::y, context.viewport);
      context.map = context.map * Affine{1, 0, 0, 1, x, y};
    }
    const double width = length("width", Along::x, context.viewport.width);
    const double height = length("height", Along::y, context.viewport.height);
    if (width <= 0 || height <= 0) return;
    const std::size_t first = scene_.shapes.size();
    const Affine place = context.map;
    if (const auto box = view_box_of(element)) {
      if (box->width == 0 || box->height == 0) return;
      if (!std::isfinite(width) || !std::isfinite(height))
        refuse(element, "its width and height are parts of the drawing's, which has neither a viewBox nor a size");
      context.map = context.map * fit_view_box(element, *box, width, height);
      context.viewport.width = box->width;
      context.viewport.height = box->height;
    } else {
      context.viewport.width = width;
      context.viewport.height = height;
    }
    visit_children(element, context);
    note_cut(element, declared, first, place, width, height, "what juts out of a nested viewport is not cut off");
  }

  void visit_use(int index, const Declarations& declared, Context context) {
    const Element element = with_geometry_of_style(tree_[index], declared, notices_);
    note_effects(element, declared);
    const std::string* href = element.find("href");
    if (href == nullptr) href = element.find("xlink:href");
    if (href == nullptr) return notices_.add("use without href shows nothing", element);
    if (href->empty() || href->front() != '#') return notices_.add("other files are not read (use)", element);
    const int target = tree_.find(href->substr(1));
    if (target == no_element) return notices_.add("use refers to an element that does not exist", element);
    if (in_use_[static_cast<std::size_t>(target)]) refuse(element, "it shows '" + *href + "', which contains it");
    const double x = length_of(element, "x", Along::x, context.viewport);
    const double y = length_of(element, "y", Along::y, context.viewport);
    if (x != 0 || y != 0) context.map = context.map * Affine{1, 0, 0, 1, x, y};
    context.shown_by = &tree_[index];
    // The copy's context-fill refers to the fill of this `use`, which may itself refer to the `use` around it.
    if (classify_paint(context.fill) != Paint::of_fill && classify_paint(context.fill) != Paint::of_stroke)
      context.context_fill = context.fill;
    if (classify_paint(context.stroke) != Paint::of_fill && classify_paint(context.stroke) != Paint::of_stroke)
      context.context_stroke = context.stroke;
    in_use_[static_cast<std::size_t>(target)] = true;
    const Element& shown = tree_[target];
    if (shown.name == "symbol" || shown.name == "svg")
      show_viewport(shown, element, context);
    else
      visit(target, context);
    in_use_[static_cast<std::size_t>(target)] = false;
  }

  /// Visits a symbol or an svg element as a `use` shows it: with the width and height of the `use`.
  void show_viewport(const Element& shown, const Element& use, Context context) {
    const Declarations declared = sheets_.declarations_of(shown);
    if (++visits_ > max_visits || ++context.depth > max_nesting)
      refuse(use, "use shows too many elements, or too deeply nested ones");
    if (own(declared, Property::display) == "none") return;
    inherit(context, shown, declared, notices_);
    context.map = context.map * transform_of(shown, declared, context.viewport, notices_);
    if (shown.name == "symbol")
      for (const char* attribute : {"refX", "refY", "x", "y"})
        if (shown.find(attribute) != nullptr)
          notices_.add(std::string(attribute) + " of a symbol moves nothing", shown);
    const std::size_t first = scene_.shapes.size(), first_line = scene_.lines.size();
    visit_svg(shown, declared, context, &use, false);
    clip(shown, declared, context, first, first_line);
  }

  void note_silent(const Element& element) {
    if (element.name == "script") notices_.add("scripts are not run", element);
  }

  /// Counts the shapes below an element that is not displayed, except those that a `use` would show.
  void count_hidden(int index) {
    const Element& element = tree_[index];
    if (++visits_ > max_visits) refuse(element, "the drawing has too many elements");
    if (is_shape(element.name)) ++scene_.hidden;
    for (const int child : element.children) count_hidden(child);
  }

  void note_effects(const Element& element, const Declarations& declared) {
    const auto is_set = [&](Property property) {
      const std::string_view value = own(declared, property);
      return !value.empty() && value != "none" && value != "inherit";
    };
    if (is_set(Property::clip_path) && !options_.clips)
      notices_.add("clip paths do not cut anything off without --planar", element);
    if (is_set(Property::mask)) notices_.add("masks do not hide anything", element);
    if (is_set(Property::filter)) notices_.add("filters change nothing", element);
  }

  /// Adds notices of strokes and markers, as far as they are not read.
  void note_lines(const Element& element, const Context& context) {
    if (options_.strokes == Strokes::left_out) {
      const Paint stroke = classify_paint(context.stroke);
      if (stroke != Paint::invisible && stroke != Paint::not_understood) notices_.add("strokes are not read", element);
    }
    const bool can_have_markers =
        element.name == "path" || element.name.rfind("poly", 0) == 0 || element.name == "line";
    if (can_have_markers && context.has_markers()) notices_.add("markers are not drawn", element);
  }

  /// Does the element paint a stroke of some width?
  bool has_stroke(const Element& element, const Context& context) {
    const Paint kind = classify_paint(context.stroke);
    return kind != Paint::invisible && kind != Paint::not_understood && fraction_of(context.stroke_opacity, 1) > 0 &&
           has_stroke_width(element, context) &&
           (options_.strokes == Strokes::left_out || paints(context.stroke, element, context, tree_, notices_));
  }

  void add_shape(const Element& element, const Declarations& declared, const Context& context) {
    const long number = ++numbers_[element.name];
    if (context.visibility == "hidden" || context.visibility == "collapse") {
      ++scene_.hidden;
      return;
    }
    if (!context.transparent) note_lines(element, context);
    const bool is_stroked = !context.transparent && has_stroke(element, context);
    scene_.strokes += is_stroked ? 1 : 0;
    const bool is_line = is_stroked && options_.strokes == Strokes::curves,
               is_area = is_stroked && options_.strokes == Strokes::area;
    const bool is_filled = element.name != "line" && !context.transparent && fraction_of(context.fill_opacity, 1) > 0 &&
                           paints(context.fill, element, context, tree_, notices_);
    if (!is_filled) ++scene_.unfilled;
    if (!is_filled && !is_line && !is_area) return;
    Outline outline = outline_of(element, context.viewport);
    if (outline.empty()) return;
    note_effects(element, declared);
    steps_ += outline.steps.size();
    if (steps_ > max_steps)
      refuse(element, "the outlines have more than " + std::to_string(max_steps) + " segments, copies by use counted");
    const Outline own_outline = is_area ? outline : Outline{};
    outline.transform(context.map);
    check_coordinates(element, outline);
    const std::string name = names_.name(element, context.shown_by, number);
    // Where the stroke is painted first, the fill hides what of it lies inside.
    const bool is_under = context.paint_order.find("stroke") < context.paint_order.find("fill");
    const int before = static_cast<int>(scene_.shapes.size());
    if (is_line) scene_.lines.push_back({name, outline, before + (is_filled && !is_under ? 1 : 0)});
    const auto add_stroke = [&] {
      Shape stroke{is_filled ? names_.unique(name + " stroke") : name, element.line, false, own_outline};
      stroke.stroke = stroke_style(element, declared, context, notices_);
      dash_lengths_ += stroke.stroke->dashes.size();
      if (dash_lengths_ > max_dash_lengths)
        refuse(element, "the values of stroke-dasharray have more than " + std::to_string(max_dash_lengths) +
                            " lengths, those of each stroke counted");
      stroke.map = context.map;
      scene_.shapes.push_back(std::move(stroke));
    };
    if (is_area && is_under) add_stroke();
    if (is_filled) scene_.shapes.push_back({name, element.line, context.fill_rule == "evenodd", std::move(outline)});
    if (is_area && !is_under) add_stroke();
  }

  const ElementTree& tree_;
  SceneOptions options_;
  StyleSheets sheets_;
  ShapeNames names_;
  Scene scene_;
  Notices notices_;
  ClipPaths clip_paths_;
  std::vector<bool> in_use_;
  std::unordered_map<std::string, long> numbers_;
  std::size_t steps_ = 0, dash_lengths_ = 0;
  long visits_ = 0;
};

}  // namespace

Scene read_scene(const ElementTree& tree, const SceneOptions& options) { return Walker(tree, options).walk(); }

}  // namespace pliant::svg
