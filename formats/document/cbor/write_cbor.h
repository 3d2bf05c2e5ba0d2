// formats/document/cbor/write_cbor.h: CBOR (RFC 8949), with arrays of numbers as typed arrays (RFC 8746).
#pragma once
#include "formats/document/document_writer.h"

namespace pliant {

/// Objects and arrays are of indefinite length, strings of definite length; a double has eight bytes.
class CborWriter final : public DocumentWriter {
 public:
  using DocumentWriter::DocumentWriter;
  using DocumentWriter::value;
  CborWriter& begin_object() override { return put('\xBF'); }
  CborWriter& end_object() override { return put('\xFF'); }
  CborWriter& begin_array() override { return put('\x9F'); }
  CborWriter& end_array() override { return put('\xFF'); }
  CborWriter& name(std::string_view name) override { return value(name); }
  CborWriter& value(double number) override;
  CborWriter& value(std::int64_t number) override;
  CborWriter& value(std::uint64_t number) override;
  CborWriter& value(bool truth) override { return put(truth ? '\xF5' : '\xF4'); }
  CborWriter& value(std::string_view text) override;
  CborWriter& null() override { return put('\xF6'); }
  CborWriter& numbers(std::span<const double> values) override;
  CborWriter& integers(std::span<const std::int32_t> values) override;
  CborWriter& points(std::span<const Point> points) override;
  void end() override;

 private:
  CborWriter& put(char byte) {
    out_ += byte;
    relieve();
    return *this;
  }
  void head(int major, std::uint64_t value);
  /// A typed array of the numbers in these bytes, each of `width` bytes in the host's order.
  CborWriter& typed(int tag, const void* bytes, std::size_t size, std::size_t width);
};

}  // namespace pliant
