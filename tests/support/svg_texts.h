// tests/support/svg_texts.h: pictures of meshes as text, and the numbers in them.
#pragma once
#include <regex>
#include <string>
#include <vector>

#include "formats/picture/svg.h"

namespace pliant::samples {

inline std::string svg_of(const MeshData& mesh, const std::string& color, SvgOptions options = SvgOptions()) {
  options.color = parse_color_by(color);
  std::string text;
  write_svg(mesh, options, text);
  return text;
}

/// The numbers in a text, letters left out.
inline std::vector<double> numbers(const std::string& text) {
  std::vector<double> result;
  const std::regex number(R"([-+]?\d+\.?\d*(?:e[-+]?\d+)?)");
  for (auto it = std::sregex_iterator(text.begin(), text.end(), number); it != std::sregex_iterator(); ++it)
    result.push_back(std::stod(it->str()));
  return result;
}

}  // namespace pliant::samples
