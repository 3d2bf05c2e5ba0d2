// formats/problem/diffuse_json.h: the section `diffuse` of a problem document as JSON.
#pragma once
#include "formats/document/read_json.h"
#include "formats/document/write_json.h"
#include "formats/problem/problem_document.h"

namespace pliant {

/// The value now being read as the section.   Throws DocumentError
DiffuseSection read_diffuse(JsonReader& in);
void write_diffuse(JsonWriter& out, const DiffuseSection& section);

}  // namespace pliant
