// formats/problem/diffuse_json.h: the section `diffuse` of a problem document, read and written.
#pragma once
#include "formats/document/document_reader.h"
#include "formats/document/document_writer.h"
#include "formats/problem/problem_document.h"

namespace pliant {

/// The value now being read as the section.   Throws DocumentError
DiffuseSection read_diffuse(DocumentReader& in);
void write_diffuse(DocumentWriter& out, const DiffuseSection& section);

}  // namespace pliant
