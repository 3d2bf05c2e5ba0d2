// formats/document/document_value.cpp: JSON values read by the strict reader and written in the form of all documents.
#include "formats/document/document_value.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <type_traits>
#include <utility>
#include <vector>

#include "formats/document/document_reader.h"
#include "formats/document/mesh_document.h"
#include "formats/document/write_json.h"

namespace pliant {

class DocumentValue {
 public:
  explicit DocumentValue(Json value) : json(std::move(value)) {}
  Json json;
};

namespace {

/// Any value; the reader limits how deep it is nested, and refuses names that come twice.
Json read_any(DocumentReader& in) {
  switch (in.kind()) {
    case DocumentReader::Kind::object: {
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
    case DocumentReader::Kind::array: {
      Json array = Json::array();
      in.array([&] { array.push_back(read_any(in)); });
      return array;
    }
    case DocumentReader::Kind::string:
      return in.string();
    case DocumentReader::Kind::boolean:
      return in.boolean();
    case DocumentReader::Kind::null:
      in.null();
      return nullptr;
    default:
      return std::visit([](const auto number) { return Json(number); }, in.any_number());
  }
}

}  // namespace

std::shared_ptr<const DocumentValue> to_document(Json value) {
  return std::make_shared<const DocumentValue>(std::move(value));
}

const Json& to_json(const DocumentValue& value) { return value.json; }

std::shared_ptr<const DocumentValue> DocumentReader::value() { return to_document(read_any(*this)); }

namespace {

/// All elements as numbers of one type, if the array is long and they are: doubles, or integers of 32 bits.
template <class Number>
std::vector<Number> numbers_of(const Json& array) {
  constexpr std::size_t is_long = 16;
  std::vector<Number> numbers;
  if (array.size() < is_long) return numbers;
  for (const Json& element : array) {
    if constexpr (std::is_same_v<Number, double>) {
      if (!element.is_number_float()) return {};
    } else {
      if (!element.is_number_integer()) return {};
      // Json compares the two kinds of integers as signed ones.
      const bool fits = element.is_number_unsigned() ? std::in_range<Number>(element.get<std::uint64_t>())
                                                     : std::in_range<Number>(element.get<std::int64_t>());
      if (!fits) return {};
    }
    numbers.push_back(element.get<Number>());
  }
  return numbers;
}

}  // namespace

void write_members(DocumentWriter& out, const Json& object) {
  for (const auto& [name, member] : object.get_ref<const Json::object_t&>()) write_json(out.name(name), member);
}

// Recursion as deep as the value is nested, which the reader limits.
void write_json(DocumentWriter& out, const Json& value) {
  switch (value.type()) {
    case Json::value_t::object:
      out.begin_object();
      write_members(out, value);
      out.end_object();
      break;
    case Json::value_t::array:
      if (const auto doubles = numbers_of<double>(value); !doubles.empty()) {
        out.numbers(doubles);
      } else if (const auto integers = numbers_of<std::int32_t>(value); !integers.empty()) {
        out.integers(integers);
      } else {
        out.begin_array();
        for (const Json& element : value) write_json(out, element);
        out.end_array();
      }
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
      out.value(value.get<std::uint64_t>());
      break;
    case Json::value_t::number_float:
      out.value(value.get<double>());
      break;
    default:
      out.null();
  }
}

DocumentWriter& DocumentWriter::value(const DocumentValue& value) { return write_json(*this, value.json), *this; }

void append_json(std::string& out, const Json& value) {
  JsonWriter writer(out);
  write_json(writer, value);
}

std::shared_ptr<const DocumentValue> read_value(std::string_view bytes) {
  const auto in = reader_of(bytes);
  auto value = in->value();
  in->finish();
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
