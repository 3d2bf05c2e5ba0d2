// mesh.js: one frame's elements with what drawing needs: boxes, how far edges bulge, which edges to draw.

// In the order of the document: corners, then edges 12, 23, 31, then the interior by descending i, then j.
function netExponents(degree) {
  const list = [[degree, 0, 0], [0, degree, 0], [0, 0, degree]];
  for (let e = 0; e < 3; e++)
    for (let k = 1; k < degree; k++) {
      const entry = [0, 0, 0];
      entry[e] = degree - k;
      entry[(e + 1) % 3] = k;
      list.push(entry);
    }
  for (let i = degree - 2; i > 0; i--)
    for (let j = degree - i - 1; j > 0; j--) list.push([i, j, degree - i - j]);
  return list;
}

const hiddenEdge = 0, innerEdge = 1, borderEdge = 2;

class Mesh {
  constructor(data) {
    Object.assign(this, data);
    this.count = this.triangles.length;
    this.netSize = ((this.degree + 1) * (this.degree + 2)) / 2;
    this.edgeIndex =
        Array.from({length: 3}, (_, e) => Array.from({length: this.degree + 1}, (__, k) => this.indexOnEdge(e, k)));
    this.indexOfTriangle = new Map();
    this.triangles.forEach((triangle, t) => this.indexOfTriangle.set(triangle, t));
    this.measure();
    this.chooseEdges();
    this.bad = [];
    for (let t = 0; t < this.count; t++)
      if (this.validity[t] !== 0) this.bad.push(t);
    this.grid = new Grid(this);
  }

  indexOnEdge(e, k) {
    if (k === 0) return e;
    return k === this.degree ? (e + 1) % 3 : 3 + e * (this.degree - 1) + k - 1;
  }

  column(name) {
    return this.columns.find((column) => column.name === name) ?? this.fieldColumn(name);
  }

  // What the name of a field chooses; undefined for all other names.
  choice(name) {
    this.choices ??= fieldChoices(this);
    return this.choices.find((choice) => choice.name === name);
  }

  fieldColumn(name) {
    if (!name.startsWith('field:')) return undefined;
    this.fieldColumns ??= new Map();
    if (!this.fieldColumns.has(name)) this.fieldColumns.set(name, fieldColumn(this, name));
    return this.fieldColumns.get(name);
  }

  // Boxes of the control nets; and a bound of how far the edges are from straight, each taken with even speed.
  measure() {
    const {points, nets, netSize} = this;
    this.boxes = new Float64Array(4 * this.count);
    this.bulges = new Float64Array(3 * this.count);
    this.box = [Infinity, Infinity, -Infinity, -Infinity];
    for (let t = 0; t < this.count; t++) {
      let left = Infinity, low = Infinity, right = -Infinity, high = -Infinity;
      for (let k = 0; k < netSize; k++) {
        const q = 2 * nets[t * netSize + k], x = points[q], y = points[q + 1];
        if (x < left) left = x;
        if (x > right) right = x;
        if (y < low) low = y;
        if (y > high) high = y;
      }
      this.boxes.set([left, low, right, high], 4 * t);
      if (left < this.box[0]) this.box[0] = left;
      if (low < this.box[1]) this.box[1] = low;
      if (right > this.box[2]) this.box[2] = right;
      if (high > this.box[3]) this.box[3] = high;
      for (let e = 0; e < 3; e++) this.bulges[3 * t + e] = this.bulge(t, e);
    }
    if (this.count === 0) this.box = [0, 0, 1, 1];
    this.size = Math.max(this.box[2] - this.box[0], this.box[3] - this.box[1]);
  }

  bulge(t, e) {
    const {points, nets, netSize, degree} = this;
    const a = 2 * nets[t * netSize + e], b = 2 * nets[t * netSize + ((e + 1) % 3)];
    let most = 0;
    for (let k = 1; k < degree; k++) {
      const s = k / degree, q = 2 * nets[t * netSize + this.edgeIndex[e][k]];
      const dx = points[q] - (points[a] + s * (points[b] - points[a]));
      const dy = points[q + 1] - (points[a + 1] + s * (points[b + 1] - points[a + 1]));
      most = Math.max(most, Math.hypot(dx, dy));
    }
    return most;
  }

  // Every edge is drawn once, by the first element that has it; border: constrained, or of one element only.
  chooseEdges() {
    const {nets, netSize, degree} = this;
    const size = this.points.length / 2;
    const keyOf = (a, b) => (a < b ? a * size + b : b * size + a);
    const constrained = new Set();
    for (let i = 0; i < this.constrained.length; i += 3)
      constrained.add(keyOf(this.constrained[i], this.constrained[i + 1]));
    this.edgeKinds = new Uint8Array(3 * this.count);
    const owners = new Map();
    for (let h = 0; h < 3 * this.count; h++) {
      const t = Math.floor(h / 3), e = h % 3;
      const key = keyOf(nets[t * netSize + e], nets[t * netSize + ((e + 1) % 3)]);
      const owner = owners.get(key);
      if (owner === undefined) {
        owners.set(key, h);
        this.edgeKinds[h] = borderEdge;
        continue;
      }
      if (!constrained.has(key)) this.edgeKinds[owner] = innerEdge;
      // Where triangles do not fit together each side is drawn.
      const other = Math.floor(owner / 3), f = owner % 3;
      for (let k = 1; k < degree; k++)
        if (nets[t * netSize + this.edgeIndex[e][k]] !== nets[other * netSize + this.edgeIndex[f][degree - k]])
          this.edgeKinds[h] = borderEdge;
    }
  }

  // The image of the barycentre.
  centre(t) {
    this.exponents ??= netExponents(this.degree);
    const factorial = (n) => (n < 2 ? 1 : n * factorial(n - 1));
    let x = 0, y = 0;
    this.exponents.forEach(([i, j, k], n) => {
      const weight = factorial(this.degree) / (factorial(i) * factorial(j) * factorial(k)) / 3 ** this.degree;
      const q = 2 * this.nets[t * this.netSize + n];
      x += weight * this.points[q];
      y += weight * this.points[q + 1];
    });
    return [x, y];
  }

  // The legs of the control net as pairs of entries.
  netLegs() {
    if (this.legs) return this.legs;
    const list = netExponents(this.degree);
    const find = new Map(list.map((entry, n) => [entry.join(), n]));
    this.legs = [];
    for (let i = 0; i < this.degree; i++)
      for (let j = 0; i + j < this.degree; j++) {
        const k = this.degree - 1 - i - j;
        const corner = [find.get([i + 1, j, k].join()), find.get([i, j + 1, k].join()), find.get([i, j, k + 1].join())];
        for (let e = 0; e < 3; e++) this.legs.push([corner[e], corner[(e + 1) % 3]]);
      }
    return this.legs;
  }
}
