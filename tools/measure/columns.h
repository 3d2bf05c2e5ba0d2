// tools/measure/columns.h: the columns of one line: what was asked for, measured on one mesh.
#pragma once
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "measure/functions.h"
#include "measure/requests.h"
#include "pliant/fem/measures/sample_points.h"

namespace pliant {

/// What is measured where there is nothing: an empty cell.
inline constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

struct MeasuredColumn {
  std::string name;
  std::string meaning;  ///< in words
  double value = 0;     ///< not finite: an empty cell
};

/// All that a command line asks for.
struct MeasureRequests {
  std::vector<PlaceRequest> places;
  std::vector<LineRequest> lines;
  std::vector<std::pair<std::string, std::string>> values;  ///< name and expression
  std::vector<std::pair<std::string, double>> set;
  OutsidePlaces outside = OutsidePlaces::empty;
};

/// The columns of places, faces, curves and values, after that of the time.
///
/// Throws      UsageError for a face, a curve, a field or a quantity that is not there, for an expression that is none,
///             and where two columns have one name; InputError for what the mesh lacks or has wrongly
std::vector<MeasuredColumn> measure_columns(const MeasureRequests& requests, const Mesh& mesh);

/// The samples along lines, as rows of a table that has a row a sample.
struct LineTable {
  std::string header, rows;  ///< each line with its newline
  long outside = 0;          ///< samples outside the mesh
};
/// Throws      as measure_columns
LineTable measure_lines(const MeasureRequests& requests, const Mesh& mesh);

/// A table's header and its row: "time" and the names; the mesh's time and the values.
std::string header_of(const std::vector<MeasuredColumn>& columns);
std::string row_of(double time, const std::vector<MeasuredColumn>& columns);

}  // namespace pliant
