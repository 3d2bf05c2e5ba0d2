// lib/pliant/mesh/documents/reread.cpp: compacts a mesh and chooses its unit of length anew, if all its numbers are
// finite.
#include "pliant/mesh/documents/reread.h"

#include <cmath>
#include <span>
#include <stdexcept>

#include "pliant/mesh/documents/document_unit.h"

namespace pliant {
namespace {

/// Adds 0 for each finite number and NaN for each other one, so that one test at the end does for all; in two sums, so
/// that an addition need not wait for the one before.
class FiniteSum {
 public:
  void add(const Point& p) {
    even_ += 0 * p.x;
    odd_ += 0 * p.y;
  }
  void add(std::span<const double> numbers) {
    std::size_t k = 0;
    for (; k + 1 < numbers.size(); k += 2) add({numbers[k], numbers[k + 1]});
    if (k < numbers.size()) even_ += 0 * numbers[k];
  }
  bool is_finite() const { return even_ + odd_ == 0; }

 private:
  double even_ = 0, odd_ = 0;
};

void require_finite(const Mesh& mesh) {
  FiniteSum sum;
  for (PointId p = 0; p < mesh.point_slots(); ++p) sum.add(mesh.point(p));
  for (const Field& field : mesh.fields()) sum.add(field.values);
  for (const Curve& curve : mesh.boundary().curves) {
    sum.add({curve.removal_error, 0});
    for (const Point& p : curve.spline.points()) sum.add(p);
  }
  for (const Point& p : mesh.boundary().vertices) sum.add(p);
  if (!sum.is_finite()) throw std::domain_error("a number of the result is not finite");
}

}  // namespace

void reread(Mesh& mesh) {
  mesh.compact();
  if (!std::isfinite(mesh.time)) throw std::domain_error("a number of the result is not finite");
  if (mesh.is_settled()) return;
  require_finite(mesh);
  if (mesh.boundary().unit != 1 || !has_tame_size(mesh)) {
    MeshData data = mesh.to_data();
    restore_unit(data);
    normalize_unit(data);
    mesh = Mesh(std::move(data));
  }
  mesh.settle();
}

}  // namespace pliant
