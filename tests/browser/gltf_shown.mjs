// node gltf_shown.mjs FILE: opens a series of one, three and one round cells (one frame a second) in three.js, and
// compares the coloured part of the picture at several times with the area of the cells.
import { existsSync, readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { chromium } from 'playwright-core';

const page = `<!doctype html><script type="importmap">{"imports": {"three": "/npm/three/build/three.module.js",
"three/addons/": "/npm/three/examples/jsm/"}}</script><script type="module">
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
const renderer = new THREE.WebGLRenderer({ preserveDrawingBuffer: true });
renderer.setSize(600, 600);
const gltf = await new GLTFLoader().loadAsync('/file');
const scene = new THREE.Scene();
scene.background = new THREE.Color('white');
scene.add(gltf.scene);
const camera = new THREE.OrthographicCamera(-5, 5, 5, -5, 0.1, 10);
camera.position.z = 5;
const mixer = new THREE.AnimationMixer(gltf.scene);
const canvas = document.createElement('canvas');
canvas.width = canvas.height = 600;
// The part of a picture of 10 by 10 that is not white, in units of area.
window.covered = (time) => {
  if (time !== null) {
    gltf.animations.forEach((clip) => mixer.clipAction(clip).play());
    mixer.setTime(time);
  }
  renderer.render(scene, camera);
  const context = canvas.getContext('2d');
  context.drawImage(renderer.domElement, 0, 0, 600, 600);
  const data = context.getImageData(0, 0, 600, 600).data;
  let count = 0;
  for (let i = 0; i < data.length; i += 4) if (data[i] + data[i + 1] + data[i + 2] < 720) count++;
  return count / 3600;
};
document.title = 'ready';
</script>`;

const server = createServer((request, response) => {
  const path = new URL(`./node_modules/${request.url.slice(5)}`, import.meta.url);
  if (request.url === '/') response.setHeader('content-type', 'text/html').end(page);
  else if (request.url === '/file') response.end(readFileSync(process.argv[2]));
  else if (request.url.startsWith('/npm/') && existsSync(path))
    response.setHeader('content-type', 'text/javascript').end(readFileSync(path));
  else response.writeHead(404).end();
});
await new Promise((ready) => server.listen(0, '127.0.0.1', ready));
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  args: ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking',
    '--disable-component-update', '--disable-sync'],
});
let failed = 0;
try {
  const tab = await browser.newPage();
  tab.on('pageerror', (error) => console.log(String(error)));
  await tab.goto(`http://127.0.0.1:${server.address().port}/`);
  await tab.waitForFunction(() => document.title === 'ready', { timeout: 60000 });
  // Areas of the hand-made cells of degree 2 with 8 spans: 2.6 times the square of the radius, and their outlines.
  const one = 2.62, three = one * (1 + 1 + 1.25 * 1.25);
  for (const [time, expected] of [[null, one], [0.5, one], [1.5, three], [2.5, one]]) {
    const area = await tab.evaluate((at) => window.covered(at), time);
    const good = Math.abs(area - expected) < 0.05 * expected;
    console.log(`${good ? 'ok    ' : 'FAILED'} at ${time ?? 'rest'}: area ${area.toFixed(2)}, expected ${expected.toFixed(2)}`);
    if (!good) failed++;
  }
} finally {
  await browser.close();
  server.close();
}
process.exit(failed ? 1 : 0);
