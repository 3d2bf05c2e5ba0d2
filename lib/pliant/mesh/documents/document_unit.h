// lib/pliant/mesh/documents/document_unit.h: very large and very small documents scaled to a size near 1 by a power of
// two.
#pragma once
#include "pliant/mesh/mesh.h"
#include "pliant/mesh/pass_report.h"

namespace pliant {

/// The sizes that documents may have, where the size is the larger of width and height. Areas, sums of areas and
/// products of two areas then stay in the range of doubles.
inline constexpr double least_document_size = 0x1p-510, greatest_document_size = 0x1p510;

/// Scales a document whose size (above) is so far from 1 that products of several lengths would overflow or vanish: its
/// lengths are multiplied by a power of two, whose inverse is noted in `boundary.unit`. A document with a size from
/// 2^-60 to 2^60 stays as it is. Criteria, velocities and other fields stay in the units of the document; who uses
/// them must consider `boundary.unit`.
///
/// Requires    boundary.unit == 1
/// Ensures     `restore_unit` gives the same document back, bit for bit; documents that differ by a power of two only
///             have the same coordinates once scaled
/// Throws      InputError for sizes out of range, and for a coordinate so small beside the size that scaling would
///             lose digits
void normalize_unit(MeshData& data);
void normalize_unit(BoundaryComplex& boundary);

/// True if normalize_unit would leave the document of this mesh as it is.   Requires    a compacted mesh
bool has_tame_size(const Mesh& mesh);

/// Throws the same InputError as normalize_unit if the size is out of range; changes nothing.
void require_document_size(const MeshData& data);

/// Undoes normalize_unit: scales back to the units of the document; boundary.unit is 1 afterwards. A coordinate below
/// the least normal double is rounded.
///
/// Throws      std::domain_error if a mesh has moved or grown so far that a coordinate is out of the range of doubles
void restore_unit(MeshData& data);
void restore_unit(BoundaryComplex& boundary);

/// Converts the report of a pass over a scaled mesh to the units of the document: places, and values that are lengths.
void restore_unit(PassReport& report, double unit);

}  // namespace pliant
