// pick.js: which elements contain a point: the winding number of their curved outlines, exact to rounding.

// Signed crossings of the curve with the ray from (x, y) to the right. A piece whose box is beside the point may be
// replaced by its chord.
function crossings(curve, x, y, depth = 0) {
  const last = curve.length - 2;
  const [left, low, right, high] = boxOf(curve);
  if (right < x || low > y || high <= y) return 0;
  if (left > x || depth > 50) {
    if (depth > 50 && (curve[0] + curve[last]) / 2 < x) return 0;
    if (curve[1] <= y && curve[last + 1] > y) return 1;
    return curve[1] > y && curve[last + 1] <= y ? -1 : 0;
  }
  const [first, second] = halves(curve);
  return crossings(first, x, y, depth + 1) + crossings(second, x, y, depth + 1);
}

function contains(mesh, t, x, y) {
  const curve = scratchCurve(mesh.degree);
  const plain = {x: 0, y: 0, scale: 1, left: 0, top: 0};
  let winding = 0;
  for (let e = 0; e < 3; e++) {
    loadEdge(mesh, t, e, plain, curve);
    // Drawings have y downwards; here it is turned back.
    for (let k = 1; k < curve.length; k += 2) curve[k] = -curve[k];
    winding += crossings(curve, x, y);
  }
  return winding !== 0;
}

// The elements at a point, those drawn on top first: invalid, degenerate, valid.
function elementsAt(mesh, x, y) {
  return [...mesh.grid.query([x, y, x, y])]
      .filter((t) => contains(mesh, t, x, y))
      .sort((a, b) => mesh.validity[b] - mesh.validity[a] || b - a);
}
