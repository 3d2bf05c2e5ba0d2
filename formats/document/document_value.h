// formats/document/document_value.h: JSON values that are no bulk arrays, as nlohmann-json has them (not installed).
#pragma once
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "pliant/boundary/extra_members.h"

namespace pliant {
class DocumentWriter;

/// A JSON value whose objects keep the order of their members. Whoever makes or reads one includes <nlohmann/json.hpp>.
using Json = nlohmann::ordered_json;

/// The value as a document carries it, and what a document carries as a value.
std::shared_ptr<const DocumentValue> to_document(Json value);
const Json& to_json(const DocumentValue& value);

/// Appends the value without white space. Numbers and strings have the form that `append_number` and `append_string`
/// give them in every document, so a double that is a whole number comes without a fraction.
///
/// Throws      std::domain_error where a number is not finite
void append_json(std::string& out, const Json& value);
void write_json(DocumentWriter& out, const Json& value);
/// Writes the members of an object into the object that the writer is in.
void write_members(DocumentWriter& out, const Json& object);

/// The number, or null where it is not finite.
Json finite_or_null(double value);
/// The same, and whole numbers below 1e15 without a fraction or an exponent, as counts are written.
Json count_or_number(double value);

}  // namespace pliant
