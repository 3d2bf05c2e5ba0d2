// obstacles.js: what stands in the plane beside the mesh: disks, and outlines of drawings.

function obstacleBoxes() {
  const disks = settings.circles.map(([x, y, r]) => [x - r, y - r, x + r, y + r]);
  return [...disks, ...settings.outlines.map((outline) => boxOf(outline))];
}

// Under the mesh.
function drawObstacles(context, camera, palette) {
  if (settings.circles.length + settings.outlines.length === 0) return;
  const place = (x, y) => [camera.left + (x - camera.x) * camera.scale, camera.top - (y - camera.y) * camera.scale];
  context.beginPath();
  for (const [x, y, r] of settings.circles) traceCircle(context, place(x, y), r * camera.scale, camera);
  for (const outline of settings.outlines) {
    let from = place(outline.at(-2), outline.at(-1));
    context.moveTo(...from.map(clampFar));
    for (let k = 0; k < outline.length; k += 2) {
      const to = place(outline[k], outline[k + 1]);
      traceCurve(context, [...from, ...to], camera);
      from = to;
    }
    context.closePath();
  }
  context.fillStyle = palette.obstacle;
  context.strokeStyle = palette.soft;
  context.lineWidth = camera.ratio;
  context.fill('evenodd');
  context.stroke();
}
