// formats/svg_import/clip_paths.cpp: clip paths, as areas where elements refer to them.
#include "formats/svg_import/clip_paths.h"

#include "formats/svg_import/paint.h"
#include "formats/svg_import/painting.h"
#include "formats/svg_import/viewport.h"

namespace pliant::svg {

int ClipPaths::of(std::string_view value, const Element& element, const Context& context,
                  const std::function<Box()>& box) {
  if (value.empty() || is_same_word(value, "none")) return no_clip;
  const std::string id = referenced_id(value);
  if (id.empty()) {
    notices_.add("a clip-path that is no url(#id) of this document cuts nothing off", element);
    return no_clip;
  }
  const int target = tree_.find(id);
  if (target == no_element || tree_[target].name != "clipPath") {
    notices_.add("clip-path refers to no clip path, and cuts nothing off", element);
    return no_clip;
  }
  Affine map = context.map;
  const std::string* units = tree_[target].find("clipPathUnits");
  if (units != nullptr && *units == "objectBoundingBox") {
    const Box around = box();
    if (!(around.low.x <= around.high.x)) return no_clip;
    map = map * Affine{around.high.x - around.low.x, 0, 0, around.high.y - around.low.y, around.low.x, around.low.y};
  }
  return make(target, element, map);
}

int ClipPaths::make(int target, const Element& element, const Affine& map) {
  const Key key{target, {map.a, map.b, map.c, map.d, map.e, map.f}};
  if (const auto found = known_.find(key); found != known_.end()) return found->second;
  const Element& path = tree_[target];
  if (open_[static_cast<std::size_t>(target)]) refuse(path, "the clip path clips itself");
  if (++depth_ > most_nested_clips)
    refuse(path, "more than " + std::to_string(most_nested_clips) + " clip paths clip each other");
  open_[static_cast<std::size_t>(target)] = true;
  Context context = context_of(target);
  const Declarations declared = sheets_.declarations_of(path);
  const Affine own_map = map * transform_of(path, declared, context.viewport, notices_);
  Clip clip;
  for (const int child : path.children) add_part(child, context, own_map, false, clip);
  context.map = own_map;
  const auto no_box = [] { return Box{}; };
  if (const std::string_view value = own(declared, Property::clip_path); !value.empty())
    if (const int other = of(value, path, context, no_box); other != no_clip) clip.clips.push_back(other);
  open_[static_cast<std::size_t>(target)] = false;
  --depth_;
  if (clip.parts.empty()) notices_.add("a clip path without an area hides all that refers to it", element);
  clips_.push_back(std::move(clip));
  return known_[key] = static_cast<int>(clips_.size()) - 1;
}

void ClipPaths::add_part(int child, const Context& around, const Affine& map, bool is_used, Clip& clip) {
  const Element& raw = tree_[child];
  if (raw.name.empty()) return;
  if (++visits_ > max_visits) refuse(raw, "clip paths show more than " + std::to_string(max_visits) + " elements");
  const Declarations declared = sheets_.declarations_of(raw);
  if (own(declared, Property::display) == "none" || !meets_conditions(raw)) return;
  Context context = around;
  inherit(context, raw, declared, notices_);
  context.map = map * transform_of(raw, declared, context.viewport, notices_);
  const Element element = has_geometry(declared) ? with_geometry_of_style(raw, declared, notices_) : raw;
  const std::size_t first = clip.parts.size();
  if (element.name == "use" && !is_used) {
    const std::string* href = element.find("href");
    if (href == nullptr) href = element.find("xlink:href");
    const int target =
        href == nullptr || href->empty() || href->front() != '#' ? no_element : tree_.find(href->substr(1));
    if (target == no_element) return notices_.add("use refers to an element that does not exist", element);
    if (!is_shape(tree_[target].name))
      return notices_.add("use in a clip path shows no shape, and is left out", element);
    const double x = length_of(element, "x", Along::x, context.viewport);
    const double y = length_of(element, "y", Along::y, context.viewport);
    add_part(target, context, context.map * Affine{1, 0, 0, 1, x, y}, true, clip);
  } else if (is_shape(element.name)) {
    if (context.visibility == "hidden" || context.visibility == "collapse" || element.name == "line") return;
    Shape part;
    part.outline = outline_of(element, context.viewport);
    if (part.outline.empty()) return;
    steps_ += part.outline.steps.size();
    if (steps_ > max_steps)
      refuse(element,
             "clip paths have more than " + std::to_string(max_steps) + " segments, each place where one cuts counted");
    part.outline.transform(context.map);
    check_coordinates(element, part.outline);
    part.name = "clip path";
    part.line = element.line;
    part.even_odd = context.clip_rule == "evenodd";
    clip.parts.push_back(std::move(part));
  } else if (element.name == "text") {
    notices_.add("text in a clip path is not read", element);
  }
  if (first == clip.parts.size()) return;
  const auto box = [&] { return tight_box_of(clip.parts[first].outline, context.map.inverse()); };
  if (const std::string_view value = own(declared, Property::clip_path);
      !value.empty() && context.map.determinant() != 0)
    if (const int other = of(value, element, context, box); other != no_clip)
      for (std::size_t i = first; i < clip.parts.size(); ++i) clip.parts[i].clips.push_back(other);
}

/// What a clip path inherits from the elements around it.
Context ClipPaths::context_of(int index) {
  std::vector<int> around;
  for (int i = index; i != no_element; i = tree_[i].parent) around.push_back(i);
  Context context;
  context.viewport = root_viewport(tree_[0], Viewport::medium);
  for (auto at = around.rbegin(); at != around.rend(); ++at)
    inherit(context, tree_[*at], sheets_.declarations_of(tree_[*at]), notices_);
  return context;
}

bool ClipPaths::contains(int number, const Box& box) const {
  const Clip& clip = clips_[static_cast<std::size_t>(number)];
  if (clip.parts.size() != 1 || !clip.clips.empty() || !clip.parts[0].clips.empty()) return false;
  const Outline& outline = clip.parts[0].outline;
  const std::vector<Step> rectangle{Step::move, Step::line, Step::line, Step::line, Step::close};
  if (outline.steps != rectangle) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vector side = outline.points[(i + 1) % 4] - outline.points[i];
    if (side.x != 0 && side.y != 0) return false;
  }
  const Box inside = box_of(outline);
  return outline.points[0] != outline.points[2] && inside.contains(box.low) && inside.contains(box.high);
}

}  // namespace pliant::svg
