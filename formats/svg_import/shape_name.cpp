// formats/svg_import/shape_name.cpp: the name of a shape, as the drawing's author would call it.
#include "formats/svg_import/shape_name.h"

namespace pliant::svg {
namespace {

constexpr std::size_t longest_title = 100;  // in bytes: longer titles are no names

/// Is it an id that a drawing program made up, such as "path1234-5" or "rect7"?
bool is_made_up(const std::string& id, const std::string& kind) {
  for (const std::string& start :
       {kind, std::string("path"), std::string("g"), std::string("use"), std::string("svg")}) {
    if (id.compare(0, start.size(), start) != 0) continue;
    const std::string rest = id.substr(start.size());
    if (!rest.empty() && rest.find_first_not_of("0123456789-_") == std::string::npos) return true;
  }
  return false;
}

/// The text with single spaces between its words.
std::string tidied(const std::string& text) {
  std::string out;
  bool is_apart = false;
  for (const char c : text) {
    if (c == ' ' || c == '\t' || c == '\n' || c == '\r') {
      is_apart = !out.empty();
      continue;
    }
    if (is_apart) out += ' ';
    is_apart = false;
    out += c;
  }
  return out;
}

}  // namespace

std::string ShapeNames::title_of(const Element& element) const {
  for (const int child : element.children)
    if (tree_[child].name == "title") {
      const std::string title = tidied(tree_[child].text);
      return title.size() <= longest_title ? title : "";
    }
  return {};
}

std::string ShapeNames::own_name(const Element& element) const {
  if (const std::string* label = element.find("inkscape:label"); label != nullptr && !label->empty()) return *label;
  const std::string* id = element.find("id");
  const bool has_id = id != nullptr && !id->empty();
  if (has_id && !is_made_up(*id, element.name)) return *id;
  if (std::string title = title_of(element); !title.empty()) return title;
  return has_id ? *id : "";
}

std::string ShapeNames::name(const Element& element, const Element* shown_by, long number) {
  std::string name = own_name(element);
  if (name.empty() && shown_by != nullptr) name = own_name(*shown_by);
  if (name.empty()) name = element.name + " " + std::to_string(number);
  return unique(name);
}

std::string ShapeNames::unique(const std::string& name) {
  long& used = used_[name];
  if (used++ == 0) return name;
  for (;; ++used) {
    std::string other = name + " (" + std::to_string(used) + ")";
    if (used_.emplace(other, 1).second) return other;
  }
}

}  // namespace pliant::svg
