// formats/svg_import/style.cpp: the properties that decide what is filled: attributes and style sheets.
#include "formats/svg_import/style.h"

#include <algorithm>
#include <optional>

#include "formats/svg_import/scanner.h"
#include "pliant/boundary/fault.h"

namespace pliant::svg {
namespace {

constexpr std::size_t most_rules = 2000;  // every element is compared with every rule

constexpr std::array<std::string_view, property_count> names{"fill",
                                                             "fill-rule",
                                                             "fill-opacity",
                                                             "opacity",
                                                             "display",
                                                             "visibility",
                                                             "stroke",
                                                             "clip-path",
                                                             "mask",
                                                             "filter",
                                                             "transform-origin",
                                                             "transform-box",
                                                             "color",
                                                             "font-size",
                                                             "overflow",
                                                             "marker-start",
                                                             "marker-mid",
                                                             "marker-end",
                                                             "clip-rule",
                                                             "stroke-width",
                                                             "stroke-opacity",
                                                             "stroke-linejoin",
                                                             "stroke-linecap",
                                                             "stroke-miterlimit",
                                                             "stroke-dasharray",
                                                             "stroke-dashoffset",
                                                             "paint-order",
                                                             "vector-effect",
                                                             "transform",
                                                             "marker",
                                                             "font",
                                                             "translate",
                                                             "rotate",
                                                             "scale",
                                                             "offset-path",
                                                             "x",
                                                             "y",
                                                             "width",
                                                             "height",
                                                             "cx",
                                                             "cy",
                                                             "r",
                                                             "rx",
                                                             "ry",
                                                             "d"};

std::optional<Property> property_named(std::string_view name) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return static_cast<Property>(i);
  return std::nullopt;
}

std::string_view trimmed(std::string_view s) {
  while (!s.empty() && is_white(s.front())) s.remove_prefix(1);
  while (!s.empty() && is_white(s.back())) s.remove_suffix(1);
  return s;
}

std::vector<std::string_view> words(std::string_view s) {
  std::vector<std::string_view> out;
  for (std::size_t i = 0; i < s.size();) {
    while (i < s.size() && is_white(s[i])) ++i;
    const std::size_t first = i;
    while (i < s.size() && !is_white(s[i])) ++i;
    if (i > first) out.push_back(s.substr(first, i - first));
  }
  return out;
}

bool is_name(char c) {
  return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '-' || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

/// The sheet with a space for each comment, and without "<!--" and "-->", which stand around old sheets.
std::string without_comments(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    if (text.substr(i, 2) == "/*") {
      const std::size_t end = text.find("*/", i + 2);
      i = end == std::string_view::npos ? text.size() : end + 2;
      out += ' ';
    } else if (text.substr(i, 4) == "<!--") {
      i += 4;
    } else if (text.substr(i, 3) == "-->") {
      i += 3;
    } else {
      out += text[i++];
    }
  }
  return out;
}

/// Position of the next character that is one of `marks` and outside of quotes and parentheses; or the end.
std::size_t find_outside(std::string_view text, std::size_t from, std::string_view marks) {
  char quote = '\0';
  int depth = 0;
  for (std::size_t i = from; i < text.size(); ++i) {
    const char c = text[i];
    if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if (depth == 0 && marks.find(c) != std::string_view::npos) {
      return i;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '(') {
      ++depth;
    } else if (c == ')' && depth > 0) {
      --depth;
    }
  }
  return text.size();
}

}  // namespace

std::string_view name_of(Property property) { return names[static_cast<std::size_t>(property)]; }

StyleSheets::StyleSheets(const ElementTree& tree) {
  for (int i = 0; i < tree.size(); ++i) {
    if (tree[i].name != "style") continue;
    const std::string* type = tree[i].find("type");
    if (type != nullptr && !type->empty() && *type != "text/css") {
      ++unread_["style sheets of type '" + *type + "'"];
      continue;
    }
    const std::string* media = tree[i].find("media");
    if (media != nullptr && !media->empty() && *media != "all" && *media != "screen") {
      ++unread_["style sheets for '" + *media + "'"];
      continue;
    }
    texts_.push_back(without_comments(tree[i].text));
  }
  for (const std::string& text : texts_) {  // rules point into the texts: all are added by now, so none moves
    parse_sheet(text);
    if (rules_.size() > most_rules)
      throw InputError("", "the style sheets have more than " + std::to_string(most_rules) + " selectors");
  }
  std::stable_sort(rules_.begin(), rules_.end(),
                   [](const Rule& a, const Rule& b) { return a.specificity < b.specificity; });
}

