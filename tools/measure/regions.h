// tools/measure/regions.h: the quantities of faces and curves.
#pragma once
#include <vector>

#include "measure/columns.h"

namespace pliant {

/// The columns of a face or of the curves of a name.   Requires    no point   Throws as measure_columns
std::vector<MeasuredColumn> measure_region(const PlaceRequest& request, MeasuredFunctions& functions);

}  // namespace pliant
