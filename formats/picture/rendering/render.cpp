// formats/picture/rendering/render.cpp: SVG pictures as PNG and PDF, by librsvg and cairo.
#include "formats/picture/rendering/render.h"

#include <cairo-pdf.h>
#include <cairo.h>
#include <librsvg/rsvg.h>

#include <cmath>
#include <memory>
#include <stdexcept>

#ifdef __SANITIZE_ADDRESS__
// Fontconfig and Pango, which librsvg draws text with, keep what they have read of fonts until the process ends.
extern "C" const char* __lsan_default_suppressions();  // NOLINT(bugprone-reserved-identifier)
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig\nleak:libpango\nleak:librsvg\n"; }
extern "C" const char* __lsan_default_options();  // NOLINT(bugprone-reserved-identifier)
extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }
#endif

namespace pliant {
namespace {

constexpr double dots_per_inch = 96, points_per_pixel = 0.75;

struct Release {
  void operator()(void* object) const { g_object_unref(object); }
  void operator()(GError* error) const { g_error_free(error); }
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};
template <typename T>
using Held = std::unique_ptr<T, Release>;

[[noreturn]] void fail(GError* error) {
  const Held<GError> held(error);
  throw std::runtime_error(std::string("librsvg: ") + (error != nullptr ? error->message : "no message"));
}

cairo_status_t append(void* out, const unsigned char* bytes, unsigned count) {
  static_cast<std::string*>(out)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) throw std::runtime_error(std::string("cairo: ") + cairo_status_to_string(status));
}

}  // namespace

std::string render_svg(const std::string& svg, RenderedFormat format) {
  GError* error = nullptr;
  const Held<GInputStream> stream(
      g_memory_input_stream_new_from_data(svg.data(), static_cast<gssize>(svg.size()), nullptr));
  // Without this flag it refuses texts of 10 MB, which the path of a large mesh's edges has.
  const Held<RsvgHandle> handle(
      rsvg_handle_new_from_stream_sync(stream.get(), nullptr, RSVG_HANDLE_FLAG_UNLIMITED, nullptr, &error));
  if (handle == nullptr) fail(error);
  rsvg_handle_set_dpi(handle.get(), dots_per_inch);
  double width = 0, height = 0;
  if (!rsvg_handle_get_intrinsic_size_in_pixels(handle.get(), &width, &height))
    throw std::runtime_error("librsvg: the picture has no size");

  std::string bytes;
  Held<cairo_surface_t> surface;
  if (format == RenderedFormat::png) {
    width = std::max(1.0, std::round(width)), height = std::max(1.0, std::round(height));
    if (width > greatest_png_side || height > greatest_png_side)
      throw std::runtime_error("a PNG of " + std::to_string(std::llround(width)) + " by " +
                               std::to_string(std::llround(height)) + " pixels is too large; at most 32767 by 32767");
    surface.reset(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width), static_cast<int>(height)));
  } else {
    width *= points_per_pixel, height *= points_per_pixel;
    surface.reset(cairo_pdf_surface_create_for_stream(append, &bytes, width, height));
    // The time of creation would differ from run to run.
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, nullptr);
  }
  check(cairo_surface_status(surface.get()));
  {
    const Held<cairo_t> context(cairo_create(surface.get()));
    const RsvgRectangle whole{0, 0, width, height};
    if (!rsvg_handle_render_document(handle.get(), context.get(), &whole, &error)) fail(error);
    check(cairo_status(context.get()));
  }
  if (format == RenderedFormat::png) check(cairo_surface_write_to_png_stream(surface.get(), append, &bytes));
  cairo_surface_finish(surface.get());
  check(cairo_surface_status(surface.get()));
  surface.reset();
  return bytes;
}

}  // namespace pliant
