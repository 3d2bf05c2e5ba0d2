// formats/svg_import/shape_name.h: the name of a shape, as the drawing's author would call it.
#pragma once
#include <string>
#include <unordered_map>

#include "formats/svg_import/element_tree.h"

namespace pliant::svg {

class ShapeNames {
 public:
  explicit ShapeNames(const ElementTree& tree) : tree_(tree) {}
  /// The element's own name; else that of the `use` that shows it (`use` may be null); else its kind and number. No two
  /// names are alike.
  std::string name(const Element& element, const Element* shown_by, long number);
  /// The name itself, or with a number behind it if it is in use.
  std::string unique(const std::string& name);

 private:
  std::string own_name(const Element& element) const;
  std::string title_of(const Element& element) const;

  const ElementTree& tree_;
  std::unordered_map<std::string, long> used_;
};

}  // namespace pliant::svg
