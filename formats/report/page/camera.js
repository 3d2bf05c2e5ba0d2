// camera.js: which part of the plane is seen. Lengths here are CSS pixels; drawings use device pixels.

class Camera {
  constructor() {
    this.x = this.y = 0;
    this.scale = 1;  // pixels per unit
    this.width = this.height = 1;
  }

  resize(width, height) {
    this.width = Math.max(1, width);
    this.height = Math.max(1, height);
  }

  // Shows the box with a margin.
  fit(box, margin = 0.06) {
    const width = box[2] - box[0], height = box[3] - box[1];
    const room = 1 - 2 * margin;
    this.x = box[0] / 2 + box[2] / 2;
    this.y = box[1] / 2 + box[3] / 2;
    this.scale = Math.min((room * this.width) / (width || height || 1), (room * this.height) / (height || width || 1));
    this.fitted = this.scale;
    this.home = [this.x, this.y];
    this.deepest = Math.max(this.fitted, Math.min(this.fitted * 1e11, 2 ** 47 / Math.max(...box.map(Math.abs))));
  }

  // Whether it shows what `fit` chose.
  get isHome() {
    return this.scale === this.fitted && this.x === this.home[0] && this.y === this.home[1];
  }

  toScreen(x, y) {
    return [this.width / 2 + (x - this.x) * this.scale, this.height / 2 - (y - this.y) * this.scale];
  }

  toPlane(sx, sy) {
    return [this.x + (sx - this.width / 2) / this.scale, this.y - (sy - this.height / 2) / this.scale];
  }

  move(dx, dy) {
    this.x -= dx / this.scale;
    this.y += dy / this.scale;
  }

  // Zooming in ends at `deepest`, where doubles are too coarse for a pixel: far from the origin earlier.
  limited(scale) {
    return Math.max(this.fitted / 20, Math.min(this.deepest, scale));
  }

  // The point under (sx, sy) stays there.
  zoom(factor, sx = this.width / 2, sy = this.height / 2) {
    const [x, y] = this.toPlane(sx, sy);
    this.scale = this.limited(this.scale * factor);
    this.x = x - (sx - this.width / 2) / this.scale;
    this.y = y + (sy - this.height / 2) / this.scale;
  }

  // For drawings on a canvas with `ratio` device pixels a pixel.
  drawing(ratio) {
    const width = Math.round(this.width * ratio), height = Math.round(this.height * ratio);
    return {x: this.x, y: this.y, scale: this.scale * ratio, left: width / 2, top: height / 2, width, height, ratio};
  }
}

// What a drawing's window shows of the plane, with a margin in device pixels.
function seenBox(camera, margin = 4) {
  const right = (camera.width - camera.left + margin) / camera.scale, left = (camera.left + margin) / camera.scale;
  const low = (camera.height - camera.top + margin) / camera.scale, high = (camera.top + margin) / camera.scale;
  return [camera.x - left, camera.y - low, camera.x + right, camera.y + high];
}
