// raster.js: elements of a few pixels, filled straight into an image: far faster than paths, and without seams.

const smallElement = 22;  // device pixels
const piecesOfEdge = 4;

class Raster {
  constructor() {
    this.canvas = document.createElement('canvas');
    this.polygon = new Float64Array(2 * 3 * piecesOfEdge);
    this.cuts = new Float64Array(3 * piecesOfEdge);
  }

  begin(width, height) {
    if (this.canvas.width !== width || this.canvas.height !== height || !this.image) {
      this.canvas.width = width;
      this.canvas.height = height;
      this.context = this.canvas.getContext('2d');
      this.image = this.context.createImageData(width, height);
      this.pixels = new Uint32Array(this.image.data.buffer);
    }
    this.pixels.fill(0);
    this.isEmpty = true;
  }

  // Whether the polygon that is filled is within half a pixel of the element.
  isNear(mesh, t, camera) {
    const {bulges} = mesh;
    return Math.max(bulges[3 * t], bulges[3 * t + 1], bulges[3 * t + 2]) * camera.scale < 0.5 * piecesOfEdge ** 2;
  }

  // Pixels whose centres are inside get the colour; so neighbours share no pixel and leave none out.
  fill(mesh, t, camera, color) {
    this.fillPolygon(this.loadPolygon(mesh, t, camera), color);
  }

  fillPolygon(size, color) {
    const {polygon, cuts, pixels} = this, {width, height} = this.canvas;
    let low = Infinity, high = -Infinity;
    for (let k = 1; k < 2 * size; k += 2) {
      if (polygon[k] < low) low = polygon[k];
      if (polygon[k] > high) high = polygon[k];
    }
    const first = Math.max(0, Math.ceil(low - 0.5)), last = Math.min(height - 1, Math.ceil(high - 0.5) - 1);
    for (let row = first; row <= last; row++) {
      const y = row + 0.5;
      let found = 0;
      for (let k = 0, before = size - 1; k < size; before = k++) {
        const y0 = polygon[2 * before + 1], y1 = polygon[2 * k + 1];
        if (y0 <= y === y1 <= y) continue;
        const x0 = polygon[2 * before];
        let cut = x0 + ((y - y0) / (y1 - y0)) * (polygon[2 * k] - x0), at = found++;
        for (; at > 0 && cuts[at - 1] > cut; at--) cuts[at] = cuts[at - 1];
        cuts[at] = cut;
      }
      for (let k = 0; k + 1 < found; k += 2) {
        const from = Math.max(0, Math.ceil(cuts[k] - 0.5)), to = Math.min(width, Math.ceil(cuts[k + 1] - 0.5));
        for (let at = row * width + from; at < row * width + to; at++) pixels[at] = color;
      }
    }
    this.isEmpty = false;
  }

  // The triangle on the first three rows of a net of `width` numbers a row, x and y first.
  fillTriangle(net, width, camera, color) {
    for (let k = 0; k < 3; k++) {
      this.polygon[2 * k] = camera.left + (net[k * width] - camera.x) * camera.scale;
      this.polygon[2 * k + 1] = camera.top - (net[k * width + 1] - camera.y) * camera.scale;
    }
    this.fillPolygon(3, color);
  }

  // The corners; where an edge is visibly curved also points between, the same ones for both its elements. Returns how
  // many.
  loadPolygon(mesh, t, camera) {
    const {polygon} = this, {points, nets} = mesh;
    let size = 0;
    for (let e = 0; e < 3; e++) {
      const q = 2 * nets[t * mesh.netSize + e];
      polygon[2 * size] = camera.left + (points[q] - camera.x) * camera.scale;
      polygon[2 * size + 1] = camera.top - (points[q + 1] - camera.y) * camera.scale;
      size++;
      if (mesh.bulges[3 * t + e] * camera.scale > 0.35) size = this.addBetween(mesh, t, e, camera, size);
    }
    return size;
  }

  addBetween(mesh, t, e, camera, size) {
    const {polygon} = this, curve = scratchCurve(mesh.degree);
    for (let piece = 1; piece < piecesOfEdge; piece++, size++) {
      loadEdge(mesh, t, e, camera, curve);
      const s = piece / piecesOfEdge;
      for (let r = mesh.degree; r > 0; r--)
        for (let k = 0; k < 2 * r; k++) curve[k] += s * (curve[k + 2] - curve[k]);
      polygon[2 * size] = curve[0];
      polygon[2 * size + 1] = curve[1];
    }
    return size;
  }

  drawOn(context) {
    if (this.isEmpty) return;
    this.context.putImageData(this.image, 0, 0);
    context.drawImage(this.canvas, 0, 0);
  }
}
