// formats/document/write_json.h: JSON on one line, numbers in the shortest form that reads back to the same double.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "pliant/boundary/extra_members.h"

namespace pliant {

/// Shortest round-trip form; minus zero as -0.0.
/// Throws      std::domain_error where the number is not finite: JSON has no such numbers
void append_number(std::string& out, double value);
void append_integer(std::string& out, std::int64_t value);
/// In quotes, escaped where JSON demands it; the bytes must be UTF-8.
void append_string(std::string& out, std::string_view text);

/// Writes objects and arrays with their commas.
class JsonWriter {
 public:
  explicit JsonWriter(std::string& out) : out_(out) {}
  JsonWriter& begin_object() { return open('{'); }
  JsonWriter& end_object() { return close('}'); }
  JsonWriter& begin_array() { return open('['); }
  JsonWriter& end_array() { return close(']'); }
  JsonWriter& name(std::string_view name) {
    comma();
    append_string(out_, name);
    out_ += ':';
    fresh_ = true;
    return *this;
  }
  JsonWriter& value(double number) { return comma(), append_number(out_, number), *this; }
  JsonWriter& value(std::int64_t number) { return comma(), append_integer(out_, number), *this; }
  JsonWriter& value(int number) { return value(static_cast<std::int64_t>(number)); }
  JsonWriter& value(bool truth) { return raw(truth ? "true" : "false"); }
  JsonWriter& value(std::string_view text) { return comma(), append_string(out_, text), *this; }
  JsonWriter& value(const char* text) { return value(std::string_view(text)); }
  JsonWriter& value(const DocumentValue& value);
  JsonWriter& null() { return raw("null"); }
  JsonWriter& raw(std::string_view json) {
    comma();
    out_ += json;
    return *this;
  }
  /// Members that Pliant does not know.
  void members(const ExtraMembers& extra) {
    for (const auto& [key, carried] : extra) name(key).value(*carried);
  }

 private:
  JsonWriter& open(char bracket) {
    comma();
    out_ += bracket;
    fresh_ = true;
    return *this;
  }
  JsonWriter& close(char bracket) {
    out_ += bracket;
    fresh_ = false;
    return *this;
  }
  void comma() {
    if (!fresh_) out_ += ',';
    fresh_ = false;
  }
  std::string& out_;
  bool fresh_ = true;  // no comma before the next value
};

}  // namespace pliant
