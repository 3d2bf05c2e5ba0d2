// lib/pliant/quality/field_figures.h: the range and the integral of every carried field (private to this layer).
#pragma once
#include <span>
#include <vector>

#include "pliant/mesh/mesh_data.h"
#include "pliant/quality/quality_report.h"

namespace pliant {

/// The figures of every field over the chosen triangles. Integrals of the polynomial f det J are exact to rounding.
std::vector<FieldFigures> field_figures(const MeshData& data, std::span<const TriangleId> chosen);

}  // namespace pliant
