// lib/pliant/quality/element/element_figures.h: a table of measures of single elements, column by column.
#pragma once
#include <string>
#include <vector>

#include "pliant/geometry/validity/validity.h"
#include "pliant/mesh/ids.h"

namespace pliant {

/// One measure of every chosen element; NaN if it does not exist or overflows.
struct ElementColumn {
  std::string name;
  bool worst_is_least = true;  ///< false: the largest values are the worst
  std::vector<double> values;
};

/// What tables (CSV) and pages (HTML) show of each element; entry k of every vector belongs to triangles[k].
/// The columns are those of all_metrics(), in its order.
struct ElementFigures {
  std::vector<TriangleId> triangles;
  std::vector<Validity> validity;
  std::vector<ElementColumn> columns;
};

}  // namespace pliant
