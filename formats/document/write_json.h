// formats/document/write_json.h: JSON on one line, numbers in the shortest form that reads back to the same double.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "formats/document/document_writer.h"

namespace pliant {

/// Shortest round-trip form; minus zero as -0.0.
/// Throws      std::domain_error where the number is not finite: JSON has no such numbers
void append_number(std::string& out, double value);
void append_integer(std::string& out, std::int64_t value);
/// In quotes, escaped where JSON demands it; the bytes must be UTF-8.
void append_string(std::string& out, std::string_view text);

/// Writes objects and arrays with their commas.
class JsonWriter final : public DocumentWriter {
 public:
  using DocumentWriter::DocumentWriter;
  using DocumentWriter::value;
  JsonWriter& begin_object() override { return open('{'); }
  JsonWriter& end_object() override { return close('}'); }
  JsonWriter& begin_array() override { return open('['); }
  JsonWriter& end_array() override { return close(']'); }
  JsonWriter& name(std::string_view name) override {
    comma();
    append_string(out_, name);
    out_ += ':';
    fresh_ = true;
    return *this;
  }
  JsonWriter& value(double number) override { return comma(), append_number(out_, number), *this; }
  JsonWriter& value(std::int64_t number) override { return comma(), append_integer(out_, number), *this; }
  JsonWriter& value(std::uint64_t number) override { return raw(std::to_string(number)); }
  JsonWriter& value(bool truth) override { return raw(truth ? "true" : "false"); }
  JsonWriter& value(std::string_view text) override { return comma(), append_string(out_, text), *this; }
  JsonWriter& null() override { return raw("null"); }
  JsonWriter& numbers(std::span<const double> values) override;
  JsonWriter& integers(std::span<const std::int32_t> values) override;
  JsonWriter& points(std::span<const Point> points) override;
  void end() override;
  JsonWriter& raw(std::string_view json) {
    comma();
    out_ += json;
    return *this;
  }

 private:
  template <class Append>
  JsonWriter& list(std::size_t count, Append append);
  JsonWriter& open(char bracket) {
    comma();
    out_ += bracket;
    fresh_ = true;
    return *this;
  }
  JsonWriter& close(char bracket) {
    out_ += bracket;
    fresh_ = false;
    relieve();
    return *this;
  }
  void comma() {
    if (!fresh_) out_ += ',';
    fresh_ = false;
  }
  bool fresh_ = true;  // no comma before the next value
};

}  // namespace pliant
