// marks.js: what lies over the drawing: the chosen element, control nets, what a list points at.

const mostNets = 500;

// look: {palette, selected, pointed (elements or -1), points, crosshair}
function drawMarks(context, mesh, camera, look) {
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.clearRect(0, 0, camera.width, camera.height);
  context.lineJoin = 'round';
  for (const t of new Set([look.pointed, look.selected]))
    if (t >= 0) outline(context, mesh, t, camera, look);
  if (look.points) drawNets(context, mesh, camera, look);
  if (look.crosshair) drawCrosshair(context, camera, look);
}

function outline(context, mesh, t, camera, look) {
  context.beginPath();
  traceElement(context, mesh, t, camera);
  const isTiny = sizeOnScreen(mesh, t, camera) < 18 * camera.ratio;
  if (isTiny) ring(context, mesh, t, camera, 13 * camera.ratio);
  for (const [width, color] of [
           [5.5, look.palette.paper], [2.6, t === look.selected ? look.palette.ink : look.palette.accent]]) {
    context.lineWidth = width * camera.ratio * (isTiny ? 0.6 : 1);
    context.strokeStyle = color;
    context.stroke();
  }
}

function drawNets(context, mesh, camera, look) {
  const shown = look.selected >= 0 ? [look.selected] :
                                     [...mesh.grid.query(seenBox(camera))]
                                         .filter((t) => sizeOnScreen(mesh, t, camera) > 46 * camera.ratio)
                                         .slice(0, mostNets);
  const place = (t, n) => {
    const q = 2 * mesh.nets[t * mesh.netSize + n];
    return [
      camera.left + (mesh.points[q] - camera.x) * camera.scale,
      camera.top - (mesh.points[q + 1] - camera.y) * camera.scale
    ];
  };
  context.beginPath();
  for (const t of shown)
    for (const [a, b] of mesh.netLegs()) traceLine(context, place(t, a), place(t, b), camera);
  context.strokeStyle = look.palette.net;
  context.lineWidth = camera.ratio;
  context.globalAlpha = 0.8;
  context.stroke();
  context.globalAlpha = 1;
  context.beginPath();
  for (const t of shown) {
    for (let n = 0; n < mesh.netSize; n++) {
      const [x, y] = place(t, n).map(clampFar), r = (n < 3 ? 3.6 : 2.8) * camera.ratio;
      context.moveTo(x + r, y);
      context.arc(x, y, r, 0, 2 * Math.PI);
    }
  }
  context.fillStyle = look.palette.net;
  context.strokeStyle = look.palette.paper;
  context.lineWidth = camera.ratio;
  context.fill();
  context.stroke();
  if (look.selected >= 0) labelPoints(context, mesh, camera, look, place);
}

// The numbers of the chosen element's control points.
function labelPoints(context, mesh, camera, look, place) {
  const t = look.selected;
  if (sizeOnScreen(mesh, t, camera) < 90 * camera.ratio) return;
  context.font = `${11 * camera.ratio}px system-ui, sans-serif`;
  context.lineWidth = 3 * camera.ratio;
  context.strokeStyle = look.palette.paper;
  context.fillStyle = look.palette.ink;
  for (let n = 0; n < mesh.netSize; n++) {
    const [x, y] = place(t, n).map(clampFar), text = String(mesh.nets[t * mesh.netSize + n]);
    context.strokeText(text, x + 6 * camera.ratio, y - 5 * camera.ratio);
    context.fillText(text, x + 6 * camera.ratio, y - 5 * camera.ratio);
  }
}

// Where Enter picks, for those who use the keyboard.
function drawCrosshair(context, camera, look) {
  const x = camera.left, y = camera.top, r = 9 * camera.ratio;
  context.beginPath();
  context.moveTo(x - r, y);
  context.lineTo(x + r, y);
  context.moveTo(x, y - r);
  context.lineTo(x, y + r);
  for (const [width, color] of [[4, look.palette.paper], [1.5, look.palette.ink]]) {
    context.lineWidth = width * camera.ratio;
    context.strokeStyle = color;
    context.stroke();
  }
}
