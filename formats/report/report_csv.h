// formats/report/report_csv.h: the figures of single elements as a table, a line an element (report.md).
#pragma once
#include <string>

#include "pliant/mesh/mesh_data.h"
#include "pliant/quality/element/element_figures.h"

namespace pliant {

/// Appends the line of the columns' names, which stands once at the head of a table.
void write_csv_header(const ElementFigures& elements, std::string& out);

/// Appends the lines of one mesh. `frame` counts the meshes of a series from 0.
///
/// Requires    `elements` of this mesh (report_quality)
void write_csv_elements(const MeshData& mesh, const ElementFigures& elements, std::int64_t frame, std::string& out);

}  // namespace pliant
