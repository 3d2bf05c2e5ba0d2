// formats/document/document_writer.h: writes documents, whatever their form: JSON or CBOR.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "formats/document/document_form.h"
#include "pliant/boundary/extra_members.h"
#include "pliant/geometry/point.h"

namespace pliant {

/// Throws      std::domain_error where a number is not finite: no form of documents has such numbers
inline void require_finite(std::span<const double> values) {
  if (!std::ranges::all_of(values, [](double value) { return std::isfinite(value); }))
    throw std::domain_error("a number of the result is not finite");
}

/// Appends the parts of a document to a string; with a sink, what has gathered there goes to it from time to time.
/// Numbers must be finite, strings UTF-8.
class DocumentWriter {
 public:
  explicit DocumentWriter(std::string& out, const DocumentSink* sink = nullptr) : out_(out), sink_(sink) {}
  virtual ~DocumentWriter() = default;
  DocumentWriter(const DocumentWriter&) = delete;
  DocumentWriter& operator=(const DocumentWriter&) = delete;

  virtual DocumentWriter& begin_object() = 0;
  virtual DocumentWriter& end_object() = 0;
  virtual DocumentWriter& begin_array() = 0;
  virtual DocumentWriter& end_array() = 0;
  virtual DocumentWriter& name(std::string_view name) = 0;
  virtual DocumentWriter& value(double number) = 0;
  virtual DocumentWriter& value(std::int64_t number) = 0;
  virtual DocumentWriter& value(std::uint64_t number) = 0;
  virtual DocumentWriter& value(bool truth) = 0;
  virtual DocumentWriter& value(std::string_view text) = 0;
  virtual DocumentWriter& null() = 0;
  /// Arrays of numbers.
  virtual DocumentWriter& numbers(std::span<const double> values) = 0;
  virtual DocumentWriter& integers(std::span<const std::int32_t> values) = 0;
  virtual DocumentWriter& points(std::span<const Point> points) = 0;  ///< x and y in turn
  /// Ends the document.
  virtual void end() = 0;

  DocumentWriter& value(int number) { return value(static_cast<std::int64_t>(number)); }
  DocumentWriter& value(const char* text) { return value(std::string_view(text)); }
  DocumentWriter& value(const DocumentValue& value);
  DocumentWriter& pairs(std::span<const std::array<std::int32_t, 2>> pairs) {
    return integers({pairs.empty() ? nullptr : pairs.front().data(), 2 * pairs.size()});
  }
  /// Members that Pliant does not know.
  void members(const ExtraMembers& extra) {
    for (const auto& [key, carried] : extra) name(key).value(*carried);
  }

 protected:
  /// Gives the sink what has gathered, if it is much.
  void relieve() {
    constexpr std::size_t much = 1 << 18;
    if (sink_ != nullptr && out_.size() >= much) flush();
  }
  void flush() {
    (*sink_)(out_);
    out_.clear();
  }

  std::string& out_;
  const DocumentSink* sink_;
};

}  // namespace pliant
