// lib/pliant/geometry/sequence.h: an array in which a value may be inserted or erased anywhere at little cost.
#pragma once
#include <algorithm>
#include <compare>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace pliant {

/// An array of values by index, for curves that gain and lose knots one at a time. A short array is one vector. A long
/// one becomes a list of chunks at its first insertion or erasure, so that a change moves one chunk and not the whole.
///
/// Complexity  reading by index O(1), O(log size) in chunks; insert and erase O(chunk + size / chunk), which is below a
///             microsecond at a million values
template <class T>
class Sequence {
 public:
  Sequence() = default;
  Sequence(std::vector<T> values)
      : flat_(std::move(values)), size_(flat_.size()) {}  // NOLINT: implicit, as a vector is a sequence

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const T& operator[](std::size_t i) const {
    if (chunks_.empty()) return flat_[i];
    const std::size_t c = chunk_of(i);
    return chunks_[c][i - starts_[c]];
  }
  T& operator[](std::size_t i) { return const_cast<T&>(std::as_const(*this)[i]); }
  const T& front() const { return (*this)[0]; }
  const T& back() const { return (*this)[size_ - 1]; }

  void insert(std::size_t i, const T& value) {
    if (!is_chunked()) {
      flat_.insert(flat_.begin() + static_cast<std::ptrdiff_t>(i), value);
    } else {
      const std::size_t c = i == size_ ? chunks_.size() - 1 : chunk_of(i);
      std::vector<T>& chunk = chunks_[c];
      chunk.insert(chunk.begin() + static_cast<std::ptrdiff_t>(i - starts_[c]), value);
      for (std::size_t k = c + 1; k < starts_.size(); ++k) ++starts_[k];
      if (chunk.size() >= 2 * chunk_size) halve(c);
    }
    ++size_;
  }
  void erase(std::size_t i) {
    if (!is_chunked()) {
      flat_.erase(flat_.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      const std::size_t c = chunk_of(i);
      std::vector<T>& chunk = chunks_[c];
      chunk.erase(chunk.begin() + static_cast<std::ptrdiff_t>(i - starts_[c]));
      for (std::size_t k = c + 1; k < starts_.size(); ++k) --starts_[k];
      if (chunk.empty()) {
        chunks_.erase(chunks_.begin() + static_cast<std::ptrdiff_t>(c));
        starts_.erase(starts_.begin() + static_cast<std::ptrdiff_t>(c));
      }
    }
    --size_;
  }

  operator std::vector<T>() const { return to_vector(); }  // NOLINT: implicit, as copies of vectors are
  std::vector<T> to_vector() const {
    if (chunks_.empty()) return flat_;
    std::vector<T> all;
    all.reserve(size_);
    for (const std::vector<T>& chunk : chunks_) all.insert(all.end(), chunk.begin(), chunk.end());
    return all;
  }
  friend bool operator==(const Sequence& a, const Sequence& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  }

  // NOLINTBEGIN(readability-identifier-naming): the standard library's names, which its algorithms ask for
  class const_iterator {
   public:
    using iterator_category = std::random_access_iterator_tag;
    using value_type = T;
    using difference_type = std::ptrdiff_t;
    using pointer = const T*;
    using reference = const T&;
    const_iterator() = default;
    const_iterator(const Sequence* sequence, difference_type i) : sequence_(sequence), i_(i) {}
    reference operator*() const { return (*sequence_)[static_cast<std::size_t>(i_)]; }
    pointer operator->() const { return &**this; }
    reference operator[](difference_type k) const { return *(*this + k); }
    const_iterator& operator+=(difference_type k) { return i_ += k, *this; }
    const_iterator& operator-=(difference_type k) { return i_ -= k, *this; }
    const_iterator& operator++() { return ++i_, *this; }
    const_iterator& operator--() { return --i_, *this; }
    const_iterator operator++(int) { return {sequence_, i_++}; }
    const_iterator operator--(int) { return {sequence_, i_--}; }
    friend const_iterator operator+(const_iterator a, difference_type k) { return a += k; }
    friend const_iterator operator+(difference_type k, const_iterator a) { return a += k; }
    friend const_iterator operator-(const_iterator a, difference_type k) { return a -= k; }
    friend difference_type operator-(const const_iterator& a, const const_iterator& b) { return a.i_ - b.i_; }
    friend bool operator==(const const_iterator& a, const const_iterator& b) { return a.i_ == b.i_; }
    friend auto operator<=>(const const_iterator& a, const const_iterator& b) { return a.i_ <=> b.i_; }

   private:
    const Sequence* sequence_ = nullptr;
    difference_type i_ = 0;
  };
  // NOLINTEND(readability-identifier-naming)
  const_iterator begin() const { return {this, 0}; }
  const_iterator end() const { return {this, static_cast<std::ptrdiff_t>(size_)}; }

 private:
  static constexpr std::size_t chunk_size = 512;     // values in a new chunk; a chunk of twice as many is halved
  static constexpr std::size_t longest_flat = 2048;  // up to here moving all values costs less than finding a chunk

  /// Whether the values are in chunks. Before it answers it puts the values of a long vector into chunks.
  bool is_chunked() {
    if (!chunks_.empty()) return true;
    if (size_ <= longest_flat) return false;
    for (std::size_t i = 0; i < size_; i += chunk_size) {
      const auto from = flat_.begin() + static_cast<std::ptrdiff_t>(i);
      const auto count = static_cast<std::ptrdiff_t>(std::min(chunk_size, size_ - i));
      chunks_.emplace_back(from, from + count);
      starts_.push_back(i);
    }
    flat_ = {};
    return true;
  }
  std::size_t chunk_of(std::size_t i) const {
    return static_cast<std::size_t>(std::upper_bound(starts_.begin(), starts_.end(), i) - starts_.begin()) - 1;
  }
  void halve(std::size_t c) {
    const auto middle = chunks_[c].begin() + static_cast<std::ptrdiff_t>(chunk_size);
    std::vector<T> upper(middle, chunks_[c].end());
    chunks_[c].erase(middle, chunks_[c].end());
    starts_.insert(starts_.begin() + static_cast<std::ptrdiff_t>(c) + 1, starts_[c] + chunk_size);
    chunks_.insert(chunks_.begin() + static_cast<std::ptrdiff_t>(c) + 1, std::move(upper));
  }

  std::vector<T> flat_;                 // all values, as long as there are no chunks
  std::vector<std::vector<T>> chunks_;  // none is empty
  std::vector<std::size_t> starts_;     // the index of each chunk's first value
  std::size_t size_ = 0;
};

}  // namespace pliant
