// lib/pliant/quality/field_figures.h: range and integral of every carried field (private to this layer).
#pragma once
#include <span>
#include <vector>

#include "pliant/mesh/mesh_data.h"
#include "pliant/quality/quality_report.h"

namespace pliant {

/// Over the chosen triangles. The integral is that of the polynomial f det J: exact to rounding.
std::vector<FieldFigures> field_figures(const MeshData& data, std::span<const TriangleId> chosen);

}  // namespace pliant
