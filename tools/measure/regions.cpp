// tools/measure/regions.cpp: finds faces and curves by name, and measures what is asked of them.
#include "measure/regions.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "formats/problem/flow_memory.h"
#include "formats/problem/names.h"
#include "options/expression.h"
#include "pliant/fem/measures/outline.h"
#include "run/exit_status.h"

namespace pliant {
namespace {

class Region {
 public:
  Region(const PlaceRequest& request, MeasuredFunctions& functions)
      : request_(request), functions_(functions), mesh_(functions.mesh()) {
    if (is_face())
      find_face();
    else
      find_curves();
  }

  void measure(const QuantityRequest& wanted) {
    wanted_ = &wanted;
    const std::string& what = wanted.what;
    if (what == "mean" || what == "integral" || what == "min" || what == "max") return measure_functions(what);
    if (what == "flux") return measure_flux();
    const auto plain = std::ranges::find(quantities(), what, &Quantity::name);
    if (plain == quantities().end()) refuse_quantity(what);
    if (!wanted.argument.empty()) fail("\"" + what + "\" has nothing in brackets behind it");
    plain->measure(*this);
  }

  std::vector<MeasuredColumn> take_columns() { return std::move(columns_); }

 private:
  struct Quantity {
    std::string name;
    std::function<void(Region&)> measure;
  };

  bool is_face() const { return request_.kind == PlaceRequest::Kind::face; }
  [[noreturn]] void fail(const std::string& text) const { throw UsageError(request_.text + ": " + text); }

  void find_face() {
    const BoundaryComplex& boundary = mesh_.boundary();
    if (request_.target == "*") {
      where_ = "the mesh";
    } else {
      face_ = pliant::find_face(boundary, request_.target);
      if (face_ == outside) {
        std::vector<std::string> names;
        for (const Face& face : boundary.faces) names.push_back(face.name);
        fail("there is no face \"" + request_.target + "\"" + known_names(request_.target, "faces", names));
      }
      where_ = "face \"" + request_.target + "\"";
    }
    outline_ = outline_of_face(mesh_, face_);
  }

  void find_curves() {
    const auto& curves = mesh_.boundary().curves;
    std::vector<CurveId> ids;
    std::vector<std::string> names;
    for (std::size_t c = 0; c < curves.size(); ++c) {
      const bool outer = curves[c].left == outside || curves[c].right == outside;
      if (request_.target == "*" ? outer : curves[c].name == request_.target) ids.push_back(static_cast<CurveId>(c));
      if (std::ranges::find(names, curves[c].name) == names.end()) names.push_back(curves[c].name);
    }
    if (ids.empty())
      fail("there is no curve \"" + request_.target + "\"" + known_names(request_.target, "curves", names));
    where_ = request_.target == "*" ? "the outer boundary" : "curve \"" + request_.target + "\"";
    outline_ = outline_of_curves(mesh_, ids);
  }

  static const std::vector<Quantity>& face_quantities() {
    static const std::vector<Quantity> list{
        {"area", [](Region& r) { r.add("", "area of", r.area().area); }},
        {"centre", [](Region& r) { r.add_point("centre of mass", r.area().centre); }},
        {"perimeter", [](Region& r) { r.add("", "length of the outline of", r.perimeter()); }},
        {"circularity", [](Region& r) { r.add_circularity(); }},
        {"deformation", [](Region& r) { r.add_deformation(); }},
        {"inclination", [](Region& r) { r.add_inclination(); }}};
    return list;
  }

  static const std::vector<Quantity>& curve_quantities() {
    static const std::vector<Quantity> list{
        {"length", [](Region& r) { r.add("", "length of", r.perimeter()); }},
        {"centre",
         [](Region& r) {
           r.add_point("centre of the line",
                       r.outline_.empty() ? Point{no_value, no_value} : centre_of_line(r.mesh_, r.outline_));
         }},
        {"area", [](Region& r) { r.add("", "area enclosed by", r.area().area); }},
        {"circularity", [](Region& r) { r.add_circularity(); }},
        {"deformation", [](Region& r) { r.add_deformation(); }},
        {"inclination", [](Region& r) { r.add_inclination(); }},
        {"force", [](Region& r) { r.add_force(); }}};
    return list;
  }

  const std::vector<Quantity>& quantities() const { return is_face() ? face_quantities() : curve_quantities(); }

  [[noreturn]] void refuse_quantity(const std::string& what) const {
    std::vector<std::string> names;
    for (const Quantity& each : quantities()) names.push_back(each.name);
    for (const char* function : {"mean", "integral", "min", "max", "flux"})
      names.push_back(std::string(function) + "(FIELD)");
    fail("there is no quantity \"" + what + "\" of a " + (is_face() ? "face" : "curve") +
         known_names(what, "quantities", names));
  }

  /// `meaning` ends with the word before the region.
  void add(const std::string& suffix, const std::string& meaning, double value) {
    const std::string column =
        wanted_->column.empty() ? request_.prefix + "_" + as_name(wanted_->text) : wanted_->column;
    columns_.push_back({column + suffix, meaning + " " + where_, value});
  }

  void add_point(const std::string& meaning, const Point& point) {
    add("_x", "x of the " + meaning + " of", point.x);
    add("_y", "y of the " + meaning + " of", point.y);
  }

