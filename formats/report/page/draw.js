// draw.js: the elements, their edges, and the marks of those that are not valid.

const raster = new Raster();

// Elements in device pixels below which their edges fade, and are not drawn at all.
const edgesFade = 26, edgesEnd = 11;

function sizeOnScreen(mesh, t, camera) {
  const {boxes} = mesh, at = 4 * t;
  return Math.max(boxes[at + 2] - boxes[at], boxes[at + 3] - boxes[at + 1]) * camera.scale;
}

// look: {codes, palette, edges, highlight (a mask, or null), field (a choice, or undefined), range (of its colours)}
function drawMesh(context, mesh, camera, look) {
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.clearRect(0, 0, camera.width, camera.height);
  context.lineJoin = 'round';
  drawObstacles(context, camera, look.palette);
  const visible = mesh.grid.query(seenBox(camera));
  const large = drawSmallElements(context, mesh, camera, look, visible);
  drawLargeElements(context, mesh, camera, look, large);
  if (look.field && look.range) drawFieldPieces(context, mesh, camera, look, visible);
  if (look.edges) drawInnerEdges(context, mesh, camera, look, visible);
  drawBorders(context, mesh, camera, look, visible);
  if (look.highlight) outlineHighlighted(context, mesh, camera, look, visible);
  drawBadElements(context, mesh, camera, look);
}

const codeIn = (look, t) => look.codes[t] + (look.highlight && !look.highlight[t] ? dimmed : 0);

// Returns the others, by colour.
function drawSmallElements(context, mesh, camera, look, visible) {
  const large = Array.from({length: 2 * dimmed});
  const limit = smallElement * Math.max(1, camera.ratio * 0.8);
  raster.begin(camera.width, camera.height);
  for (let i = 0; i < visible.length; i++) {
    const t = visible[i];
    if (look.codes[t] === invalidCode || look.codes[t] === degenerateCode) continue;  // on top, later
    const code = codeIn(look, t);
    const size = sizeOnScreen(mesh, t, camera);
    if (size >= limit) (large[code] ??= []).push(t);
    // Large ones, too, where that is near enough: what shines through the seams between paths has their colour.
    if (size < limit || (size < farAway && raster.isNear(mesh, t, camera)))
      raster.fill(mesh, t, camera, look.palette.pixel[code]);
  }
  for (const t of mesh.bad)
    if (sizeOnScreen(mesh, t, camera) < limit) raster.fill(mesh, t, camera, look.palette.pixel[codeIn(look, t)]);
  raster.drawOn(context);
  return large;
}

function drawLargeElements(context, mesh, camera, look, large) {
  large.forEach((elements, code) => {
    if (!elements) return;
    context.beginPath();
    for (const t of elements) traceElement(context, mesh, t, camera);
    context.fillStyle = look.palette.text[code];
    context.fill();
  });
}

// A field varies in an element: those that have room for it are drawn in pieces.
function drawFieldPieces(context, mesh, camera, look, visible) {
  const elements = visible.filter(
      (t) => mesh.validity[t] === 0 && look.codes[t] !== missingCode && sizeOnScreen(mesh, t, camera) > pieceSize);
  const offset = (t) => (look.highlight && !look.highlight[t] ? dimmed : 0);
  new FieldPainter(mesh, look.field, look.range, look.palette).draw(context, camera, elements, offset);
}

function drawInnerEdges(context, mesh, camera, look, visible) {
  const classes = [[], [], []];
  const ratio = camera.ratio;
  for (let i = 0; i < visible.length; i++) {
    const t = visible[i], size = sizeOnScreen(mesh, t, camera) / ratio;
    if (size < edgesEnd) continue;
    const kind = size < 16 ? 0 : size < edgesFade ? 1 : 2;
    for (let e = 0; e < 3; e++)
      if (mesh.edgeKinds[3 * t + e] === innerEdge) classes[kind].push(3 * t + e);
  }
  context.strokeStyle = look.palette.meshLine;
  classes.forEach((halfEdges, kind) => {
    if (halfEdges.length === 0) return;
    context.beginPath();
    for (const h of halfEdges) traceEdge(context, mesh, Math.floor(h / 3), h % 3, camera);
    context.globalAlpha = [0.3, 0.45, 0.62][kind];
    context.lineWidth = [0.7, 0.85, 1][kind] * ratio;
    context.stroke();
  });
  context.globalAlpha = 1;
}

// Curves and outer edges.
function drawBorders(context, mesh, camera, look, visible) {
  context.beginPath();
  for (let i = 0; i < visible.length; i++) {
    const t = visible[i];
    for (let e = 0; e < 3; e++)
      if (mesh.edgeKinds[3 * t + e] === borderEdge) traceEdge(context, mesh, t, e, camera);
  }
  context.strokeStyle = look.palette.curve;
  context.globalAlpha = look.highlight ? 0.55 : 1;
  context.lineWidth = 1.6 * camera.ratio;
  context.stroke();
  context.globalAlpha = 1;
}

