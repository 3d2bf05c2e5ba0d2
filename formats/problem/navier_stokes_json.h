// formats/problem/navier_stokes_json.h: the section `navierstokes` of a problem document as JSON.
#pragma once
#include "formats/document/read_json.h"
#include "formats/document/write_json.h"
#include "formats/problem/problem_document.h"

namespace pliant {

/// The value now being read as the section.   Throws DocumentError
NavierStokesSection read_navier_stokes(JsonReader& in);
void write_navier_stokes(JsonWriter& out, const NavierStokesSection& section);

}  // namespace pliant
