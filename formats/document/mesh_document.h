// formats/document/mesh_document.h: the mesh and boundary documents, as JSON and JSON Lines (formats/mesh.md).
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "formats/document/document_place.h"
#include "pliant/boundary/boundary_complex.h"
#include "pliant/boundary/fault.h"
#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// Reads one mesh document. Checks the grammar of all of it, the types, that numbers are finite, and check_arrays.
/// Throws      InputError with a JSON pointer (or line and column of the text where it is no JSON)
/// Ensures     `doubts` holds the unknown members that look like missing ones, each kind once, few kinds
MeshData read_mesh(std::string_view json, std::vector<Doubt>* doubts = nullptr);
BoundaryComplex read_boundary(std::string_view json, std::vector<Doubt>* doubts = nullptr);

/// Appends the document, one line with its newline, numbers in shortest round-trip form. Byte-exact: what was written
/// and is read and written again is the same.
void write_mesh(const MeshData& mesh, std::string& out);
void write_boundary(const BoundaryComplex& boundary, std::string& out);

/// A value for an unknown member from its JSON, and the JSON of such a value.
/// Throws      InputError as `read_mesh` does
std::shared_ptr<const DocumentValue> read_value(std::string_view json);
std::string write_value(const DocumentValue& value);

}  // namespace pliant
