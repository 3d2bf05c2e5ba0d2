// formats/picture/rendering/render.h: SVG pictures as PNG and PDF, by librsvg and cairo.
#pragma once
#include <string>

namespace pliant {

enum class RenderedFormat { png, pdf };

/// The greatest width and height of a PNG in pixels.
inline constexpr double greatest_png_side = 32767;

/// The bytes of a picture that write_svg made: in PNG a pixel for each of its pixels, in PDF 3/4 of a point, so that
/// text has its size. They depend on the fonts of the machine; on one machine the same picture gives the same bytes.
/// Throws      std::runtime_error if the picture is too large or librsvg fails
std::string render_svg(const std::string& svg, RenderedFormat format);

}  // namespace pliant
