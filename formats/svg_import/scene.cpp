#include "formats/svg_import/scene.h"  // formats/svg_import/scene.cpp

#include <cstdlib>
#include <unordered_map>
#include <unordered_set>

#include "formats/svg_import/notices.h"
#include "formats/svg_import/style.h"
#include "formats/svg_import/viewport.h"
#include "pliant/boundary/fault.h"

namespace pliant::svg {
namespace {

constexpr int max_nesting = 400;  // of elements as painted, through `use`

/// Elements that hold what others refer to, or what is not to be seen at all.
const std::unordered_set<std::string_view> silent{
    "defs",          "symbol",  "title",     "desc",           "metadata",       "style",       "clipPath", "mask",
    "marker",        "pattern", "filter",    "linearGradient", "radialGradient", "solidColor",  "view",     "cursor",
    "color-profile", "font",    "font-face", "script",         "hatch",          "meshgradient"};

/// What is inherited, and where we are.
struct State {
  Affine map;
  Viewport viewport;
  std::string_view fill = "black", fill_rule = "nonzero", fill_opacity = "1", stroke = "none", visibility = "visible";
  bool transparent = false;
  const std::string* shown_as = nullptr;  ///< id of the innermost `use`
  int depth = 0;
};

double opacity_of(std::string_view text) {
  const std::string number(text);
  char* end = nullptr;
  const double value = std::strtod(number.c_str(), &end);
  return end == number.c_str() ? 1 : value;
}

void inherit(std::string_view& value, std::string_view declared) {
  if (!declared.empty() && declared != "inherit") value = declared;
}

class Walker {
 public:
  explicit Walker(const ElementTree& tree)
      : tree_(tree), sheets_(tree), in_use_(static_cast<std::size_t>(tree.size())) {}

  Scene walk() {
    State state;
    state.viewport = root_viewport(tree_[0]);
    state.map = {1, 0, 0, -1, 0, 0};  // y upwards
    visit(0, state);
    for (const auto& [what, times] : sheets_.unread()) notices_.add(what + " are not read", times);
    scene_.warnings = notices_.sentences();
    return std::move(scene_);
  }

 private:
  static std::string_view own(const Declarations& declared, Property property) {
    return declared[static_cast<std::size_t>(property)];
  }

  void visit(int index, State state) {
    const Element& element = tree_[index];
    if (element.name.empty()) return;
    if (++visits_ > max_visits)
      refuse(element, "the drawing shows more than " + std::to_string(max_visits) + " elements, copies by use counted");
    if (++state.depth > max_nesting)
      refuse(element, "elements are nested deeper than " + std::to_string(max_nesting) + ", copies by use counted");
    if (silent.count(element.name) != 0) return note_silent(element);
    const Declarations declared = sheets_.declarations_of(element);
    if (own(declared, Property::display) == "none") return count_hidden(index);
    inherit(state.fill, own(declared, Property::fill));
    inherit(state.fill_rule, own(declared, Property::fill_rule));
    inherit(state.fill_opacity, own(declared, Property::fill_opacity));
    inherit(state.stroke, own(declared, Property::stroke));
    inherit(state.visibility, own(declared, Property::visibility));
    if (const auto opacity = own(declared, Property::opacity); !opacity.empty() && opacity_of(opacity) <= 0)
      state.transparent = true;
    transform(element, state);
    if (is_shape(element.name)) return add_shape(element, declared, state);
    if (element.name == "svg") return visit_svg(element, declared, state, nullptr, index == 0);
    if (element.name == "use") return visit_use(index, declared, state);
    if (element.name == "switch") return visit_switch(element, declared, state);
    if (element.name == "g" || element.name == "a") {
      note_effects(element, declared);
      return visit_children(element, state);
    }
    if (element.name == "text" || element.name == "image" || element.name == "foreignObject")
      return notices_.add(element.name + " is not read", element);
    if (element.name.rfind("animate", 0) == 0 || element.name == "set")
      return notices_.add("animation is not run", element);
    notices_.add("elements " + element.name + " are not read", element);
  }

  void visit_children(const Element& element, const State& state) {
    for (const int child : element.children) visit(child, state);
  }

