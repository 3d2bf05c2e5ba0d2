// node browser.mjs FILE.glb PICTURE.png: shows a glTF file in headless Chromium by three.js, at an angle and in light,
// and takes a screenshot. Its packages are those of tests/browser (npm ci there).
import { launch, opened, serve } from '../../tests/browser/chromium.mjs';

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
const server = await serve(page, () => file);
const browser = await launch();
try {
  const tab = await browser.newPage({ viewport: { width: 640, height: 400 } });
  await opened(tab, server.address);
  await tab.screenshot({ path: picture });
} finally {
  await browser.close();
  server.close();
}
