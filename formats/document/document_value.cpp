// formats/document/document_value.cpp: JSON values read by the strict reader and written in the form of all documents.
#include "formats/document/document_value.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "formats/document/mesh_document.h"
#include "formats/document/read_json.h"
#include "formats/document/write_json.h"

namespace pliant {

class DocumentValue {
 public:
  explicit DocumentValue(Json value) : json(std::move(value)) {}
  Json json;
};

namespace {

/// Any value; the reader limits how deep it is nested, and refuses names that come twice.
Json read_any(JsonReader& in) {
  switch (in.peek()) {
    case '{': {
      Json object = Json::object();
      auto& members = object.get_ref<Json::object_t&>();
      in.object([&](std::string_view name) {
        Json value = read_any(in);
        // As a plain list: insertion by name compares the name with all others.
        members.Container::emplace_back(std::string(name), std::move(value));
        return true;
      });
      return object;
    }
    case '[': {
      Json array = Json::array();
      in.array([&] { array.push_back(read_any(in)); });
      return array;
    }
    case '"':
      return in.string();
    case 't':
    case 'f':
      return in.boolean();
    default:
      if (in.null()) return nullptr;
      return std::visit([](const auto number) { return Json(number); }, in.any_number());
  }
}

}  // namespace

std::shared_ptr<const DocumentValue> to_document(Json value) {
  return std::make_shared<const DocumentValue>(std::move(value));
}

const Json& to_json(const DocumentValue& value) { return value.json; }

std::shared_ptr<const DocumentValue> JsonReader::value() { return to_document(read_any(*this)); }

void write_members(JsonWriter& out, const Json& object) {
  for (const auto& [name, member] : object.get_ref<const Json::object_t&>()) write_json(out.name(name), member);
}

// Recursion as deep as the value is nested, which the reader limits.
void write_json(JsonWriter& out, const Json& value) {
  switch (value.type()) {
    case Json::value_t::object:
      out.begin_object();
      write_members(out, value);
      out.end_object();
      break;
    case Json::value_t::array:
      out.begin_array();
      for (const Json& element : value) write_json(out, element);
      out.end_array();
      break;
    case Json::value_t::string:
      out.value(value.get_ref<const std::string&>());
      break;
    case Json::value_t::boolean:
      out.value(value.get<bool>());
      break;
    case Json::value_t::number_integer:
      out.value(value.get<std::int64_t>());
      break;
    case Json::value_t::number_unsigned:
      out.raw(std::to_string(value.get<std::uint64_t>()));
      break;
    case Json::value_t::number_float:
      out.value(value.get<double>());
      break;
    default:
      out.null();
  }
}

JsonWriter& JsonWriter::value(const DocumentValue& value) { return write_json(*this, value.json), *this; }

void append_json(std::string& out, const Json& value) {
  JsonWriter writer(out);
  write_json(writer, value);
}

std::shared_ptr<const DocumentValue> read_value(std::string_view json) {
  JsonReader in(json);
  auto value = in.value();
  in.finish();
  return value;
}

std::string write_value(const DocumentValue& value) {
  std::string text;
  append_json(text, value.json);
  return text;
}

Json count_or_number(double value) {
  constexpr double most_count = 1e15;
  if (value == std::floor(value) && std::abs(value) < most_count) return static_cast<std::int64_t>(value);
  return finite_or_null(value);
}

Json finite_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

}  // namespace pliant
