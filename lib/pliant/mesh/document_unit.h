// lib/pliant/mesh/document_unit.h: the power of two that brings documents of any size to one near 1.
#pragma once
#include "pliant/mesh/mesh.h"
#include "pliant/mesh/pass_report.h"

namespace pliant {

/// Sizes that documents may have, the larger of width and height: areas, their sums and products with areas of the same
/// size are doubles then.
inline constexpr double least_document_size = 0x1p-510, greatest_document_size = 0x1p510;

/// Multiplies all lengths of the document by a power of two and notes its inverse in `boundary.unit`, where the size
/// (above) is so far from 1 that products of several lengths would overflow or vanish. A document between 2^-60 and
/// 2^60 stays as it is. Exact: `restore_unit` gives the same document back, bit for bit, and the document times a power
/// of two comes to the same numbers. Criteria, velocities and other fields are left in the units of the document; who
/// uses them looks at `boundary.unit`.
///
/// Requires    a unit of 1
/// Throws      InputError for sizes out of range, and where a coordinate is so small beside the size that it would lose
///             digits
void normalize_unit(MeshData& data);
void normalize_unit(BoundaryComplex& boundary);

/// True where normalize_unit would leave the document of this mesh as it is.
bool has_tame_size(const Mesh& mesh);

/// Throws as normalize_unit does for a size out of range.
void require_document_size(const MeshData& data);

/// The inverse; the unit is 1 after it. Throws std::domain_error where a mesh has moved or grown so far that a
/// coordinate is no double any more. A coordinate that comes below the least normal double is rounded to what is left
/// of it there.
void restore_unit(MeshData& data);
void restore_unit(BoundaryComplex& boundary);

/// What a pass over a normalised mesh reports, in the units of the document: places, and the values that it added as
/// lengths.
void restore_unit(PassReport& report, double unit);

}  // namespace pliant
