// tools/options/obstacles.h: what stands beside a mesh in pictures and reports: disks and drawings.
#pragma once
#include <string>
#include <vector>

#include "formats/picture/coloring.h"

namespace pliant {

/// Reads the texts X,Y,R of --circle.   Throws UsageError
std::vector<Circle> parse_circles(const std::vector<std::string>& texts);
/// The outlines of the filled shapes of an SVG drawing, read as import-svg does, as closed polygons.
///
/// Throws      InputError, with the name of the file, for drawings that cannot be read; UsageError for "-"
std::vector<std::vector<Point>> read_outlines(const std::string& file);

}  // namespace pliant
