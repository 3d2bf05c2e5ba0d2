// tools/stages/run_stage.cpp: one stage after the other on a mesh in memory, as a pipe of their tools.
#include "stages/run_stage.h"

#include "pliant/geometry/describe.h"
#include "pliant/mesh/documents/reread.h"
#include "run/in_unit.h"
#include "run/require_mesh.h"

namespace pliant {

PassReport run_stage(const Stage& stage, Mesh& mesh, const StageContext& context) {
  const double unit = mesh.boundary().unit;
  PassReport report;
  in_unit(unit, [&] { report = stage.run(mesh, context); });
  report.resolution = place_resolution * mesh.size();
  report_in_document(report, unit);
  return report;
}

void hand_over(Mesh& mesh, const Stage& before, const Stage& after) {
  reread(mesh);
  if (before.may_leave_tangled() && !after.accepts_tangled())
    in_unit(mesh.boundary().unit, [&] { require_valid(mesh); });
}

}  // namespace pliant
