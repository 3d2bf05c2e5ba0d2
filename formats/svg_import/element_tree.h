// formats/svg_import/element_tree.h: the elements of an SVG document, as Expat finds them.
#pragma once
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace pliant::svg {

inline constexpr std::size_t max_depth = 256;           ///< of elements nested in each other
inline constexpr std::size_t max_elements = 5'000'000;  ///< that a document may have; they take a few GB at the worst
inline constexpr int no_element = -1;

struct Element {
  std::string name;  ///< local name; empty where the element is not in SVG's namespace
  std::vector<std::pair<std::string, std::string>>
      attributes;    ///< those without a namespace, "xlink:href" and "inkscape:label"
  std::string text;  ///< content of `style` and `title`, empty for others
  std::vector<int> children;
  int parent = no_element;
  long line = 0, column = 0;  ///< where its start tag is, counted from 1

  /// The attribute's value, or null.
  const std::string* find(std::string_view attribute) const;
};

/// The whole document; element 0 is the root, children come behind their parents.
class ElementTree {
 public:
  /// Reads a document. A root `svg` without a namespace is taken for SVG.
  ///
  /// Throws      InputError with "line L, column C" in place of a pointer: no well-formed XML; no SVG;
  ///             external, nested or long entities; elements nested deeper than max_depth
  explicit ElementTree(std::string_view bytes);

  const Element& operator[](int i) const { return elements_[static_cast<std::size_t>(i)]; }
  int size() const { return static_cast<int>(elements_.size()); }
  /// Does the document refer to style sheets in other files?
  bool names_sheets() const { return names_sheets_; }
  /// The first element with this id, or no_element.
  int find(const std::string& id) const;

 private:
  std::vector<Element> elements_;
  std::unordered_map<std::string, int> ids_;
  bool names_sheets_ = false;
};

/// A place as words: "line 3, column 7".
std::string place_of(const Element& element);

}  // namespace pliant::svg
