// node browser.mjs FILE.glb PICTURE.png: shows a glTF file in headless Chromium by three.js, at an angle and in light,
// and takes a screenshot. Its packages are those of tests/browser (npm ci there).
import { existsSync, readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';

const packages = new URL('../../tests/browser/', import.meta.url);
const { chromium } = createRequire(new URL('package.json', packages))('playwright-core');
const [file, picture] = process.argv.slice(2);
const page = `<!doctype html><style>body { margin: 0 }</style>
<script type="importmap">{"imports": {"three": "/npm/three/build/three.module.js",
"three/addons/": "/npm/three/examples/jsm/"}}</script><script type="module">
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
const renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
renderer.setSize(innerWidth, innerHeight);
document.body.append(renderer.domElement);
const gltf = await new GLTFLoader().loadAsync('/file');
const scene = new THREE.Scene();
scene.background = new THREE.Color('white');
scene.add(gltf.scene, new THREE.AmbientLight('white', 1.6));
const light = new THREE.DirectionalLight('white', 2.2);
light.position.set(-3, -2, 5);
scene.add(light);
const sphere = new THREE.Box3().setFromObject(gltf.scene).getBoundingSphere(new THREE.Sphere());
const camera = new THREE.PerspectiveCamera(30, innerWidth / innerHeight, sphere.radius / 100, sphere.radius * 100);
camera.up.set(0, 0, 1);
camera.position.copy(sphere.center).add(new THREE.Vector3(-0.8, -2.3, 1.6).multiplyScalar(sphere.radius * 0.75));
camera.lookAt(sphere.center);
renderer.render(scene, camera);
document.title = 'ready';
</script>`;
const server = createServer((request, response) => {
  const path = new URL(`node_modules/${request.url.slice(5)}`, packages);
  if (request.url === '/') response.setHeader('content-type', 'text/html').end(page);
  else if (request.url === '/file') response.end(readFileSync(file));
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
try {
  const tab = await browser.newPage({ viewport: { width: 640, height: 400 } });
  await tab.goto(`http://127.0.0.1:${server.address().port}/`);
  await tab.waitForFunction(() => document.title === 'ready', { timeout: 60000 });
  await tab.screenshot({ path: picture });
} finally {
  await browser.close();
  server.close();
}