// The few that could be overlooked get a ring.
function outlineHighlighted(context, mesh, camera, look, visible) {
  const shown = [...visible].filter((t) => look.highlight[t]);
  if (shown.length > 4000) return;
  context.strokeStyle = look.palette.accent;
  context.lineWidth = 1.6 * camera.ratio;
  context.beginPath();
  for (const t of shown) {
    if (sizeOnScreen(mesh, t, camera) > 7 * camera.ratio)
      traceElement(context, mesh, t, camera);
    else if (shown.length < 300)
      ring(context, mesh, t, camera, 6 * camera.ratio);
  }
  context.stroke();
}

function middleOnScreen(mesh, t, camera) {
  const [x, y] = mesh.centre(t);
  return [camera.left + (x - camera.x) * camera.scale, camera.top - (y - camera.y) * camera.scale];
}

function ring(context, mesh, t, camera, radius) {
  const [x, y] = middleOnScreen(mesh, t, camera);
  if (!(Math.abs(x) < farAway && Math.abs(y) < farAway)) return;
  context.moveTo(x + radius, y);
  context.arc(x, y, radius, 0, 2 * Math.PI);
}

// Stripes for invalid, dots for degenerate: told apart without colour.
function badPattern(context, color, isInvalid, ratio) {
  const size = Math.round(8 * ratio);
  const tile = document.createElement('canvas');
  tile.width = tile.height = size;
  const drawing = tile.getContext('2d');
  drawing.strokeStyle = drawing.fillStyle = color;
  drawing.lineWidth = size * 0.3;
  drawing.beginPath();
  if (isInvalid) {
    for (const shift of [-size, 0, size]) {
      drawing.moveTo(shift - size, 2 * size);
      drawing.lineTo(shift + 2 * size, -size);
    }
    drawing.stroke();
  } else {
    drawing.arc(size / 2, size / 2, size * 0.24, 0, 2 * Math.PI);
    drawing.fill();
  }
  return context.createPattern(tile, 'repeat');
}

function drawBadElements(context, mesh, camera, look) {
  if (mesh.bad.length === 0) return;
  const seen = seenBox(camera, 12 * camera.ratio), {boxes} = mesh;
  const shown = mesh.bad
                    .filter(
                        (t) => boxes[4 * t] <= seen[2] && boxes[4 * t + 2] >= seen[0] && boxes[4 * t + 1] <= seen[3] &&
                            boxes[4 * t + 3] >= seen[1])
                    .sort((a, b) => mesh.validity[a] - mesh.validity[b]);
  const patterns = [1, 2].map(
      (kind) => badPattern(context, kind === 2 ? settings.invalid : settings.degenerate, kind === 2, camera.ratio));
  for (const t of shown) {
    const isInvalid = mesh.validity[t] === 2, color = isInvalid ? settings.invalid : settings.degenerate;
    const isFaint = look.highlight && !look.highlight[t];
    context.globalAlpha = isFaint ? 0.3 : 1;
    context.strokeStyle = context.fillStyle = color;
    if (sizeOnScreen(mesh, t, camera) < 15 * camera.ratio) {
      if (shown.length < 2000) drawPin(context, mesh, t, camera, look, isInvalid);
      continue;
    }
    context.beginPath();
    traceElement(context, mesh, t, camera);
    context.globalAlpha *= 0.3;
    context.fill();
    context.globalAlpha = isFaint ? 0.3 : 1;
    context.fillStyle = patterns[isInvalid ? 1 : 0];
    context.fill();
    context.lineWidth = 2.4 * camera.ratio;
    context.stroke();
  }
  context.globalAlpha = 1;
}

// A mark of fixed size at an element that is too small to be seen: a cross, or a diamond.
function drawPin(context, mesh, t, camera, look, isInvalid) {
  const [x, y] = middleOnScreen(mesh, t, camera), r = 6 * camera.ratio;
  if (!(Math.abs(x) < farAway && Math.abs(y) < farAway)) return;
  context.beginPath();
  if (isInvalid) {
    context.arc(x, y, 1.3 * r, 0, 2 * Math.PI);
  } else {
    context.moveTo(x, y - 1.4 * r);
    for (const [dx, dy] of [[1.4, 0], [0, 1.4], [-1.4, 0]]) context.lineTo(x + dx * r, y + dy * r);
    context.closePath();
  }
  context.lineWidth = 3 * camera.ratio;
  context.strokeStyle = look.palette.paper;
  context.stroke();
  context.fill();
  context.strokeStyle = '#fff';
  context.lineWidth = 1.8 * camera.ratio;
  context.beginPath();
  if (isInvalid) {
    context.moveTo(x - r * 0.55, y - r * 0.55);
    context.lineTo(x + r * 0.55, y + r * 0.55);
    context.moveTo(x + r * 0.55, y - r * 0.55);
    context.lineTo(x - r * 0.55, y + r * 0.55);
  } else {
    context.moveTo(x - r * 0.6, y);
    context.lineTo(x + r * 0.6, y);
  }
  context.stroke();
}
