// formats/document/document_reader.h: a strict pull reader of documents, whatever their form: JSON or CBOR.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <variant>
#include <vector>

#include "formats/document/document_place.h"
#include "pliant/boundary/extra_members.h"
#include "pliant/boundary/fault.h"
#include "pliant/geometry/point.h"

namespace pliant {

/// Bad input with its place in the document too, counted from the document's start.
class DocumentError : public InputError {
 public:
  DocumentError(std::string pointer, const std::string& text, const DocumentPlace& place)
      : InputError(std::move(pointer), with_offset(text, place)), text_(text), place_(place) {}
  const std::string& text() const { return text_; }  ///< without the place
  const DocumentPlace& place() const { return place_; }
  long line() const { return place_.line; }
  long column() const { return place_.column; }

 private:
  std::string text_;
  DocumentPlace place_;
};

/// One pass over one document, from the first byte to the last: the caller asks for what must stand next, and every
/// byte is checked, also in members that nobody asked for (UTF-8, numbers, names that come twice). Nothing is allocated
/// that the document does not hold. The document's bytes must outlive the reader.
class DocumentReader {
 public:
  /// What a value is; `nothing` where there is none.
  enum class Kind { object, array, string, number, boolean, null, nothing };

  DocumentReader() = default;
  virtual ~DocumentReader() = default;
  DocumentReader(const DocumentReader&) = delete;
  DocumentReader& operator=(const DocumentReader&) = delete;

  /// Calls member(name) for each; it must read the value, or return false: then the value goes into `extra`.
  template <class F>
  void object(ExtraMembers& extra, F member);
  /// The same where other members are not allowed.
  template <class F>
  void object(F member);
  /// Calls element() for each.
  template <class F>
  void array(F element);

  /// What the next value is; it is not read.
  virtual Kind kind() = 0;
  virtual double number() = 0;
  virtual std::int32_t integer() = 0;  ///< within 32 bits; 2.0 is an integer as in JSON Schema
  virtual bool boolean() = 0;
  virtual std::string string() = 0;
  virtual bool null() = 0;  ///< reads null if it stands there
  /// An array of finite numbers; of integers; of x and y in turn.
  virtual void numbers(std::vector<double>& out) = 0;
  virtual void integers(std::vector<std::int32_t>& out) = 0;
  virtual void points(std::vector<Point>& out) = 0;
  virtual void pairs(std::vector<std::array<std::int32_t, 2>>& out) = 0;
  /// A number that nobody asked for: exactly, if it is an integer of 64 bits; the nearest double otherwise.
  virtual std::variant<double, std::int64_t, std::uint64_t> any_number() = 0;
  /// Requires that nothing follows.
  virtual void finish() = 0;
  /// Any value.
  std::shared_ptr<const DocumentValue> value();

  /// Throws a DocumentError at the value now being read, or below it ("/knots/7").
  [[noreturn]] void fail(const std::string& text, const std::string& below = {}) const;
  /// Notes that this member of the value last read is probably not what was meant.
  void doubt(std::string_view member, const std::string& text);
  const std::vector<Doubt>& doubts() const { return doubts_; }
  /// The long arrays of numbers that were read, in their order.
  const std::vector<NumberArray>& number_arrays() const { return arrays_; }

 protected:
  struct Step {
    std::string_view name;  // a member, if index is negative
    long index;
  };
  /// The names of an object, to find those that come twice.
  struct Names {
    bool add(std::string_view name);
    std::vector<std::string_view> few;
    std::unordered_set<std::string_view> many;
  };
  /// An object or array that is being read.
  struct Container {
    bool is_first = true;        // JSON: no comma stands before the next entry
    bool is_indefinite = false;  // CBOR: a break ends it
    std::uint64_t left = 0;      // CBOR: entries to come, if their number is known
    int element = 0;             // CBOR: the tag of a typed array, 0 for another one
    const char* end = nullptr;   // CBOR: where reading goes on behind a typed array
  };
  static constexpr int max_depth = 64;

  virtual void open_object(Container& object) = 0;
  virtual bool next_member(Container& object, Names& names, std::string_view& name) = 0;
  virtual void open_array(Container& array) = 0;
  virtual bool next_element(Container& array) = 0;
  /// The place of the value that `pointer` names.
  virtual DocumentPlace place_of(const std::string& pointer) const = 0;

  std::string pointer() const;  ///< of the value now being read

  std::vector<Step> path_;
  std::vector<NumberArray> arrays_;

 private:
  std::vector<Doubt> doubts_;
};

/// The reader for the form of these bytes.
std::unique_ptr<DocumentReader> reader_of(std::string_view document);

template <class F>
void DocumentReader::object(ExtraMembers& extra, F member) {
  Container object;
  open_object(object);
  Names names;
  std::string_view name;
  while (next_member(object, names, name)) {
    path_.push_back({name, -1});
    if (!member(name)) extra.emplace_back(std::string(name), value());
    path_.pop_back();
  }
}

template <class F>
void DocumentReader::object(F member) {
  ExtraMembers none_kept;
  object(none_kept, [&](std::string_view name) {
    if (!member(name)) fail("is not a member of this object, which cannot carry others");
    return true;
  });
}

template <class F>
void DocumentReader::array(F element) {
  Container array;
  open_array(array);
  path_.push_back({{}, 0});
  while (next_element(array)) {
    element();
    ++path_.back().index;
  }
  path_.pop_back();
}

}  // namespace pliant
