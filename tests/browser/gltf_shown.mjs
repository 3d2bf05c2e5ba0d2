// node gltf_shown.mjs FOLDER: opens files in three.js. Of the series (one, three and one round cells, one frame a
// second; quantized and not) it compares the coloured part of the picture at several times with the area of the cells;
// of the cells lifted by their y it compares what is seen from the side, and the colours at the bottom and the top.
import { check, exit, launch, opened, serve } from './chromium.mjs';

const page = `<!doctype html><script type="importmap">{"imports": {"three": "/npm/three/build/three.module.js",
"three/addons/": "/npm/three/examples/jsm/"}}</script><script type="module">
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
const renderer = new THREE.WebGLRenderer({ preserveDrawingBuffer: true });
renderer.setSize(600, 600);
const gltf = await new GLTFLoader().loadAsync('/file' + location.search);
const scene = new THREE.Scene();
scene.background = new THREE.Color('white');
scene.add(gltf.scene);
const camera = new THREE.OrthographicCamera(-5, 5, 5, -5, 0.1, 10);
camera.position.z = 5;
if (location.search.includes('surface')) {
  // From the side: z upwards, so that z = (y - least y) / 2 covers half the area.
  camera.position.set(0, -8, 0);
  camera.up.set(0, 0, 1);
  camera.far = 20;
  camera.lookAt(0, 0, 0);
  camera.updateProjectionMatrix();
}
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
  window.ends = [-1, 1].map((side) => {
    // The lowest and the highest pixels that are not white, a few rows inside.
    const rows = [];
    for (let i = 0; i < data.length; i += 4)
      if (data[i] + data[i + 1] + data[i + 2] < 720) rows.push(i);
    const at = side < 0 ? rows[rows.length - 1] : rows[0], row = Math.floor(at / 2400) + side * 2;
    const inRow = rows.filter((i) => Math.floor(i / 2400) === row);
    const middle = inRow[Math.floor(inRow.length / 2)];
    return [...data.slice(middle, middle + 3)];
  });
  return count / 3600;
};
document.title = 'ready';
</script>`;

const server = await serve(page, (name) => `${process.argv[2]}/${name}.glb`);
const browser = await launch();
try {
  const tab = await browser.newPage();
  tab.on('pageerror', (error) => console.log(String(error)));
  const open = (name) => opened(tab, `${server.address}?${name}`);
  // Areas of the hand-made cells of degree 2 with 8 spans: 2.6 times the square of the radius, and their outlines.
  const one = 2.62, three = one * (1 + 1 + 1.25 * 1.25);
  for (const name of ['series', 'float']) {
    await open(name);
    for (const [time, expected] of [[null, one], [0.5, one], [1.5, three], [2.5, one]]) {
      const area = await tab.evaluate((at) => window.covered(at), time);
      check(`${name} at ${time ?? 'rest'}`, Math.abs(area - expected) < 0.05 * expected,
        `area ${area.toFixed(2)}, expected ${expected.toFixed(2)}`);
    }
  }
  // One cell, without outlines: its area is 2.6, and half of it is seen.
  await open('surface');
  const area = await tab.evaluate(() => window.covered(null));
  check('half the area is seen from the side', Math.abs(area - 1.3) < 0.05, area.toFixed(3));
  const [low, high] = await tab.evaluate(() => window.ends);
  const near = (color, expected) => color.length === 3 && color.every((part, i) => Math.abs(part - expected[i]) < 25);
  check('the bottom has the first colour', near(low, [0x44, 0x01, 0x54]), low);
  check('the top has the last colour', near(high, [0xfd, 0xe7, 0x25]), high);
} finally {
  await browser.close();
  server.close();
}
exit();
