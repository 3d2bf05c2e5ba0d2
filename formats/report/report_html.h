// formats/report/report_html.h: the report as one page that draws the mesh, needs nothing else, and fetches nothing.
#pragma once
#include <string>
#include <vector>

#include "formats/picture/coloring.h"
#include "pliant/mesh/mesh_data.h"
#include "pliant/quality/quality_report.h"

namespace pliant {

/// Writes a page piece by piece: `begin`, then a `frame` for each mesh of the series, then `end`; so a series needs
/// memory for one mesh. Each call appends to `out`. report.md tells what the page holds.
class HtmlReport {
 public:
  struct Options {
    std::string title;
    int worst = 5;                                  ///< entries in the page's lists of worst elements
    std::vector<Circle> circles = {};               ///< obstacles: disks
    std::vector<std::vector<Point>> outlines = {};  ///< and closed polygons
  };
  static void begin(const Options& options, std::string& out);
  /// `source` is where the mesh came from, for the reader. Requires `report` and `elements` of this mesh.
  static void frame(const MeshData& mesh, const QualityReport& report, const ElementFigures& elements,
                    const std::string& source, std::string& out);
  static void end(std::string& out);
};

}  // namespace pliant
