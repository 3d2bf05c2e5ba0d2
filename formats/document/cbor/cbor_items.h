// formats/document/cbor/cbor_items.h: heads of CBOR items (RFC 8949), typed arrays (RFC 8746), and where items end.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace pliant {

/// The first bytes of an item: what it is, and its argument.
struct CborHead {
  int major = 0;            // 0 unsigned, 1 negative, 2 bytes, 3 text, 4 array, 5 map, 6 tag, 7 simple and float
  int info = 0;             // the low five bits
  std::uint64_t value = 0;  // argument
  std::size_t size = 1;     // bytes of the head
  bool is_indefinite() const { return info == 31; }
  bool is_break() const { return major == 7 && info == 31; }
  bool is_wrong() const { return info > 27 && (info < 31 || major < 2 || major == 6); }
};

/// The head that the bytes begin with; none if they end before it does.
std::optional<CborHead> read_cbor_head(std::string_view bytes);

inline constexpr std::uint64_t self_described_cbor = 55799, homogeneous_array = 41;

/// The types of numbers in typed arrays, by tag.
inline bool is_typed_array(std::uint64_t tag) { return tag >= 64 && tag <= 87; }
/// Bytes per number.
inline std::size_t typed_width(std::uint64_t tag) {
  return (tag & 16) != 0 ? std::size_t{2} << (tag & 3) : std::size_t{1} << (tag & 3);
}

/// Finds where an item ends, fed piece by piece. An item that is no CBOR ends where that shows.
class CborItemEnd {
 public:
  /// Passes what it can of [first, last): returns where to go on, which is before `last` if a head is not whole yet.
  const char* scan(const char* first, const char* last);
  bool is_done() const { return is_done_; }
  /// Bytes of a string that are still to come; they need not be shown to `scan`.
  std::uint64_t left_of_string() const { return skip_; }
  void pass_string();  ///< they have been passed

 private:
  static constexpr std::uint64_t no_end = ~std::uint64_t{0};
  void end_item();
  void take(const CborHead& head);
  std::vector<std::uint64_t> left_;  // items to come in each container; no_end: until a break
  std::uint64_t skip_ = 0;
  bool is_done_ = false;
};

/// The byte at which the value starts that `pointer` names, or the innermost one around it that is there. What is left
/// of the pointer comes back in it.
std::size_t find_cbor_value(std::string_view cbor, std::string_view& pointer);

}  // namespace pliant
