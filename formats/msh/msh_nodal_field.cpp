// formats/msh/msh_nodal_field.cpp: a field that is being read, as values at nodes, which may differ between faces.
#include "formats/msh/msh_nodal_field.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pliant/geometry/control_net.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/net_layout.h"

namespace pliant {
namespace {

std::uint64_t key_of(PointId node, FaceId face) { return index(node) << 32 | index(face); }

}  // namespace

MshNodalField::MshNodalField(const MeshData& mesh, int components)
    : width_(index(components)), points_(mesh.points.size()), values_(points_ * width_, 0.0) {}

void MshNodalField::set(PointId node, const double* value) {
  std::copy_n(value, width_, &values_[index(node) * width_]);
  for (std::size_t c = 0; c < width_; ++c) largest_ = std::max(largest_, std::fabs(value[c]));
}

std::size_t MshNodalField::slot(PointId node, FaceId face, bool& is_new) {
  FaceId& first = first_face_[index(node)];
  is_new = first == none;
  if (is_new) first = face;
  if (first == face) return index(node);
  const auto [place, added] = further_.emplace(key_of(node, face), points_ + further_.size());
  is_new = added;
  if (added) values_.resize(values_.size() + width_);
  return place->second;
}

std::size_t MshNodalField::slot(PointId node, FaceId face) const {
  if (first_face_.empty() || first_face_[index(node)] == face) return index(node);
  const auto found = further_.find(key_of(node, face));
  return found == further_.end() ? index(node) : found->second;
}

void MshNodalField::set_triangle(std::size_t t, const double* values, const MeshData& mesh) {
  if (first_face_.empty()) first_face_.assign(points_, none);
  const std::size_t size = index(net_size(mesh.degree));
  const PointId* net = &mesh.triangles[t * size];
  for (std::size_t k = 0; k < size; ++k, values += width_) {
    bool is_new = false;
    double* row = &values_[slot(net[k], mesh.triangle_faces[t], is_new) * width_];
    for (std::size_t c = 0; c < width_; ++c) {
      largest_ = std::max(largest_, std::fabs(values[c]));
      if (is_new) {
        row[c] = values[c];
      } else if (const double difference = std::fabs(values[c] - row[c]); difference > inside_.size) {
        inside_ = {difference, net[k], t};
      }
    }
  }
}

bool MshNodalField::differs_between_faces() const {
  return std::any_of(further_.begin(), further_.end(), [&](const auto& entry) {
    const double* one = &values_[static_cast<std::size_t>(entry.first >> 32) * width_];
    const double* other = &values_[entry.second * width_];
    for (std::size_t c = 0; c < width_; ++c)
      if (!is_rounding(std::fabs(one[c] - other[c]))) return true;
    return false;
  });
}

bool MshNodalField::is_flat() const {
  for (std::size_t k = width_ - 1; k < values_.size(); k += width_)
    if (values_[k] != 0) return false;
  return true;
}

void MshNodalField::keep_components(int components) {
  const std::size_t rows = values_.size() / width_, width = index(components);
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t c = 0; c < width; ++c) values_[row * width + c] = values_[row * width_ + c];
  values_.resize(rows * width);
  width_ = width;
}

Field MshNodalField::take(const MeshData& mesh, bool by_face) && {
  if (!by_face) {
    values_.resize(points_ * width_);
    further_.clear();
    first_face_ = {};
  }
  const int degree = mesh.degree;
  const NetLayout& layout = NetLayout::of(degree);
  const std::size_t size = index(layout.size());
  std::vector<char> done(degree > 1 ? values_.size() / width_ : 0, 0);
  std::vector<std::size_t> slots(size);
  std::vector<double> rows(size * width_);
  const auto width = static_cast<int>(width_);
  // `count` rows from and to the places that place(k) names in the net.
  const auto copy_in = [&](int count, auto&& place) {
    for (int k = 0; k < count; ++k)
      std::copy_n(&values_[slots[index(place(k))] * width_], width_, &rows[index(k) * width_]);
  };
  const auto copy_out = [&](int first, int stop, auto&& place) {
    for (int k = first; k < stop; ++k) {
      std::copy_n(&rows[index(k) * width_], width_, &values_[slots[index(place(k))] * width_]);
      done[slots[index(place(k))]] = 1;
    }
  };
  for (std::size_t t = 0; t < mesh.triangle_faces.size() && degree > 1; ++t) {
    const PointId* net = &mesh.triangles[t * size];
    for (std::size_t k = 0; k < size; ++k) slots[k] = slot(net[k], mesh.triangle_faces[t]);
    for (int e = 0; e < 3; ++e) {
      if (done[slots[index(layout.edge_index(e, 1))]]) continue;
      const bool forward = net[e] < net[(e + 1) % 3];
      const auto place = [&](int k) { return layout.edge_index(e, forward ? k : degree - k); };
      copy_in(degree + 1, place);
      interpolate_polygon(degree, width, std::span(rows).first(index(degree + 1) * width_));
      copy_out(1, degree, place);
    }
    const int first = layout.first_interior();
    if (first == layout.size() || done[slots[index(first)]]) continue;
    const auto itself = [](int k) { return k; };
    copy_in(layout.size(), itself);
    interpolate_interior(degree, width, rows);
    copy_out(first, layout.size(), itself);
  }
  Field field;
  field.components = width;
  field.by_face = by_face;
  if (!by_face) {
    field.values = std::move(values_);
    return field;
  }
  // Further faces, sorted, join the first ones of their nodes.
  std::vector<std::uint64_t> keys;
  keys.reserve(values_.size() / width_);
  for (const auto& entry : further_) keys.push_back(entry.first);
  for (std::size_t p = 0; p < points_; ++p)
    if (first_face_[p] != none) keys.push_back(key_of(static_cast<PointId>(p), first_face_[p]));
  std::sort(keys.begin(), keys.end());
  field.places.reserve(keys.size());
  field.values.reserve(keys.size() * width_);
  for (const std::uint64_t key : keys) {
    const auto node = static_cast<PointId>(key >> 32);
    const auto face = static_cast<FaceId>(key & 0xffffffff);
    field.places.push_back({node, face});
    const double* row = &values_[slot(node, face) * width_];
    field.values.insert(field.values.end(), row, row + width_);
  }
  values_ = {};
  return field;
}

}  // namespace pliant
