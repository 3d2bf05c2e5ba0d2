// grid.js: which elements may be seen in a box, by a uniform grid over the boxes of their control nets.

class Grid {
  constructor(mesh) {
    this.mesh = mesh;
    const [left, low, right, high] = mesh.box;
    const width = right - left || 1, height = high - low || 1;
    const cells = Math.max(1, mesh.count / 4);
    this.columns = Math.min(1024, Math.max(1, Math.round(Math.sqrt((cells * width) / height))));
    this.rows = Math.min(1024, Math.max(1, Math.round(cells / this.columns)));
    this.perX = this.columns / width;
    this.perY = this.rows / height;
    // Counting sort of the elements into the cells that their boxes meet.
    this.starts = new Int32Array(this.columns * this.rows + 1);
    for (let t = 0; t < mesh.count; t++) this.eachCell(mesh.boxes, 4 * t, (cell) => this.starts[cell + 1]++);
    for (let cell = 0; cell < this.columns * this.rows; cell++) this.starts[cell + 1] += this.starts[cell];
    this.members = new Int32Array(this.starts[this.columns * this.rows]);
    const next = this.starts.slice();
    for (let t = 0; t < mesh.count; t++)
      this.eachCell(mesh.boxes, 4 * t, (cell) => {
        this.members[next[cell]++] = t;
      });
    this.stamps = new Int32Array(mesh.count);
    this.stamp = 0;
    this.found = new Int32Array(mesh.count);
  }

  eachCell(box, at, use) {
    const clamp = (value, most) => (value > 0 ? Math.min(most, Math.floor(value)) : 0);
    const i0 = clamp((box[at] - this.mesh.box[0]) * this.perX, this.columns - 1);
    const i1 = clamp((box[at + 2] - this.mesh.box[0]) * this.perX, this.columns - 1);
    const j0 = clamp((box[at + 1] - this.mesh.box[1]) * this.perY, this.rows - 1);
    const j1 = clamp((box[at + 3] - this.mesh.box[1]) * this.perY, this.rows - 1);
    for (let j = j0; j <= j1; j++)
      for (let i = i0; i <= i1; i++) use(j * this.columns + i);
  }

  // The elements whose boxes meet the box, in ascending order; valid until the next call.
  query(box) {
    const {mesh, found} = this, {boxes} = mesh;
    let size = 0;
    const covers = box[0] <= mesh.box[0] && box[1] <= mesh.box[1] && box[2] >= mesh.box[2] && box[3] >= mesh.box[3];
    if (covers) {
      for (let t = 0; t < mesh.count; t++) found[t] = t;
      return found;
    }
    const stamp = ++this.stamp;
    this.eachCell(box, 0, (cell) => {
      for (let m = this.starts[cell]; m < this.starts[cell + 1]; m++) {
        const t = this.members[m];
        if (this.stamps[t] === stamp) continue;
        this.stamps[t] = stamp;
        if (boxes[4 * t] <= box[2] && boxes[4 * t + 2] >= box[0] && boxes[4 * t + 1] <= box[3] &&
            boxes[4 * t + 3] >= box[1])
          found[size++] = t;
      }
    });
    return found.subarray(0, size).sort();
  }
}
