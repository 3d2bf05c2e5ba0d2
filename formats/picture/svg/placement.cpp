// formats/picture/svg/placement.cpp: where a drawing lies in its document, so that single precision is enough for it.
#include "formats/picture/svg/placement.h"

#include <algorithm>
#include <cmath>

#include "formats/picture/mesh_edges.h"
#include "pliant/mesh/documents/document_unit.h"

namespace pliant {
namespace {

constexpr double margin = 0.03;  // around the control points, as a part of the larger side
constexpr double far =
    1024;  // times the larger side: farther from the origin, a pixel is a few units in the last place
constexpr double least = 0x1p-60, most = 0x1p60;  // sizes that are drawn in the document's unit

double larger_side(const Box& box) { return std::max(box.high.x - box.low.x, box.high.y - box.low.y); }

/// What is shown, without a margin.
Box tight_box(const MeshData& mesh, const SvgOptions& options) {
  if (options.box) return *options.box;
  Box box = bounding_box(mesh);
  for (const Circle& circle : options.circles) {
    const Vector reach{circle.radius, circle.radius};
    box.extend(circle.center - reach);
    box.extend(circle.center + reach);
  }
  // Where there is nothing to see, the picture is of the origin.
  if (!(box.low.x <= box.high.x)) box.extend({0, 0});
  return box;
}

Box with_margin(Box box) {
  if (box.size() == 0) box = {box.low - Vector{0.5, 0.5}, box.high + Vector{0.5, 0.5}};
  const double larger = larger_side(box);
  // Even a picture of a straight line needs some height and width.
  const auto grow = [larger](double side) { return margin * larger + std::max(0.0, 0.05 * larger - side) / 2; };
  const Vector by{grow(box.high.x - box.low.x), grow(box.high.y - box.low.y)};
  return {box.low - by, box.high + by};
}

/// 0 where that is near enough, or else a number of few digits near the middle. What is shown lies so far from 0 that
/// subtracting it is exact there (Sterbenz).
double origin_of(double low, double high, double side) {
  const double middle = low + (high - low) / 2;
  if (!(std::abs(middle) > far * side)) return 0;
  if (side == 0) return middle;
  const double step = std::pow(10, std::ceil(std::log10(side)));
  return step * std::round(middle / step);
}

}  // namespace

PlacedDocument::PlacedDocument(const MeshData& mesh, const SvgOptions& options) : document_(mesh), options_(options) {
  const double size = bounding_box(mesh).size();
  if (size != 0 && !(size > least && size < most)) {
    moved_ = mesh;
    normalize_unit(*moved_);
  }
  const double unit = this->mesh().boundary.unit;
  if (options_.box) options_.box = Box{options_.box->low / unit, options_.box->high / unit};
  for (Circle& circle : options_.circles) circle = {circle.center / unit, circle.radius / unit};

  const Box tight = tight_box(this->mesh(), options_);
  const double side = larger_side(tight);
  const Vector origin{origin_of(tight.low.x, tight.high.x, side), origin_of(tight.low.y, tight.high.y, side)};
  if (origin != Vector{}) {
    if (!moved_) moved_ = mesh;
    for (Point& p : moved_->points) p = p - origin;
    if (options_.box) options_.box = Box{options_.box->low - origin, options_.box->high - origin};
    for (Circle& circle : options_.circles) circle.center = circle.center - origin;
  }
  placement_ = {unit, unit * origin};
  box_ = options_.box ? *options_.box : with_margin(tight_box(this->mesh(), options_));
}

}  // namespace pliant
