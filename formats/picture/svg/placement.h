// formats/picture/svg/placement.h: where a drawing lies in its document, so that single precision is enough for it.
#pragma once
#include <optional>

#include "formats/picture/svg.h"

namespace pliant {

/// A point of the drawing is `origin + unit * point` in the document.
struct Placement {
  double unit = 1;
  Point origin;

  Point in_document(const Point& p) const { return origin + unit * p; }
};

/// A document as it is drawn. Viewers compute with 24 bits, and Chromium takes a gradient shorter than 2^-15 for a
/// plain colour: what is shown is drawn in another unit where it is very small or large, about another origin where it
/// lies far from that of the document.
class PlacedDocument {
 public:
  /// Throws      InputError where the mesh is too large or too small (require_document_size); std::invalid_argument
  ///             where what is shown is
  PlacedDocument(const MeshData& mesh, const SvgOptions& options);

  const MeshData& mesh() const { return moved_ ? *moved_ : document_; }
  const SvgOptions& options() const { return options_; }  ///< box and circles as they are drawn
  const Placement& placement() const { return placement_; }
  const Box& box() const { return box_; }  ///< what is shown

 private:
  const MeshData& document_;
  std::optional<MeshData> moved_;  ///< its boundary's splines are left where they were: nothing draws them
  SvgOptions options_;
  Placement placement_;
  Box box_;
};

}  // namespace pliant