  /// The face's, or what the curves enclose, whichever way they run.
  const AreaAndCentre& area() {
    if (area_) return *area_;
    if (is_face()) return area_.emplace(measure_area(mesh_, face_));
    if (!is_closed(mesh_, outline_))
      fail("\"" + wanted_->what + "\" needs curves that enclose an area, all in one direction; those of " + where_ +
           " do not close");
    area_ = measure_enclosed(mesh_, outline_);
    area_->area = std::abs(area_->area);
    return *area_;
  }

  const Reach& reach() {
    if (reach_) return *reach_;
    const Point centre = area().centre;
    if (outline_.empty() || !std::isfinite(centre.x) || !std::isfinite(centre.y))
      return reach_.emplace(Reach{no_value, no_value, {no_value, no_value}});
    return reach_.emplace(measure_reach(mesh_, outline_, centre));
  }

  void add_circularity() {
    const double round = 2 * std::sqrt(std::numbers::pi * area().area);
    add("", "circularity (perimeter of the circle of the same area, divided by the perimeter) of", round / perimeter());
  }

  void add_deformation() {
    const Reach& found = reach();
    add("", "deformation (L-B)/(L+B), by the greatest and the least distance from the centre of mass, of",
        (found.greatest - found.least) / (found.greatest + found.least));
  }

  void add_inclination() {
    const Vector arm = reach().farthest - area().centre;
    double degrees = std::atan2(arm.y, arm.x) * 180 / std::numbers::pi;
    if (degrees <= -90) degrees += 180;
    if (degrees > 90) degrees -= 180;
    add("", "direction (degrees, above -90 and up to 90) from the centre of mass to the farthest point of", degrees);
  }

  void add_force() {
    const FlowMemory memory = recall_flow(mesh_.extra);
    if (memory.forces.empty()) {  // nothing is solved yet, as in the first frame of a run
      add("_x", "x of the fluid's force on", no_value);
      add("_y", "y of the fluid's force on", no_value);
      return;
    }
    const auto force = memory.forces.find(request_.target);
    std::vector<std::string> names;
    for (const auto& [name, each] : memory.forces) names.push_back(name);
    if (force == memory.forces.end())
      throw InputError("", request_.text + ": the mesh carries no force on " + where_ +
                               ", which navierstokes notes for curves with a condition \"velocity\"" +
                               known_names(request_.target, "curves with a force", names));
    add("_x", "x of the fluid's force on", force->second.x);
    add("_y", "y of the fluid's force on", force->second.y);
  }

  void measure_functions(const std::string& what) {
    if (wanted_->argument.empty()) fail("\"" + what + "\" wants a field in brackets: " + what + "(FIELD)");
    for (NamedFunction& each : functions_.find(wanted_->argument, request_.text)) {
      const std::string meaning = what + " of " + wanted_->argument + each.suffix + " over";
      if (what == "min" || what == "max") {
        if (!each.function.is_field())
          fail("\"" + wanted_->text + "\": bounds are those of a field or of a component, not of an expression");
        const auto range = is_face() ? bounds(each.function, mesh_, face_) : bounds(each.function, mesh_, outline_);
        add(each.suffix, meaning, !range ? no_value : what == "min" ? range->least : range->greatest);
      } else {
        const double integral =
            is_face() ? integrate(each.function, mesh_, face_) : integrate(each.function, mesh_, outline_);
        add(each.suffix, meaning, what == "integral" ? integral : integral / size());
      }
    }
  }

  double size() { return is_face() ? area().area : perimeter(); }

  double perimeter() {
    if (!perimeter_) perimeter_ = measure_length(mesh_, outline_);
    return *perimeter_;
  }

  void measure_flux() {
    std::vector<NamedFunction> found;
    for (const std::string& part : split_expressions(wanted_->argument))
      for (NamedFunction& each : functions_.find(part, request_.text)) found.push_back(std::move(each));
    if (found.size() != 2)
      fail("\"" + wanted_->text + "\": a flux is that of a field with two components, or of two expressions, not of " +
           std::to_string(found.size()));
    add("", std::string("flux of ") + wanted_->argument + (is_face() ? " out of" : " through"),
        integrate_flux(found[0].function, found[1].function, mesh_, outline_));
  }

  const PlaceRequest& request_;
  MeasuredFunctions& functions_;
  const Mesh& mesh_;
  FaceId face_ = every_face;
  Outline outline_;
  std::string where_;  ///< the region in words
  const QuantityRequest* wanted_ = nullptr;
  std::vector<MeasuredColumn> columns_;
  std::optional<AreaAndCentre> area_;
  std::optional<Reach> reach_;
  std::optional<double> perimeter_;
};

}  // namespace

std::vector<MeasuredColumn> measure_region(const PlaceRequest& request, MeasuredFunctions& functions) {
  // Read again, now that it is known which names there are.
  const BoundaryComplex& boundary = functions.mesh().boundary();
  std::vector<std::string> names;
  if (request.kind == PlaceRequest::Kind::face)
    for (const Face& face : boundary.faces) names.push_back(face.name);
  else
    for (const Curve& curve : boundary.curves) names.push_back(curve.name);
  const PlaceRequest own = parse_region(request.kind, request.source, names);
  Region region(own, functions);
  for (const QuantityRequest& wanted : own.quantities) region.measure(wanted);
  return region.take_columns();
}

}  // namespace pliant
