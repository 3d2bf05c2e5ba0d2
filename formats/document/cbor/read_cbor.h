// formats/document/cbor/read_cbor.h: a strict pull reader of CBOR (RFC 8949) whose values have a meaning in JSON.
#pragma once
#include <deque>

#include "formats/document/cbor/cbor_items.h"
#include "formats/document/document_reader.h"

namespace pliant {

/// Reads a document in CBOR. Numbers may be integers and floats of any width, arrays of numbers typed arrays
/// (RFC 8746) or plain ones, lengths definite or not. What has no meaning in JSON is refused: byte strings elsewhere,
/// names that are no text, undefined, numbers that are not finite, and tags, which would be lost.
class CborReader final : public DocumentReader {
 public:
  explicit CborReader(std::string_view bytes) : begin_(bytes.data()), end_(begin_ + bytes.size()), at_(begin_) {}

  Kind kind() override;
  double number() override;
  std::int32_t integer() override;
  bool boolean() override;
  std::string string() override;
  bool null() override;
  void numbers(std::vector<double>& out) override;
  void integers(std::vector<std::int32_t>& out) override;
  void points(std::vector<Point>& out) override;
  void pairs(std::vector<std::array<std::int32_t, 2>>& out) override;
  std::variant<double, std::int64_t, std::uint64_t> any_number() override;
  void finish() override;

 private:
  using Number = std::variant<double, std::int64_t, std::uint64_t>;
  /// A typed array: its tag and the bytes of its numbers; `end` is where reading goes on.
  struct Typed {
    int tag = 0;
    std::string_view bytes;
    const char* end = nullptr;
    std::size_t count() const { return bytes.size() / typed_width(static_cast<std::uint64_t>(tag)); }
  };

  void open_object(Container& object) override;
  bool next_member(Container& object, Names& names, std::string_view& name) override;
  void open_array(Container& array) override;
  bool next_element(Container& array) override;
  DocumentPlace place_of(const std::string& pointer) const override;

  /// The head that stands here; it is not passed.
  CborHead head(const char* what) const;
  /// Passes the tags that mean nothing for the value, and refuses others but those of typed arrays, which stay.
  void pass_tags();
  bool is_at_typed() const;
  Typed take_typed(const char* what);
  bool is_at_end_of(Container& container);
  void require_depth() const;
  std::string_view text(const char* what);
  Number take_number(const char* what);
  Number element_of_typed();
  std::int32_t to_integer(const Number& number, const char* where) const;
  template <class Out>
  void numbers_into(std::vector<Out>& out, const char* what, const char* odd);
  template <class Out>
  void typed_into(const Typed& array, std::vector<Out>& out);
  template <class Out>
  void add(std::vector<Out>& out, bool& odd, const char* what);
  void check_even(std::size_t count, const char* odd) const;

  [[noreturn]] void fault(const std::string& text) const { fail_at(at_, text); }
  [[noreturn]] void fail_at(const char* where, const std::string& text) const;
  std::string found() const;

  const char* begin_;
  const char* end_;
  const char* at_;
  int element_ = 0;                  // the tag of the typed array whose number stands here
  const char* joined_at_ = nullptr;  // where the chunks stand of the typed array that is read from a copy
  std::deque<std::string> copies_;   // of what stands in chunks
};

}  // namespace pliant
