// data.js: what the tool wrote into the page. Summaries of all frames are at hand; meshes are decoded when shown.

const settings = JSON.parse(document.getElementById('settings').textContent);
const frames = [...document.querySelectorAll('script.frame')].map((node) => JSON.parse(node.textContent));
const meshNodes = [...document.querySelectorAll('script.mesh')];

function decodeBytes(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text).buffer;
  const characters = atob(text);
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < characters.length; i++) bytes[i] = characters.charCodeAt(i);
  return bytes.buffer;
}

// Arrays are little-endian, as every machine that runs a browser is.
function decodeMesh(number) {
  const data = JSON.parse(meshNodes[number].textContent);
  return {
    degree: data.degree,
    points: new Float64Array(decodeBytes(data.points)),
    triangles: new Int32Array(decodeBytes(data.triangles)),
    nets: new Int32Array(decodeBytes(data.nets)),
    faces: new Int32Array(decodeBytes(data.faces)),
    validity: new Uint8Array(decodeBytes(data.validity)),
    constrained: new Int32Array(decodeBytes(data.constrained)),
    faceNames: data.face_names,
    curveNames: data.curve_names,
    fields: data.fields.map((field) => ({
                              name: field.name,
                              components: field.components,
                              values: new Float64Array(decodeBytes(field.values)),
                              rows: field.rows ? new Int32Array(decodeBytes(field.rows)) : null,
                            })),
    columns: data.columns.map((column) => ({
                                name: column.name,
                                worstIsLeast: column.worst_is_least,
                                values: new Float64Array(decodeBytes(column.values)),
                              })),
  };
}

// The meshes shown last; a long series has more than a browser should hold.
const recentMeshes = new Map();
function meshOf(number) {
  const found = recentMeshes.get(number) ?? new Mesh(decodeMesh(number));
  recentMeshes.delete(number);
  recentMeshes.set(number, found);
  const most = found.count > 20000 ? 2 : 24;
  for (const oldest of recentMeshes.keys()) {
    if (recentMeshes.size <= most) break;
    recentMeshes.delete(oldest);
  }
  return found;
}
