// formats/document/boundary_document.h: the boundary as a member of other documents.
#pragma once
#include "formats/document/document_reader.h"
#include "formats/document/document_writer.h"
#include "pliant/boundary/boundary_complex.h"

namespace pliant {

/// Reads the boundary's object where it stands. Without `alone`, `format` and `version` may be missing.
BoundaryComplex read_boundary_object(DocumentReader& in, bool alone);
void write_boundary_object(DocumentWriter& out, const BoundaryComplex& boundary, bool alone);

/// Checks a `format` or `version` member where it stands.
void read_format(DocumentReader& in, std::string_view format);
void read_version(DocumentReader& in);

}  // namespace pliant