void StyleSheets::parse_sheet(std::string_view text) {
  for (std::size_t i = 0; i < text.size() && rules_.size() <= most_rules;) {
    const std::size_t brace = find_outside(text, i, "{;");
    const std::string_view head = trimmed(text.substr(i, brace - i));
    if (!head.empty() && head.front() == '@') {
      std::size_t end = 1;
      while (end < head.size() && is_name(head[end])) ++end;
      if (head.substr(0, end) != "@charset")
        ++unread_["rules " + std::string(head.substr(0, end)) + " of style sheets"];
      i = brace + 1;
      if (brace >= text.size() || text[brace] == ';') continue;
      for (int depth = 1; i < text.size() && depth > 0; ++i) depth += text[i] == '{' ? 1 : text[i] == '}' ? -1 : 0;
      continue;
    }
    if (brace >= text.size()) break;
    if (text[brace] == ';') {
      i = brace + 1;
      continue;
    }
    const std::size_t end = std::min(text.find('}', brace), text.size());
    parse_rule(head, text.substr(brace + 1, end - brace - 1));
    i = end + 1;
  }
}

void StyleSheets::parse_rule(std::string_view selectors, std::string_view body) {
  const std::size_t first = declarations_.size();
  parse_declarations(body, declarations_);
  if (declarations_.size() == first) return;
  for (std::size_t i = 0; i <= selectors.size();) {
    const std::size_t comma = std::min(selectors.find(',', i), selectors.size());
    const std::string_view selector = trimmed(selectors.substr(i, comma - i));
    Rule rule;
    rule.first = first;
    rule.last = declarations_.size();
    if (parse_selector(selector, rule))
      rules_.push_back(std::move(rule));
    else
      ++unread_["style sheet rules whose selector is not simple"];
    i = comma + 1;
  }
}

bool StyleSheets::parse_selector(std::string_view selector, Rule& rule) const {
  rule.specificity = 0;
  if (selector.empty()) return false;
  for (std::size_t i = 0; i < selector.size();) {
    const char mark = selector[i];
    if (mark == '*' && i == 0) {
      ++i;
      continue;
    }
    if (mark == '.' || mark == '#') ++i;
    const std::size_t first = i;
    while (i < selector.size() && is_name(selector[i])) ++i;
    const std::string_view name = selector.substr(first, i - first);
    if (name.empty()) return false;
    if (mark == '.') {
      rule.classes.push_back(name);
      rule.specificity += 1000;
    } else if (mark == '#') {
      if (!rule.id.empty() && rule.id != name) return false;
      rule.id = name;
      rule.specificity += 1'000'000;
    } else if (first == 0) {
      rule.type = name;
      rule.specificity += 1;
    } else {
      return false;
    }
  }
  return true;
}

void StyleSheets::parse_declarations(std::string_view text, std::vector<Declaration>& out) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t end = find_outside(text, i, ";");
    const std::string_view one = text.substr(i, end - i);
    i = end + 1;
    const std::size_t colon = one.find(':');
    if (colon == std::string_view::npos) continue;
    const auto property = property_named(trimmed(one.substr(0, colon)));
    if (!property) continue;
    std::string_view value = trimmed(one.substr(colon + 1));
    bool important = false;
    const std::size_t mark = value.rfind('!');
    if (mark != std::string_view::npos && trimmed(value.substr(mark + 1)) == "important") {
      important = true;
      value = trimmed(value.substr(0, mark));
    }
    if (!value.empty()) out.push_back({*property, value, important});
  }
}

bool StyleSheets::matches(const Rule& rule, const Element& element, const std::vector<std::string_view>& classes) {
  if (!rule.type.empty() && rule.type != element.name) return false;
  if (!rule.id.empty()) {
    const std::string* id = element.find("id");
    if (id == nullptr || rule.id != *id) return false;
  }
  return std::all_of(rule.classes.begin(), rule.classes.end(), [&](std::string_view name) {
    return std::find(classes.begin(), classes.end(), name) != classes.end();
  });
}

Declarations StyleSheets::declarations_of(const Element& element) const {
  Declarations out;
  std::array<bool, property_count> is_important{};
  const auto take = [&](const Declaration& d) {
    const auto i = static_cast<std::size_t>(d.property);
    if (is_important[i] && !d.important) return;
    out[i] = d.value;
    is_important[i] = d.important;
  };
  for (const auto& [name, value] : element.attributes)
    if (const auto property = property_named(name); property && *property < first_of_styles_only)
      take({*property, trimmed(value), false});
  if (!rules_.empty()) {
    const std::string* attribute = element.find("class");
    const auto classes = attribute == nullptr ? std::vector<std::string_view>{} : words(*attribute);
    for (const Rule& rule : rules_)
      if (matches(rule, element, classes))
        for (std::size_t i = rule.first; i < rule.last; ++i) take(declarations_[i]);
  }
  if (const std::string* style = element.find("style")) {
    std::vector<Declaration> own;
    parse_declarations(*style, own);
    for (const Declaration& d : own) take(d);
  }
  return out;
}

}  // namespace pliant::svg
