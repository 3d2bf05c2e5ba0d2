// formats/document/cbor/read_cbor_numbers.cpp: arrays of numbers, which a typed array gives in one copy.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "formats/document/cbor/cbor_numbers.h"
#include "formats/document/cbor/read_cbor.h"

namespace pliant {
namespace {

/// What an array of the mesh holds: its numbers, how many an entry has, and how it is made of them.
template <class Out>
struct Entry;
template <>
struct Entry<double> {
  using Scalar = double;
  static constexpr std::size_t scalars = 1;
  static void set(double& out, std::size_t, double value) { out = value; }
};
template <>
struct Entry<std::int32_t> {
  using Scalar = std::int32_t;
  static constexpr std::size_t scalars = 1;
  static void set(std::int32_t& out, std::size_t, std::int32_t value) { out = value; }
};
template <>
struct Entry<Point> {
  using Scalar = double;
  static constexpr std::size_t scalars = 2;
  static void set(Point& out, std::size_t k, double value) { (k == 0 ? out.x : out.y) = value; }
};
template <>
struct Entry<std::array<std::int32_t, 2>> {
  using Scalar = std::int32_t;
  static constexpr std::size_t scalars = 2;
  static void set(std::array<std::int32_t, 2>& out, std::size_t k, std::int32_t value) { out[k] = value; }
};

/// Entries made of the numbers of a typed array, for std::vector, which then makes each once.
template <class Numbers, class Out>
class EntryIterator {
 public:
  // NOLINTBEGIN(readability-identifier-naming): the names of the standard library
  using iterator_category = std::random_access_iterator_tag;
  using value_type = Out;
  using difference_type = std::ptrdiff_t;
  using pointer = const Out*;
  using reference = Out;
  // NOLINTEND(readability-identifier-naming)
  explicit EntryIterator(const char* at) : at_(at) {}
  Out operator*() const {
    Out out{};
    for (std::size_t k = 0; k < Entry<Out>::scalars; ++k)
      Entry<Out>::set(out, k, static_cast<typename Entry<Out>::Scalar>(Numbers::at(at_ + k * Numbers::width)));
    return out;
  }
  EntryIterator& operator++() { return at_ += width, *this; }
  EntryIterator& operator--() { return at_ -= width, *this; }
  EntryIterator operator++(int) { return EntryIterator(std::exchange(at_, at_ + width)); }
  EntryIterator& operator+=(difference_type n) { return at_ += n * static_cast<difference_type>(width), *this; }
  difference_type operator-(const EntryIterator& other) const {
    return (at_ - other.at_) / static_cast<difference_type>(width);
  }
  bool operator==(const EntryIterator& other) const = default;

 private:
  static constexpr std::size_t width = Numbers::width * Entry<Out>::scalars;
  const char* at_;
};

}  // namespace

void CborReader::check_even(std::size_t count, const char* odd) const {
  if (count % 2 != 0) fail(odd);
}

template <class Out>
void CborReader::typed_into(const Typed& array, std::vector<Out>& out) {
  using Scalar = typename Entry<Out>::Scalar;
  with_typed_numbers(array.tag, [&](auto type) {
    using Numbers = decltype(type);
    const char* const first = array.bytes.data();
    const std::size_t count = array.count();
    bool all_fit = true;  // without a branch: many numbers are looked at at once
    for (std::size_t k = 0; k < count; ++k) all_fit &= fits<Scalar>(Numbers::at(first + k * Numbers::width));
    for (std::size_t k = 0; !all_fit; ++k) {
      const char* const at = first + k * Numbers::width;
      const auto value = Numbers::at(at);
      if (fits<Scalar>(value)) continue;
      path_.push_back({{}, static_cast<long>(k)});
      if constexpr (std::is_same_v<Scalar, double>)
        fail_at(at, "is no finite number");
      else if constexpr (std::is_floating_point_v<decltype(value)>)
        to_integer(static_cast<double>(value), at);
      fail_at(at, "is beyond the integers of 32 bits");
    }
    using Iterator = EntryIterator<Numbers, Out>;
    constexpr std::size_t scalars = Entry<Out>::scalars;
    out.assign(Iterator(first), Iterator(first + count / scalars * scalars * Numbers::width));
  });
}

template <class Out>
void CborReader::add(std::vector<Out>& out, bool& odd, const char* what) {
  using Scalar = typename Entry<Out>::Scalar;
  const char* const start = at_;
  const Number number = take_number(what);
  Scalar value;
  if constexpr (std::is_same_v<Scalar, double>)
    value = std::visit([](auto each) { return static_cast<double>(each); }, number);
  else
    value = to_integer(number, start);
  if (Entry<Out>::scalars == 1 || !odd) out.emplace_back();
  Entry<Out>::set(out.back(), odd ? 1 : 0, value);
  if (Entry<Out>::scalars == 2) odd = !odd;
}

template <class Out>
void CborReader::numbers_into(std::vector<Out>& out, const char* what, const char* odd_text) {
  pass_tags();
  const char* const start = at_;
  NumberArray place{static_cast<std::size_t>(start - begin_), 0};
  if (is_at_typed()) {
    require_depth();
    const Typed array = take_typed(what);
    if (Entry<Out>::scalars == 2) check_even(array.count(), odd_text);
    typed_into(array, out);
    at_ = array.end;
    if (array.bytes.data() >= begin_ && array.bytes.data() + array.bytes.size() <= end_) {
      place.first = static_cast<std::size_t>(array.bytes.data() - begin_);
      place.width = typed_width(static_cast<std::uint64_t>(array.tag));
    }
  } else {
    if (kind() != Kind::array) fault(std::string("should be ") + what + ", " + found());
    bool odd = false;
    out.clear();
    array([&] { add(out, odd, "should be a number"); });
    if (odd) fail(odd_text);
  }
  place.end = static_cast<std::size_t>(at_ - begin_);
  constexpr std::size_t is_long = 256;
  if (place.end - place.begin >= is_long) arrays_.push_back(place);
}

void CborReader::numbers(std::vector<double>& out) { numbers_into(out, "an array of numbers", ""); }

void CborReader::integers(std::vector<std::int32_t>& out) { numbers_into(out, "an array of integers", ""); }

void CborReader::points(std::vector<Point>& out) {
  numbers_into(out, "an array of numbers x0, y0, x1, ...", "has an odd number of entries: its last x has no y");
}

void CborReader::pairs(std::vector<std::array<std::int32_t, 2>>& out) {
  numbers_into(out, "an array of pairs of integers", "has an odd number of entries: they are pairs");
}

}  // namespace pliant
