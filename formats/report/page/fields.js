// fields.js: fields as what elements are coloured by: values at points, and elements cut into pieces of one colour.

// "field:NAME" is the length of a field of several components, "field:NAME.K" one component.
class FieldChoice {
  constructor(name, field, component) {
    Object.assign(this, {name, field, component});
  }
  // The value of a row of components.
  of(rows, at) {
    const {components} = this.field;
    if (this.component >= 0) return rows[at + this.component];
    let sum = 0;
    for (let c = 0; c < components; c++) sum = Math.hypot(sum, rows[at + c]);
    return sum;
  }
}

function fieldChoices(mesh) {
  return mesh.fields.flatMap((field) => {
    const name = `field:${field.name}`;
    if (field.components === 1) return [new FieldChoice(name, field, 0)];
    const parts = Array.from({length: field.components}, (_, c) => new FieldChoice(`${name}.${c}`, field, c));
    return [new FieldChoice(name, field, -1), ...parts];
  });
}

// Control points and control values of an element: x, y, then the field's components, for each entry of its net. Points
// are relative to (left, low).
function loadNet(mesh, t, field, out, left = 0, low = 0) {
  const {nets, points, netSize} = mesh, {components, values, rows} = field, width = 2 + components;
  for (let n = 0; n < netSize; n++) {
    const entry = t * netSize + n, point = nets[entry], row = components * (rows ? rows[entry] : point);
    out[n * width] = points[2 * point] - left;
    out[n * width + 1] = points[2 * point + 1] - low;
    for (let c = 0; c < components; c++) out[n * width + 2 + c] = values[row + c];
  }
  return width;
}

// The weight of each entry of the net when the polynomial's blossom is taken at these barycentric arguments.
function blossomWeights(degree, places) {
  let terms = new Map([['0,0,0', 1]]);
  for (const place of places) {
    const next = new Map();
    for (const [key, weight] of terms) {
      const exponents = key.split(',').map(Number);
      for (let c = 0; c < 3; c++) {
        exponents[c]++;
        const grown = exponents.join();
        next.set(grown, (next.get(grown) ?? 0) + weight * place[c]);
        exponents[c]--;
      }
    }
    terms = next;
  }
  return Float64Array.from(netExponents(degree), (exponents) => terms.get(exponents.join()) ?? 0);
}

// The matrices that take a net to those of its four halves, by degree.
const splitMatrices = new Map();
function splitMatrix(degree) {
  if (splitMatrices.has(degree)) return splitMatrices.get(degree);
  const a = [1, 0, 0], b = [0, 1, 0], c = [0, 0, 1];
  const ab = [0.5, 0.5, 0], bc = [0, 0.5, 0.5], ca = [0.5, 0, 0.5];
  const matrices = [[a, ab, ca], [ab, b, bc], [ca, bc, c], [bc, ca, ab]].map(
      (corner) => netExponents(degree).map(
          (exponents) => blossomWeights(degree, exponents.flatMap((times, k) => Array(times).fill(corner[k])))));
  splitMatrices.set(degree, matrices);
  return matrices;
}

function weighted(net, width, weights, out, at = 0) {
  for (let c = 0; c < width; c++) {
    let sum = 0;
    for (let n = 0; n < weights.length; n++) sum += weights[n] * net[n * width + c];
    out[at + c] = sum;
  }
}

// x, y and the components at barycentric coordinates.
function evaluateNet(degree, net, width, xi) {
  const out = new Float64Array(width);
  weighted(net, width, blossomWeights(degree, Array(degree).fill(xi)), out);
  return out;
}

// The value of the choice at (x, y) in element t: Newton's method for the barycentric coordinates. The net is relative
// to (x, y), so that its rounding is small beside the element wherever the mesh is.
function valueAt(mesh, t, choice, x, y) {
  const net = new Float64Array(mesh.netSize * (2 + choice.field.components));
  const width = loadNet(mesh, t, choice.field, net, x, y), {degree} = mesh;
  const scale = Math.max(mesh.boxes[4 * t + 2] - mesh.boxes[4 * t], mesh.boxes[4 * t + 3] - mesh.boxes[4 * t + 1]);
  const starts = [[1 / 3, 1 / 3], [0.15, 0.15], [0.7, 0.15], [0.15, 0.7]];
  for (let [u, v] of starts) {
    for (let step = 0; step < 30; step++) {
      const here = evaluateNet(degree, net, width, [1 - u - v, u, v]), dx = -here[0], dy = -here[1];
      if (Math.hypot(dx, dy) <= 1e-9 * scale) {
        if (Math.min(u, v, 1 - u - v) < -1e-6) break;
        return choice.of(here, 2);
      }
      const args = Array(degree - 1).fill([1 - u - v, u, v]);
      const along = [[-1, 1, 0], [-1, 0, 1]].map((direction) => {
        const out = new Float64Array(width);
        weighted(net, width, blossomWeights(degree, [...args, direction]), out);
        return [degree * out[0], degree * out[1]];
      });
      const det = along[0][0] * along[1][1] - along[0][1] * along[1][0];
      const du = (dx * along[1][1] - dy * along[1][0]) / det, dv = (along[0][0] * dy - along[0][1] * dx) / det;
      if (!Number.isFinite(du + dv)) break;
      const part = Math.min(1, 0.5 / Math.max(Math.abs(du), Math.abs(dv), 1e-300));
      u += part * du;
      v += part * dv;
    }
  }
  return NaN;
}