  void visit_switch(const Element& element, const Declarations& declared, const State& state) {
    note_effects(element, declared);
    for (const int child : element.children) {
      const Element& candidate = tree_[child];
      const std::string* language = candidate.find("systemLanguage");
      if (candidate.name.empty() || candidate.name == "foreignObject") continue;
      if (candidate.find("requiredExtensions") != nullptr) continue;
      if (language != nullptr && language->rfind("en", 0) != 0) continue;
      return visit(child, state);
    }
  }

  /// `size` holds the width and height of the `use` that shows it, if any.
  void visit_svg(const Element& element, const Declarations& declared, State state, const Element* size, bool is_root) {
    note_effects(element, declared);
    if (is_root && size == nullptr) return visit_children(element, state);  // its user units are those of the result
    const auto length = [&](const char* attribute, Along along, double whole) {
      const Element& from = size != nullptr && size->find(attribute) != nullptr ? *size : element;
      const std::string* value = from.find(attribute);
      if (value == nullptr || *value == "auto") return whole;
      return length_of(from, attribute, along, state.viewport);
    };
    if (element.name == "svg") {
      const double x = length_of(element, "x", Along::x, state.viewport);
      const double y = length_of(element, "y", Along::y, state.viewport);
      state.map = state.map * Affine{1, 0, 0, 1, x, y};
    }
    const double width = length("width", Along::x, state.viewport.width);
    const double height = length("height", Along::y, state.viewport.height);
    if (width <= 0 || height <= 0) return;
    const std::string* overflow = element.find("overflow");
    if (overflow == nullptr || *overflow != "visible")
      notices_.add("a nested viewport does not cut off what it holds", element);
    if (const auto box = view_box_of(element)) {
      if (box->width == 0 || box->height == 0) return;
      if (!std::isfinite(width) || !std::isfinite(height))
        refuse(element, "its width and height are parts of the drawing's, which has neither a viewBox nor a size");
      state.map = state.map * fit_view_box(element, *box, width, height);
      state.viewport = {box->width, box->height};
    } else {
      state.viewport = {width, height};
    }
    visit_children(element, state);
  }

  void visit_use(int index, const Declarations& declared, State state) {
    const Element& element = tree_[index];
    note_effects(element, declared);
    const std::string* href = element.find("href");
    if (href == nullptr) href = element.find("xlink:href");
    if (href == nullptr) return notices_.add("use without href shows nothing", element);
    if (href->empty() || href->front() != '#') return notices_.add("other files are not read (use)", element);
    const int target = tree_.find(href->substr(1));
    if (target == no_element) return notices_.add("use refers to an element that does not exist", element);
    if (in_use_[static_cast<std::size_t>(target)]) refuse(element, "it shows '" + *href + "', which contains it");
    const double x = length_of(element, "x", Along::x, state.viewport);
    const double y = length_of(element, "y", Along::y, state.viewport);
    if (x != 0 || y != 0) state.map = state.map * Affine{1, 0, 0, 1, x, y};
    if (const std::string* id = element.find("id")) state.shown_as = id;
    in_use_[static_cast<std::size_t>(target)] = true;
    const Element& shown = tree_[target];
    if (shown.name == "symbol" || shown.name == "svg")
      show_viewport(shown, element, state);
    else
      visit(target, state);
    in_use_[static_cast<std::size_t>(target)] = false;
  }

  /// A symbol, or an svg element, as `use` shows it: with that one's width and height.
  void show_viewport(const Element& shown, const Element& use, State state) {
    const Declarations declared = sheets_.declarations_of(shown);
    if (++visits_ > max_visits || ++state.depth > max_nesting)
      refuse(use, "use shows too many elements, or too deeply nested ones");
    if (own(declared, Property::display) == "none") return;
    inherit(state.fill, own(declared, Property::fill));
    inherit(state.fill_rule, own(declared, Property::fill_rule));
    inherit(state.fill_opacity, own(declared, Property::fill_opacity));
    inherit(state.stroke, own(declared, Property::stroke));
    inherit(state.visibility, own(declared, Property::visibility));
    transform(shown, state);
    if (shown.name == "symbol" && !view_box_of(shown)) {
      note_effects(shown, declared);
      return visit_children(shown, state);
    }
    visit_svg(shown, declared, state, &use, false);
  }

