// curves.js: edges as paths of a canvas, exact at every zoom. Coordinates are computed in doubles and handed over only
// where they are near the window, since canvases round to single precision.

const farAway = 16000;  // device pixels

// From here the camera of a drawing: {x, y, scale, left, top, width, height}: a point p is at left + (p.x - x) * scale.
function loadEdge(mesh, t, e, camera, out) {
  const index = mesh.edgeIndex[e], first = t * mesh.netSize, {points, nets} = mesh;
  for (let k = 0; k < index.length; k++) {
    const q = 2 * nets[first + index[k]];
    out[2 * k] = camera.left + (points[q] - camera.x) * camera.scale;
    out[2 * k + 1] = camera.top - (points[q + 1] - camera.y) * camera.scale;
  }
}

// The two halves of a Bezier curve, by de Casteljau.
function halves(curve) {
  const size = curve.length, first = new Float64Array(size), second = new Float64Array(size);
  const rest = Float64Array.from(curve);
  for (let r = 0; 2 * r < size; r++) {
    first[2 * r] = rest[0];
    first[2 * r + 1] = rest[1];
    second[size - 2 * r - 2] = rest[size - 2 * r - 2];
    second[size - 2 * r - 1] = rest[size - 2 * r - 1];
    for (let k = 0; k + 2 < size - 2 * r; k++) rest[k] = (rest[k] + rest[k + 2]) / 2;
  }
  return [first, second];
}

function boxOf(curve) {
  let left = Infinity, low = Infinity, right = -Infinity, high = -Infinity;
  for (let k = 0; k < curve.length; k += 2) {
    left = Math.min(left, curve[k]);
    right = Math.max(right, curve[k]);
    low = Math.min(low, curve[k + 1]);
    high = Math.max(high, curve[k + 1]);
  }
  return [left, low, right, high];
}

// How far the curve may be from its chord.
function bulgeOf(curve) {
  const last = curve.length - 2;
  let most = 0;
  for (let k = 2; k < last; k += 2) {
    const s = k / last;
    most = Math.max(
        most,
        Math.hypot(
            curve[k] - curve[0] - s * (curve[last] - curve[0]),
            curve[k + 1] - curve[1] - s * (curve[last + 1] - curve[1])));
  }
  return most;
}

const clampFar = (value) => Math.max(-farAway, Math.min(2 * farAway, value));

// Goes on from the curve's first point to its last.
function traceCurve(path, curve, camera, depth = 0) {
  const last = curve.length - 2, degree = last / 2;
  const [left, low, right, high] = boxOf(curve);
  if (left < -farAway || low < -farAway || right > 2 * farAway || high > 2 * farAway) {
    // A piece that lies on one side of the window may be any path on that side: the picture is the same.
    const isOutside = right < -9 || left > camera.width + 9 || high < -9 || low > camera.height + 9;
    if (isOutside || depth > 60) {
      path.lineTo(clampFar(curve[last]), clampFar(curve[last + 1]));
      return;
    }
  } else if (degree === 1) {
    path.lineTo(curve[2], curve[3]);
    return;
  } else if (degree === 2) {
    path.quadraticCurveTo(curve[2], curve[3], curve[4], curve[5]);
    return;
  } else if (degree === 3) {
    path.bezierCurveTo(curve[2], curve[3], curve[4], curve[5], curve[6], curve[7]);
    return;
  } else if (bulgeOf(curve) < 0.08 || depth > 60) {
    // Canvases have no curves of degree above 3: lines, a twelfth of a pixel from the curve at most.
    path.lineTo(curve[last], curve[last + 1]);
    return;
  }
  for (const half of halves(curve)) traceCurve(path, half, camera, depth + 1);
}

// A straight line of its own, between two points of the drawing.
function traceLine(path, from, to, camera) {
  path.moveTo(...from.map(clampFar));
  traceCurve(path, [...from, ...to], camera);
}

// A circle as cubic curves. n of them are within 1.12 / n^6 radii of it, which here is a twentieth of a pixel at most.
function traceCircle(path, [x, y], radius, camera) {
  const n = Math.max(4, Math.ceil((22.4 * radius) ** (1 / 6))), step = (2 * Math.PI) / n;
  const leg = (4 / 3) * Math.tan(step / 4) * radius;
  path.moveTo(clampFar(x + radius), clampFar(y));
  for (let k = 0; k < n; k++) {
    const [c0, s0, c1, s1] = [k, k + 1].flatMap((at) => [Math.cos(at * step), Math.sin(at * step)]);
    const [x0, y0, x1, y1] = [x + radius * c0, y + radius * s0, x + radius * c1, y + radius * s1];
    traceCurve(path, [x0, y0, x0 - leg * s0, y0 + leg * c0, x1 + leg * s1, y1 - leg * c1, x1, y1], camera);
  }
  path.closePath();
}

const scratchCurves = new Map();
function scratchCurve(degree) {
  if (!scratchCurves.has(degree)) scratchCurves.set(degree, new Float64Array(2 * degree + 2));
  return scratchCurves.get(degree);
}

// One edge of its own.
function traceEdge(path, mesh, t, e, camera) {
  const curve = scratchCurve(mesh.degree), last = curve.length - 2;
  loadEdge(mesh, t, e, camera, curve);
  path.moveTo(clampFar(curve[0]), clampFar(curve[1]));
  const isNear = Math.abs(curve[0]) < farAway && Math.abs(curve[1]) < farAway && Math.abs(curve[last]) < farAway &&
      Math.abs(curve[last + 1]) < farAway;
  if (isNear && mesh.bulges[3 * t + e] * camera.scale < 0.1)
    path.lineTo(curve[last], curve[last + 1]);
  else
    traceCurve(path, curve, camera);
}

// The outline of an element, closed.
function traceElement(path, mesh, t, camera) {
  const curve = scratchCurve(mesh.degree), last = curve.length - 2;
  for (let e = 0; e < 3; e++) {
    loadEdge(mesh, t, e, camera, curve);
    if (e === 0) path.moveTo(clampFar(curve[0]), clampFar(curve[1]));
    const isNear = Math.abs(curve[0]) < farAway && Math.abs(curve[1]) < farAway && Math.abs(curve[last]) < farAway &&
        Math.abs(curve[last + 1]) < farAway;
    if (isNear && mesh.bulges[3 * t + e] * camera.scale < 0.1)
      path.lineTo(curve[last], curve[last + 1]);
    else
      traceCurve(path, curve, camera);
  }
  path.closePath();
}
