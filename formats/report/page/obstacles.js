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
  for (const [x, y, r] of settings.circles) {
    const [cx, cy] = place(x, y), radius = r * camera.scale;
    context.moveTo(cx + radius, cy);
    context.arc(cx, cy, radius, 0, 2 * Math.PI);
  }
  for (const outline of settings.outlines) {
    for (let k = 0; k < outline.length; k += 2) {
      const at = place(outline[k], outline[k + 1]).map(clampFar);
      if (k === 0)
        context.moveTo(...at);
      else
        context.lineTo(...at);
    }
    context.closePath();
  }
  context.fillStyle = palette.obstacle;
  context.strokeStyle = palette.soft;
  context.lineWidth = camera.ratio;
  context.fill('evenodd');
  context.stroke();
}
