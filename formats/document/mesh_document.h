// formats/document/mesh_document.h: the mesh and boundary documents, as JSON and as CBOR, one or a series
// (formats/mesh.md).
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "formats/document/document_form.h"
#include "formats/document/document_place.h"
#include "pliant/boundary/boundary_complex.h"
#include "pliant/boundary/fault.h"
#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// What a reader noted beside the document.
struct ReaderNotes {
  std::vector<Doubt> doubts;        ///< unknown members that look like missing ones, each kind once, few kinds
  std::vector<NumberArray> arrays;  ///< for a DocumentOutline
};

/// Reads one mesh document, in JSON or CBOR. Checks the grammar of all of it, the types, that numbers are finite, and
/// check_arrays.
/// Throws      InputError with a JSON pointer (a DocumentError with its place where the document is no JSON or CBOR)
MeshData read_mesh(std::string_view document, ReaderNotes* notes = nullptr);
BoundaryComplex read_boundary(std::string_view document, ReaderNotes* notes = nullptr);

/// Appends the document; in JSON one line with its newline, numbers in shortest round-trip form. Byte-exact: what was
/// written and is read and written again is the same, also by way of the other form.
void write_mesh(const MeshData& mesh, std::string& out, DocumentForm form = DocumentForm::json);
void write_boundary(const BoundaryComplex& boundary, std::string& out, DocumentForm form = DocumentForm::json);
/// The same in pieces, none much larger than an array of the mesh; the sink is called only if all numbers are finite.
/// Throws      std::domain_error otherwise
void write_mesh(const MeshData& mesh, DocumentForm form, const DocumentSink& sink);

/// A value for an unknown member from its JSON or CBOR, and the JSON of such a value.
/// Throws      InputError as `read_mesh` does
std::shared_ptr<const DocumentValue> read_value(std::string_view bytes);
std::string write_value(const DocumentValue& value);

}  // namespace pliant
