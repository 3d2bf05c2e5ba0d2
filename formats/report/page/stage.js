// stage.js: the two canvases: draws when something changed, at once if that is quick, else first a moved copy.

class Stage {
  // `look()` tells what to draw: {mesh, codes, palette, edges, highlight, selected, pointed, points, crosshair}.
  constructor(look) {
    this.look = look;
    this.camera = new Camera();
    this.meshCanvas = byId('mesh');
    this.marksCanvas = byId('marks');
    this.milliseconds = 0;  // of the last drawing
    this.copy = document.createElement('canvas');
    new ResizeObserver(() => this.resize()).observe(byId('paper'));
    this.resize();
  }

  resize() {
    const {width, height} = byId('paper').getBoundingClientRect();
    const ratio = Math.min(Math.max(window.devicePixelRatio || 1, this.leastRatio ?? 0), 3);
    if (this.ratio === ratio && this.camera.width === Math.max(1, width) && this.camera.height === Math.max(1, height))
      return;
    const first = this.camera.fitted === undefined;
    const scale = Math.min(width / this.camera.width, height / this.camera.height);
    const wasFitted = this.camera.scale === this.camera.fitted;
    this.camera.resize(width, height);
    this.ratio = ratio;
    for (const canvas of [this.meshCanvas, this.marksCanvas]) {
      canvas.width = Math.round(this.camera.width * this.ratio);
      canvas.height = Math.round(this.camera.height * this.ratio);
    }
    if (!first && wasFitted && scale > 0) this.camera.fit(this.box);
    // At once: the canvases are empty now, and must not be seen so.
    this.drawNow();
  }

  fit(box) {
    this.box = box;
    this.camera.fit(box);
    this.changed();
  }

  // Everything is to be drawn again, in the next frame of the screen.
  changed() {
    this.isStale = true;
    this.later();
  }
  // Only what lies over the drawing.
  marksChanged() {
    this.later();
  }
  // The camera moved: where drawing takes long, a copy of the last drawing is moved first.
  moved() {
    this.changed();
    this.onMove?.();
    if (this.milliseconds > 18) {
      this.isHasty = true;
      clearTimeout(this.timer);
      this.timer = setTimeout(() => {
        this.isHasty = false;
        this.later();
      }, 110);
    }
  }

  drawNow() {
    this.isStale = true;
    this.isHasty = false;
    this.draw();
  }

  later() {
    this.frame ??= requestAnimationFrame(() => {
      this.frame = undefined;
      this.draw();
    });
  }

  draw() {
    const look = this.look();
    if (!look.mesh) return;
    const camera = this.camera.drawing(this.ratio);
    if (this.isStale && this.isHasty && this.drawn)
      this.drawCopy(camera);
    else if (this.isStale)
      this.drawCrisp(look, camera);
    drawMarks(this.marksCanvas.getContext('2d'), look.mesh, camera, look);
  }

  drawCrisp(look, camera) {
    const start = performance.now();
    drawMesh(this.meshCanvas.getContext('2d'), look.mesh, camera, look);
    this.milliseconds = performance.now() - start;
    this.isStale = false;
    this.drawn = camera;
    this.copyIsOld = true;
  }

  drawCopy(camera) {
    const {meshCanvas: canvas, copy, drawn} = this;
    if (this.copyIsOld) {
      copy.width = canvas.width;
      copy.height = canvas.height;
      copy.getContext('2d').drawImage(canvas, 0, 0);
      this.copyIsOld = false;
    }
    const factor = camera.scale / drawn.scale;
    const left = camera.left + (drawn.x - drawn.left / drawn.scale - camera.x) * camera.scale;
    const top = camera.top - (drawn.y + drawn.top / drawn.scale - camera.y) * camera.scale;
    const context = canvas.getContext('2d');
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, canvas.width, canvas.height);
    context.drawImage(copy, left, top, copy.width * factor, copy.height * factor);
  }

  // Where the element stands in the middle, large enough to be seen in its surroundings.
  viewOf(mesh, t) {
    const box = mesh.boxes.subarray(4 * t, 4 * t + 4);
    const target = new Camera();
    target.resize(this.camera.width, this.camera.height);
    target.fit([...box], 0.36);
    return {x: target.x, y: target.y, scale: this.camera.limited(Math.max(target.scale, this.camera.fitted))};
  }
  lookAt(mesh, t) {
    Object.assign(this.camera, this.viewOf(mesh, t));
  }
  centreOn(mesh, t) {
    const {x, y, scale} = this.viewOf(mesh, t);
    this.glide(x, y, scale);
  }

  glide(x, y, scale) {
    const {camera} = this, from = {x: camera.x, y: camera.y, scale: camera.scale};
    const start = performance.now();
    const length = matchMedia('(prefers-reduced-motion: reduce)').matches ? 0 : 380;
    cancelAnimationFrame(this.gliding);
    const step = (now) => {
      const part = length > 0 ? Math.min(1, Math.max(0, (now - start) / length)) : 1;
      const s = part * part * (3 - 2 * part);
      camera.scale = part === 1 ? scale : from.scale * (scale / from.scale) ** s;
      // The target moves evenly on the screen, whatever the zoom.
      const left = ((1 - s) * from.scale) / camera.scale;
      camera.x = x + left * (from.x - x);
      camera.y = y + left * (from.y - y);
      this.moved();
      this.gliding = part < 1 ? requestAnimationFrame(step) : undefined;
    };
    step(start + (length > 0 ? 0 : 1));
  }
  stopGliding() {
    cancelAnimationFrame(this.gliding);
    this.gliding = undefined;
  }
}