  void transform(const Element& element, State& state) {
    const std::string* value = element.find("transform");
    if (value == nullptr) return;
    try {
      state.map = state.map * parse_transform(*value);
    } catch (const SyntaxError& e) {
      refuse(element, "transform", e);
    }
  }

  void note_silent(const Element& element) {
    if (element.name == "script") notices_.add("scripts are not run", element);
  }

  /// Shapes below an element that is not displayed; not through `use`.
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
    if (is_set(Property::clip_path)) notices_.add("clip paths do not cut anything off", element);
    if (is_set(Property::mask)) notices_.add("masks do not hide anything", element);
    if (is_set(Property::filter)) notices_.add("filters change nothing", element);
    if (is_set(Property::transform)) notices_.add("transforms in styles are not read", element);
  }

  /// Does the paint fill? Gradients and patterns do; a reference to nothing does not unless a colour stands behind it.
  bool paints(std::string_view paint, const Element& element) {
    if (paint == "none" || paint == "transparent") return false;
    if (paint.substr(0, 4) != "url(") return true;
    const std::size_t end = std::min(paint.find(')'), paint.size());
    std::string id(paint.substr(4, end - 4));
    std::erase_if(id, [](char c) { return c == '"' || c == '\'' || c == ' '; });
    const int target = id.empty() || id.front() != '#' ? no_element : tree_.find(id.substr(1));
    if (target == no_element) {
      std::string_view behind = paint.substr(std::min(end + 1, paint.size()));
      while (!behind.empty() && behind.front() == ' ') behind.remove_prefix(1);
      notices_.add("fill refers to a paint that does not exist", element);
      return !behind.empty() && behind != "none";
    }
    const std::string& kind = tree_[target].name;
    if (kind == "pattern" || kind == "hatch")
      notices_.add("a pattern is taken for a colour", element);
    else
      notices_.add("a gradient is taken for a colour", element);
    return true;
  }

  void add_shape(const Element& element, const Declarations& declared, const State& state) {
    const long number = ++numbers_[element.name];
    if (state.visibility == "hidden" || state.visibility == "collapse") {
      ++scene_.hidden;
      return;
    }
    if (state.stroke != "none" && state.stroke != "transparent") notices_.add("strokes are not read", element);
    if (element.name == "line" || state.transparent || opacity_of(state.fill_opacity) <= 0 ||
        !paints(state.fill, element)) {
      ++scene_.unfilled;
      return;
    }
    Shape shape;
    shape.outline = outline_of(element, state.viewport);
    if (shape.outline.empty()) return;
    note_effects(element, declared);
    steps_ += shape.outline.steps.size();
    if (steps_ > max_steps)
      refuse(element, "the outlines have more than " + std::to_string(max_steps) + " segments, copies by use counted");
    shape.outline.transform(state.map);
    check_coordinates(element, shape.outline);
    const std::string* id = element.find("id");
    if (id == nullptr || id->empty()) id = state.shown_as;
    shape.name = unique(id == nullptr || id->empty() ? element.name + " " + std::to_string(number) : *id);
    shape.line = element.line;
    shape.even_odd = state.fill_rule == "evenodd";
    scene_.shapes.push_back(std::move(shape));
  }

  static void check_coordinates(const Element& element, const Outline& outline) {
    for (const Point& p : outline.points)
      if (!(std::abs(p.x) <= max_coordinate && std::abs(p.y) <= max_coordinate))
        refuse(element, "a coordinate is beyond 1e60");
  }

  std::string unique(const std::string& name) {
    long& used = names_[name];
    if (used++ == 0) return name;
    for (;; ++used) {
      std::string other = name + " (" + std::to_string(used) + ")";
      if (names_.emplace(other, 1).second) return other;
    }
  }

  const ElementTree& tree_;
  StyleSheets sheets_;
  Scene scene_;
  Notices notices_;
  std::vector<bool> in_use_;
  std::unordered_map<std::string, long> numbers_, names_;
  std::size_t steps_ = 0;
  long visits_ = 0;
};

}  // namespace

Scene read_scene(const ElementTree& tree) { return Walker(tree).walk(); }

}  // namespace pliant::svg
