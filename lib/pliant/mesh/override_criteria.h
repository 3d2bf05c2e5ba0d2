// lib/pliant/mesh/override_criteria.h: criteria that replace entries of a document's.
#pragma once
#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// Writes every entry that `given` has into the criteria of a document with this boundary; of the areas by face, those
/// of the faces that are named.
/// Throws      std::invalid_argument where a named face does not exist; the criteria are then as they were
void override_criteria(Criteria& criteria, const Criteria& given, const BoundaryComplex& boundary);

}  // namespace pliant
