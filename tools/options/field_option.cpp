// tools/options/field_option.cpp: --field NAME[@FACE]=EXPR[,EXPR] of bspline2mesh and advect.
#include "options/field_option.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "formats/document/characters.h"
#include "pliant/boundary/boundary_spans.h"
#include "pliant/mesh/interpolate_nodes.h"
#include "run/exit_status.h"

namespace pliant {
namespace {

/// The components of the field on other faces, if its values there stay; 0 if there is none.
int kept_components(const Mesh& mesh, const std::string& name) {
  for (const Field& field : mesh.fields())
    if (field.name == name) return field.components;
  return 0;
}

}  // namespace

void FieldOption::add(CLI::App& app) {
  app.add_option("--field", texts_,
                 "make or replace a field: an expression in x, y, t for each component, separated by commas, on one "
                 "face or all (repeatable)")
      ->type_name("FIELD[@FACE]=EXPR[,EXPR]")
      ->allow_extra_args(false);
}

void FieldOption::check() {
  requests_.clear();
  for (const std::string& text : texts_) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) throw UsageError("--field " + text + ": NAME[@FACE]=EXPR[,EXPR] is wanted");
    Request request;
    request.name = text.substr(0, equals);
    if (const std::size_t at = request.name.find('@'); at != std::string::npos) {
      request.face = request.name.substr(at + 1);
      request.name.resize(at);
      if (request.face.empty()) throw UsageError("--field " + text + ": there is no face after the @");
    }
    if (find_no_utf8(request.name) != nullptr) throw UsageError("--field " + text + ": the name is not UTF-8");
    if (request.name.empty()) throw UsageError("--field " + text + ": the field has no name");
    for (const std::string& part : split_expressions(text.substr(equals + 1))) {
      try {
        request.components.emplace_back(part);
      } catch (const std::invalid_argument& error) {
        throw UsageError("--field " + request.name + ": " + error.what());
      }
    }
    requests_.push_back(std::move(request));
  }
}

void FieldOption::apply(Mesh& mesh) const {
  for (const Request& request : requests_) {
    FaceId face = none;
    const int components = static_cast<int>(request.components.size());
    if (!request.face.empty()) {
      face = find_face(mesh.boundary(), request.face);
      if (face == outside) throw UsageError("--field " + request.name + ": there is no face \"" + request.face + "\"");
      const int kept = kept_components(mesh, request.name);
      if (kept != 0 && kept != components)
        throw UsageError("--field " + request.name + "@" + request.face + ": the field has " + std::to_string(kept) +
                         " components on the other faces, not " + std::to_string(components));
    }
    const double time = mesh.time, unit = mesh.boundary().unit;
    std::string why;
    Field field = make_field(
        mesh, request.name, components, face,
        [&](const Point& place, std::span<double> value) {
          for (std::size_t c = 0; c < value.size(); ++c)
            value[c] = request.components[c](unit * place.x, unit * place.y, time);
        },
        why);
    if (!why.empty()) throw NoResult(why);
    mesh.set_field(std::move(field));
  }
}

}  // namespace pliant
