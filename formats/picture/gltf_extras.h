// formats/picture/gltf_extras.h: members of a glTF file that only programs which know Pliant look at.
#pragma once
#include "formats/document/document_value.h"
#include "pliant/mesh/mesh_data.h"

namespace tinygltf {
class Value;
}

namespace pliant {

/// JSON in the values of the writer of glTF, which sorts members.
tinygltf::Value extras_of(const Json& json);
/// The document's member `history`; null where it has none.
const Json* history_of(const MeshData& mesh);

}  // namespace pliant
