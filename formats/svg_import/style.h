// formats/svg_import/style.h: the properties that decide what is filled: attributes and style sheets.
#pragma once
#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "formats/svg_import/element_tree.h"

namespace pliant::svg {

/// The properties that are read.
enum class Property {
  fill,
  fill_rule,
  fill_opacity,
  opacity,
  display,
  visibility,
  stroke,
  clip_path,
  mask,
  filter,
  transform_origin,
  transform_box,
  color,
  font_size,
  overflow,
  marker_start,
  marker_mid,
  marker_end,
  clip_rule,
  stroke_width,
  stroke_opacity,
  stroke_linejoin,
  stroke_linecap,
  stroke_miterlimit,
  stroke_dasharray,
  stroke_dashoffset,
  paint_order,
  vector_effect,
  // From here on they are properties only in styles; attributes of these names are read elsewhere, or mean nothing.
  transform,
  marker,
  font,
  translate,
  rotate,
  scale,
  offset_path,
  x,
  y,
  width,
  height,
  cx,
  cy,
  r,
  rx,
  ry,
  d
};
inline constexpr Property first_of_styles_only = Property::transform, first_of_geometry = Property::x;
inline constexpr std::size_t property_count = static_cast<std::size_t>(Property::d) + 1;
/// The property's name as documents write it.
std::string_view name_of(Property property);

/// The values that one element itself declares, as they are written, by property; empty where it declares none.
using Declarations = std::array<std::string_view, property_count>;

/// The style sheets inside a document.
class StyleSheets {
 public:
  /// Reads every `style` element. The tree must outlive this.
  explicit StyleSheets(const ElementTree& tree);
  /// What an element itself declares. Later sources win: presentation attributes, the sheets' rules by specificity, the
  /// style attribute, declarations with !important. The views are valid as long as the tree and this.
  Declarations declarations_of(const Element& element) const;
  /// Selectors and rules that are not read, and how often each was met.
  const std::map<std::string, long>& unread() const { return unread_; }

 private:
  struct Declaration {
    Property property;
    std::string_view value;
    bool important;
  };
  struct Rule {
    std::string_view type, id;  ///< of the element; empty: any
    std::vector<std::string_view> classes;
    std::size_t first, last;  ///< range in declarations_
    int specificity;
  };
  static void parse_declarations(std::string_view text, std::vector<Declaration>& out);
  void parse_sheet(std::string_view text);
  void parse_rule(std::string_view selectors, std::string_view body);
  bool parse_selector(std::string_view selector, Rule& rule) const;
  static bool matches(const Rule& rule, const Element& element, const std::vector<std::string_view>& classes);

  std::vector<std::string> texts_;  ///< texts of the sheets, without comments
  std::vector<Declaration> declarations_;
  std::vector<Rule> rules_;  ///< ascending in precedence
  std::map<std::string, long> unread_;
};

}  // namespace pliant::svg
