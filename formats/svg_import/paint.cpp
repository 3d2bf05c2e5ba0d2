// formats/svg_import/paint.cpp: does a paint show anything? CSS colours in every spelling.
#include "formats/svg_import/paint.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>

namespace pliant::svg {
namespace {

constexpr std::string_view named_colours =
    " aliceblue antiquewhite aqua aquamarine azure beige bisque black blanchedalmond blue blueviolet brown burlywood "
    "cadetblue chartreuse chocolate coral cornflowerblue cornsilk crimson cyan darkblue darkcyan darkgoldenrod "
    "darkgray darkgreen darkgrey darkkhaki darkmagenta darkolivegreen darkorange darkorchid darkred darksalmon "
    "darkseagreen darkslateblue darkslategray darkslategrey darkturquoise darkviolet deeppink deepskyblue dimgray "
    "dimgrey dodgerblue firebrick floralwhite forestgreen fuchsia gainsboro ghostwhite gold goldenrod gray green "
    "greenyellow grey honeydew hotpink indianred indigo ivory khaki lavender lavenderblush lawngreen lemonchiffon "
    "lightblue lightcoral lightcyan lightgoldenrodyellow lightgray lightgreen lightgrey lightpink lightsalmon "
    "lightseagreen lightskyblue lightslategray lightslategrey lightsteelblue lightyellow lime limegreen linen magenta "
    "maroon mediumaquamarine mediumblue mediumorchid mediumpurple mediumseagreen mediumslateblue mediumspringgreen "
    "mediumturquoise mediumvioletred midnightblue mintcream mistyrose moccasin navajowhite navy oldlace olive "
    "olivedrab orange orangered orchid palegoldenrod palegreen paleturquoise palevioletred papayawhip peachpuff peru "
    "pink plum powderblue purple rebeccapurple red rosybrown royalblue saddlebrown salmon sandybrown seagreen seashell "
    "sienna silver skyblue slateblue slategray slategrey snow springgreen steelblue tan teal thistle tomato turquoise "
    "violet wheat white whitesmoke yellow yellowgreen "
    // colours of the system, such as "canvas"
    "accentcolor accentcolortext activetext buttonborder buttonface buttontext canvas canvastext field fieldtext "
    "graytext highlight highlighttext linktext mark marktext selecteditem selecteditemtext visitedtext activeborder "
    "activecaption appworkspace background buttonhighlight buttonshadow captiontext inactiveborder inactivecaption "
    "inactivecaptiontext infobackground infotext menu menutext scrollbar threeddarkshadow threedface threedhighlight "
    "threedlightshadow threedshadow window windowframe windowtext ";

constexpr std::array<std::string_view, 15> colour_functions{
    "rgb",   "rgba",  "hsl",       "hsla",        "hwb",       "lab",        "lch",           "oklab",
    "oklch", "color", "color-mix", "device-cmyk", "icc-color", "light-dark", "contrast-color"};

std::string lowered(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

Paint classify_hex(std::string_view word) {
  const std::string_view digits = word.substr(1);
  if (digits.find_first_not_of("0123456789abcdef") != std::string_view::npos) return Paint::not_understood;
  switch (digits.size()) {
    case 3:
    case 6:
      return Paint::colour;
    case 4:
      return digits[3] == '0' ? Paint::invisible : Paint::colour;
    case 8:
      return digits.substr(6) == "00" ? Paint::invisible : Paint::colour;
    default:
      return Paint::not_understood;
  }
}

/// The alpha among a colour's arguments: what stands behind a slash, or the fourth of arguments with commas.
bool has_no_alpha(std::string_view arguments) {
  std::size_t at = arguments.rfind('/');
  if (at == std::string_view::npos) {
    at = 0;
    for (int comma = 0; comma < 3; ++comma) {
      at = arguments.find(',', at);
      if (at == std::string_view::npos) return false;
      ++at;
    }
  } else {
    ++at;
  }
  const std::string_view alpha =
      arguments.substr(std::min(arguments.find_first_not_of(" \t\r\n", at), arguments.size()));
  return alpha.substr(0, 4) == "none" || fraction_of(alpha, 1) <= 0;
}

Paint classify_function(std::string_view name, std::string_view rest) {
  if (name == "url") return Paint::reference;
  if (std::find(colour_functions.begin(), colour_functions.end(), name) == colour_functions.end())
    return Paint::not_understood;
  const std::string_view arguments = rest.substr(0, rest.find(')'));
  if (name == "device-cmyk" || name == "color-mix" || name == "light-dark") return Paint::colour;
  return has_no_alpha(arguments) ? Paint::invisible : Paint::colour;
}

}  // namespace

bool is_same_word(std::string_view a, std::string_view b) { return lowered(a) == lowered(b); }

std::string referenced_id(std::string_view value) {
  value.remove_prefix(std::min(value.find_first_not_of(" \t\r\n"), value.size()));
  if (!is_same_word(value.substr(0, 4), "url(")) return {};
  std::string id(value.substr(4, value.find(')') - 4));
  std::erase_if(id, [](char c) { return c == '"' || c == '\'' || c == ' '; });
  return id.empty() || id.front() != '#' ? "" : id.substr(1);
}

double fraction_of(std::string_view text, double otherwise) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) return otherwise;
  return end != text.data() + text.size() && *end == '%' ? value / 100 : value;
}

Paint classify_paint(std::string_view value) {
  const std::string text = lowered(value);
  const std::size_t first = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  const std::size_t end = std::min(text.find_first_of(" \t\r\n(", first), text.size());
  const std::string word = text.substr(first, end - first);
  if (word.empty()) return Paint::not_understood;
  if (end < text.size() && text[end] == '(') return classify_function(word, std::string_view(text).substr(end + 1));
  if (word.front() == '#') return classify_hex(word);
  if (word == "none" || word == "transparent") return Paint::invisible;
  if (word == "currentcolor") return Paint::current;
  if (word == "context-fill") return Paint::of_fill;
  if (word == "context-stroke") return Paint::of_stroke;
  return named_colours.find(" " + word + " ") != std::string_view::npos ? Paint::colour : Paint::not_understood;
}

}  // namespace pliant::svg
