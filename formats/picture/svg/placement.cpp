// formats/picture/svg/placement.cpp: where a drawing lies in its document, so that single precision is enough for it.
#include "formats/picture/svg/placement.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "formats/picture/mesh_edges.h"
#include "pliant/mesh/documents/document_unit.h"

namespace pliant {
namespace {

constexpr double margin = 0.03;  // around the control points, as a part of the larger side
// How far from the origin the picture may be, in its larger side: farther, a pixel is a few units in the last place.
constexpr double far = 1024;
constexpr double least_side = 0x1p-3, most_side = 0x1p20;  // larger sides of pictures in the document's unit
constexpr int usual_exponent = 9;                          // in another unit the larger side is from 2^9 to 2^10
constexpr int most_box_halvings = 60;                      // from the mesh to what is shown

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

double unit_for(double side, double size) {
  if (side == 0 || (side >= least_side && side <= most_side)) return 1;
  return std::exp2(std::max(std::ilogb(side) - usual_exponent, std::ilogb(size) - most_box_halvings));
}

}  // namespace

PlacedDocument::PlacedDocument(const MeshData& mesh, const SvgOptions& options) : document_(mesh), options_(options) {
  require_document_size(mesh);
  const Box tight = tight_box(mesh, options);
  const double side = larger_side(tight);
  if (!(side <= greatest_document_size))
    throw std::invalid_argument("--box, --circle: what is shown is wider than 3e153 (2^510)");
  placement_.unit = unit_for(side, std::max(side, bounding_box(mesh).size()));
  placement_.origin = {origin_of(tight.low.x, tight.high.x, side), origin_of(tight.low.y, tight.high.y, side)};
  if (placement_.unit != 1 || placement_.origin != Point{}) {
    const auto move = [this](Point& p) { p = (p - placement_.origin) / placement_.unit; };
    moved_ = mesh;
    for (Point& p : moved_->points) move(p);
    if (options_.box) move(options_.box->low), move(options_.box->high);
    for (Circle& circle : options_.circles) move(circle.center), circle.radius /= placement_.unit;
  }
  box_ = options_.box ? *options_.box : with_margin(tight_box(this->mesh(), options_));
}

}  // namespace pliant