// As a metric's column: the value in the middle of each element. A mesh of a series that lacks the field has no values.
function fieldColumn(mesh, name) {
  const choice = mesh.choice(name), values = new Float64Array(mesh.count).fill(NaN);
  const column = {name, worstIsLeast: false, isField: true, values};
  if (!choice) return column;
  const net = new Float64Array(mesh.netSize * (2 + choice.field.components));
  const weights = blossomWeights(mesh.degree, Array(mesh.degree).fill([1 / 3, 1 / 3, 1 / 3]));
  const out = new Float64Array(2 + choice.field.components);
  for (let t = 0; t < mesh.count; t++) {
    weighted(net, loadNet(mesh, t, choice.field, net), weights, out);
    values[t] = choice.of(out, 2);
  }
  return column;
}

// The names of all fields of a series, those of its first mesh first.
function fieldNames() {
  const later = frames.flatMap((frame) => Object.keys(frame.ranges).filter((name) => name.startsWith('field:')));
  return [...new Set([...fieldChoices(meshOf(0)).map((choice) => choice.name), ...later])];
}

const pieceSize = 5;  // device pixels: smaller pieces have one colour

// Draws elements of some size in pieces of one colour. What shines through between pieces is the element's own colour.
class FieldPainter {
  constructor(mesh, choice, range, palette) {
    Object.assign(this, {mesh, choice, range, palette, levels: []});
    this.width = 2 + choice.field.components;
    this.matrices = splitMatrix(mesh.degree);
  }

  net(depth) {
    return this.levels[depth] ??= new Float64Array(this.mesh.netSize * this.width);
  }

  draw(context, camera, elements, offset) {
    raster.begin(camera.width, camera.height);
    for (const t of elements) {
      loadNet(this.mesh, t, this.choice.field, this.net(0));
      this.paint(0, camera, offset(t));
    }
    raster.drawOn(context);
  }

  // The net's box on the screen, how far it is from flat, and the colours at its entries.
  look(net, camera) {
    const {width, mesh} = this, corner = (k, c) => net[k * width + c];
    let left = Infinity, right = -Infinity, low = Infinity, high = -Infinity, least = 255, most = 0, bulge = 0;
    for (let n = 0; n < mesh.netSize; n++) {
      const x = net[n * width], y = net[n * width + 1];
      if (x < left) left = x;
      if (x > right) right = x;
      if (y < low) low = y;
      if (y > high) high = y;
      const code = codeOf(this.choice.of(net, n * width + 2), ...this.range);
      if (code < least) least = code;
      if (code > most) most = code;
      if (n < 3) continue;
      const [i, j, k] = this.shares[n];
      bulge = Math.max(
          bulge, Math.abs(x - i * corner(0, 0) - j * corner(1, 0) - k * corner(2, 0)),
          Math.abs(y - i * corner(0, 1) - j * corner(1, 1) - k * corner(2, 1)));
    }
    const isSeen = camera.left + (right - camera.x) * camera.scale > 0 &&
        camera.left + (left - camera.x) * camera.scale < camera.width &&
        camera.top - (low - camera.y) * camera.scale > 0 &&
        camera.top - (high - camera.y) * camera.scale < camera.height;
    const size = Math.max(right - left, high - low) * camera.scale;
    return {isSeen, size, isPlain: least === most && bulge * camera.scale < 0.5};
  }

  // The barycentric coordinates of the net's entries, were it straight.
  get shares() {
    const {degree} = this.mesh;
    return this.shareList ??= netExponents(degree).map((entry) => entry.map((exponent) => exponent / degree));
  }

  paint(depth, camera, offset) {
    const net = this.net(depth), {width} = this, {isSeen, size, isPlain} = this.look(net, camera);
    if (!isSeen) return;
    if (size <= pieceSize || (isPlain && size < farAway) || depth > 50) {
      const middle = this.middle ??= new Float64Array(width);
      weighted(net, width, this.middleWeights, middle);
      const code = codeOf(this.choice.of(middle, 2), ...this.range);
      raster.fillTriangle(net, width, camera, this.palette.pixel[code + offset]);
      return;
    }
    const child = this.net(depth + 1);
    for (const matrix of this.matrices) {
      for (let n = 0; n < matrix.length; n++) weighted(net, width, matrix[n], child, n * width);
      this.paint(depth + 1, camera, offset);
    }
  }

  get middleWeights() {
    const {degree} = this.mesh;
    return this.middleList ??= blossomWeights(degree, Array(degree).fill([1 / 3, 1 / 3, 1 / 3]));
  }
}
