// lib/pliant/ops/removal/recover_parent.cpp: inverts de Casteljau's subdivision, by least squares with refinement.
#include "pliant/ops/removal/recover_parent.h"

#include <algorithm>
#include <cmath>

#include "pliant/geometry/bernstein.h"
#include "pliant/geometry/control_net.h"
#include "pliant/geometry/dense/least_squares.h"
#include "pliant/geometry/index.h"

namespace pliant {
namespace {

constexpr int unit_block = 16;  // so many unit nets are divided together; nets of this width need no allocation

LeastSquares& scratch() {
  thread_local LeastSquares squares;
  return squares;
}

}  // namespace

void ParentRecovery::start(const Mesh& mesh, std::span<const TriangleId> pieces) {
  degree_ = mesh.degree();
  n_ = mesh.net_size();
  width_ = mesh.width();
  patch_.capture(mesh, pieces);
  const Patch::Moments moments = patch_.moments_of(none);
  linear_.clear();
  for (int c = 2; c < width_; ++c) linear_.push_back(patch_.linear_of(c, none, moments));
  const std::span<const double> rows = patch_.all_rows();
  pieces_.assign(rows.begin(), rows.end());
  largest_.assign(index(width_), 0.0);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    double& largest = largest_[k % index(width_)];
    largest = std::max(largest, std::abs(rows[k]));
  }
  tolerances_.assign(index(width_), mesh.tolerance());
  for (std::size_t c = 2; c < index(width_); ++c)
    tolerances_[c] = subdivision_tolerance * largest_[c] +
                     (std::abs(linear_[c - 2].c1) + std::abs(linear_[c - 2].c2)) * mesh.tolerance();
  origin_ = {rows[0], rows[1]};
  reduce(pieces_);
  for (std::size_t c = 2; c < index(width_); ++c) {
    double rest = 0;
    for (std::size_t k = c; k < pieces_.size(); k += index(width_)) rest = std::max(rest, std::abs(pieces_[k]));
    if (rest > patch_.rounding_of(linear_[c - 2], largest_[c])) continue;
    for (std::size_t k = c; k < pieces_.size(); k += index(width_)) pieces_[k] = 0;
  }
  parent_.assign(index(n_ * width_), 0.0);
  reduced_.assign(parent_.size(), 0.0);
}

void ParentRecovery::reduce(std::span<double> rows) const {
  for (std::size_t first = 0; first < rows.size(); first += index(width_)) {
    const Point place{rows[first], rows[first + 1]};
    for (std::size_t c = 0; c < linear_.size(); ++c) rows[first + 2 + c] -= patch_.evaluate(linear_[c], place);
    rows[first] -= origin_.x;
    rows[first + 1] -= origin_.y;
  }
}

void ParentRecovery::complete(std::span<double> row) const {
  const Point place{row[0] + origin_.x, row[1] + origin_.y};
  row[0] = place.x;
  row[1] = place.y;
  for (std::size_t c = 0; c < linear_.size(); ++c) row[2 + c] += patch_.evaluate(linear_[c], place);
}

void ParentRecovery::take_edge(int e, int piece, int from) {
  const NetLayout& layout = NetLayout::of(degree_);
  for (int k = 0; k <= degree_; ++k) {
    const int there = (piece * n_ + layout.edge_index(from, k)) * width_, here = layout.edge_index(e, k) * width_;
    std::copy_n(patch_.all_rows().begin() + there, width_, parent_.begin() + here);
    std::copy_n(pieces_.begin() + there, width_, reduced_.begin() + here);
  }
}

