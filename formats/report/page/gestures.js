// gestures.js: pointers, wheel and keys on the drawing.

function listenToGestures(stage, {pick, pointAt, release, focus}) {
  const canvas = stage.marksCanvas, {camera} = stage;
  const pointers = new Map();
  let moved = 0;
  const place = (event) => {
    const box = canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const zoomed = (factor, at) => {
    stage.stopGliding();
    camera.zoom(factor, ...(at ?? []));
    stage.moved();
  };

  canvas.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    stage.stopGliding();
    canvas.setPointerCapture(event.pointerId);
    if (pointers.size === 0) moved = 0;
    pointers.set(event.pointerId, place(event));
  });
  canvas.addEventListener('pointermove', (event) => {
    const to = place(event), from = pointers.get(event.pointerId);
    if (!from) {
      pointAt(...camera.toPlane(...to));
      return;
    }
    pointers.set(event.pointerId, to);
    const dx = to[0] - from[0], dy = to[1] - from[1];
    moved += Math.hypot(dx, dy);
    if (moved < 4) return;
    canvas.classList.add('moving');
    const other = [...pointers].find(([id]) => id !== event.pointerId)?.[1];
    if (other) {
      // Two fingers: their distance zooms about the one that rests, and half of the motion is each one's.
      const before = Math.hypot(from[0] - other[0], from[1] - other[1]);
      const after = Math.hypot(to[0] - other[0], to[1] - other[1]);
      camera.move(dx / 2, dy / 2);
      if (before > 1 && after > 1) camera.zoom(after / before, (to[0] + other[0]) / 2, (to[1] + other[1]) / 2);
    } else {
      camera.move(dx, dy);
    }
    stage.moved();
  });
  const lift = (event) => {
    if (!pointers.delete(event.pointerId)) return;
    canvas.classList.remove('moving');
    if (event.type === 'pointerup' && moved < 4 && pointers.size === 0) pick(...camera.toPlane(...place(event)));
  };
  canvas.addEventListener('pointerup', lift);
  canvas.addEventListener('pointercancel', lift);
  canvas.addEventListener('pointerleave', () => pointAt());
  canvas.addEventListener('dblclick', (event) => zoomed(2, place(event)));
  canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    const unit = event.deltaMode === 1 ? 18 : event.deltaMode === 2 ? 400 : 1;
    const delta = Math.max(-300, Math.min(300, event.deltaY * unit));
    zoomed(Math.exp(-delta * (event.ctrlKey ? 0.01 : 0.0022)), place(event));
  }, {passive: false});

  const step = 60;
  const keys = {
    ArrowLeft: () => camera.move(step, 0),
    ArrowRight: () => camera.move(-step, 0),
    ArrowUp: () => camera.move(0, step),
    ArrowDown: () => camera.move(0, -step),
    '+': () => camera.zoom(1.35),
    '=': () => camera.zoom(1.35),
    '-': () => camera.zoom(1 / 1.35),
    0: () => camera.fit(stage.box),
    Home: () => camera.fit(stage.box),
    Enter: () => pick(camera.x, camera.y),
    Escape: release,
  };
  canvas.addEventListener('keydown', (event) => {
    if (!keys[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    stage.stopGliding();
    keys[event.key]();
    stage.moved();
  });
  canvas.addEventListener('focus', () => focus(canvas.matches(':focus-visible')));
  canvas.addEventListener('blur', () => focus(false));

  byId('zoom-in').onclick = () => zoomed(1.6);
  byId('zoom-out').onclick = () => zoomed(1 / 1.6);
  byId('fit').onclick = () => {
    stage.stopGliding();
    camera.fit(stage.box);
    stage.moved();
  };
}