bool ParentRecovery::find_edge(int e, double s, std::array<int, 2> first, std::array<int, 2> second) {
  const NetLayout& layout = NetLayout::of(degree_);
  const int p = degree_, unknowns = p - 1;
  const std::size_t width = index(width_), half = index(p + 1) * width;
  const auto piece_row = [&](const std::array<int, 2>& edge, int k) {
    return pieces_.data() + index((edge[0] * n_ + layout.edge_index(edge[1], k)) * width_);
  };
  // The polygon of the edge, whose ends are known; behind it the two halves into which it is divided.
  image_.assign(3 * half, 0.0);
  std::copy_n(piece_row(first, 0), width, image_.begin());
  std::copy_n(piece_row(second, p), width, image_.begin() + static_cast<std::ptrdiff_t>(half - width));
  const std::span<double> polygon{image_.data(), half}, halves{image_.data() + half, 2 * half};
  residual_.resize(2 * half);
  const auto find_residual = [&] {
    split_polygon(p, width_, polygon, s, halves.first(half), halves.last(half));
    for (int k = 0; k <= p; ++k)
      for (std::size_t c = 0; c < width; ++c) {
        const std::size_t i = index(k) * width + c;
        residual_[i] = piece_row(first, k)[c] - halves[i];
        residual_[half + i] = piece_row(second, k)[c] - halves[half + i];
      }
  };
  if (unknowns > 0) {
    LeastSquares& squares = scratch();
    const int rows = 2 * (p + 1);
    const std::span<double> matrix = squares.start(rows, unknowns);
    std::array<double, max_degree + 1> basis;
    for (int k = 0; k <= p; ++k) {
      bernstein_basis(k, s, basis);
      for (int i = 1; i <= std::min(k, unknowns); ++i) matrix[index((i - 1) * rows + k)] = basis[index(i)];
      bernstein_basis(p - k, s, basis);
      for (int i = std::max(k, 1); i <= unknowns; ++i) matrix[index((i - 1) * rows + p + 1 + k)] = basis[index(i - k)];
    }
    if (!squares.factor()) return false;
    right_.resize(index(rows));
    for (int refinement = 0; refinement < 2; ++refinement) {
      find_residual();
      for (std::size_t c = 0; c < width; ++c) {
        for (std::size_t k = 0; k < index(rows); ++k) right_[k] = residual_[k * width + c];
        squares.solve(right_);
        for (std::size_t i = 0; i < index(unknowns); ++i) polygon[(i + 1) * width + c] += right_[i];
      }
    }
  }
  find_residual();
  for (std::size_t k = 0; k < residual_.size(); ++k)
    if (!(std::abs(residual_[k]) <= tolerances_[k % width])) return false;
  for (int k = 0; k <= p; ++k) {
    const auto to = layout.edge_index(e, k) * width_;
    std::copy_n(polygon.begin() + k * width_, width_, reduced_.begin() + to);
    std::copy_n(polygon.begin() + k * width_, width_, parent_.begin() + to);
    complete(std::span<double>(parent_).subspan(index(to), width));
  }
  return true;
}

void ParentRecovery::place_edge(int e, std::span<const Point> points) {
  const NetLayout& layout = NetLayout::of(degree_);
  for (int k = 1; k < degree_; ++k) {
    const std::size_t to = index(layout.edge_index(e, k) * width_);
    const Point& place = points[index(k)];
    reduced_[to] = place.x - origin_.x;
    reduced_[to + 1] = place.y - origin_.y;
    parent_[to] = place.x;
    parent_[to + 1] = place.y;
    for (std::size_t c = 0; c < linear_.size(); ++c)
      parent_[to + 2 + c] = reduced_[to + 2 + c] + patch_.evaluate(linear_[c], place);
  }
}

/// Sets residual_ to the pieces less the sub-nets of the parent; true if all of it is within the tolerances.
bool ParentRecovery::subtract_pieces(std::span<const std::array<Barycentric, 3>> corners) {
  const std::size_t each = index(n_ * width_);
  residual_.resize(pieces_.size());
  bool is_small = true;
  for (std::size_t piece = 0; piece < corners.size(); ++piece) {
    const auto& [a, b, c] = corners[piece];
    const std::span<double> rest = std::span<double>(residual_).subspan(piece * each, each);
    sub_net(degree_, width_, reduced_, a, b, c, rest);
    for (std::size_t k = 0; k < each; ++k) {
      rest[k] = pieces_[piece * each + k] - rest[k];
      is_small = is_small && std::abs(rest[k]) <= tolerances_[k % index(width_)];
    }
  }
  return is_small;
}

bool ParentRecovery::find_inner(std::span<const std::array<Barycentric, 3>> corners) {
  const int first = 3 * degree_, unknowns = n_ - first;
  if (unknowns == 0) return subtract_pieces(corners);
  // The subdivision as a matrix, whose columns are the sub-nets of unit nets: one inner point is 1, the rest are 0.
  const int rows = n_ * static_cast<int>(corners.size());
  LeastSquares& squares = scratch();
  const std::span<double> matrix = squares.start(rows, unknowns);
  for (int block = 0; block < unknowns; block += unit_block) {
    const int count = std::min(unit_block, unknowns - block);
    units_.assign(index(n_ * count), 0.0);
    for (int m = 0; m < count; ++m) units_[index((first + block + m) * count + m)] = 1;
    image_.resize(units_.size());
    for (std::size_t piece = 0; piece < corners.size(); ++piece) {
      const auto& [a, b, c] = corners[piece];
      sub_net(degree_, count, units_, a, b, c, image_);
      for (int m = 0; m < count; ++m)
        for (int k = 0; k < n_; ++k)
          matrix[index((block + m) * rows + static_cast<int>(piece) * n_ + k)] = image_[index(k * count + m)];
    }
  }
  if (!squares.factor()) return false;
  right_.resize(index(rows));
  for (int refinement = 0; refinement < 2; ++refinement) {
    subtract_pieces(corners);
    for (int c = 0; c < width_; ++c) {
      for (int k = 0; k < rows; ++k) right_[index(k)] = residual_[index(k * width_ + c)];
      squares.solve(right_);
      for (int m = 0; m < unknowns; ++m) reduced(first + m)[c] += right_[index(m)];
    }
  }
  for (int k = first; k < n_; ++k) {
    const auto row = std::span<double>(parent_).subspan(index(k * width_), index(width_));
    std::copy_n(reduced(k), width_, row.begin());
    complete(row);
  }
  return subtract_pieces(corners);
}

}  // namespace pliant
