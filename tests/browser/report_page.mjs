// node report_page.mjs FOLDER: opens the pages that report_page.sh made, and compares what they show with the tables
// (CSV) of the same meshes.
import { readFileSync } from 'node:fs';
import { check, exit, launch } from './chromium.mjs';

const folder = process.argv[2];
const browser = await launch();

// No cell of these tables holds a comma, but for names of faces, which are left out.
function table(name) {
  const [head, ...rows] = readFileSync(`${folder}/${name}.csv`, 'utf8').trim().split('\n').map((line) => line.split(','));
  return rows.map((row) => Object.fromEntries(head.map((column, i) => [column, row[i]])));
}

// Opens a page with the network off; anything it asks for, or complains of, is a failure.
async function open(name, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, offline: true, reducedMotion: 'reduce', ...options });
  const tab = await context.newPage();
  const complaints = [];
  tab.on('pageerror', (error) => complaints.push(String(error)));
  tab.on('console', (message) => { if (message.type() === 'error') complaints.push(message.text()); });
  tab.on('request', (request) => { if (request.url() !== `file://${folder}/${name}.html`) complaints.push(request.url()); });
  await tab.goto(`file://${folder}/${name}.html`);
  await tab.waitForFunction(() => window.pliant?.state.frame === 0 && window.pliant.stage.drawn);
  tab.finish = async () => {
    check(`${name}: no errors, no requests`, complaints.length === 0, complaints.join('; '));
    await context.close();
  };
  return tab;
}

const clickAt = async (tab, row) => {
  const [x, y] = await tab.evaluate(([px, py]) => window.pliant.toScreen(px, py), [Number(row.x), Number(row.y)]);
  await tab.mouse.click(x, y);
};
const figure = (tab, name) => tab.locator(`[data-figure=${name}]`).getAttribute('data-value');
const settled = (tab) => tab.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

// The colour that is seen at a point of the mesh.
async function pixelAt(tab, x, y) {
  return tab.evaluate(([px, py]) => {
    const canvas = document.getElementById('mesh'), box = canvas.getBoundingClientRect();
    const [sx, sy] = window.pliant.toScreen(px, py);
    const ratio = canvas.width / box.width;
    return [...canvas.getContext('2d').getImageData((sx - box.left) * ratio, (sy - box.top) * ratio, 1, 1).data];
  }, [x, y]);
}

// -- a click on an element's barycentre shows that element's figures, at every degree
for (const degree of [1, 2, 3, 5]) {
  const tab = await open(`p${degree}`);
  const rows = table(`p${degree}`);
  let right = 0;
  for (const row of rows.slice(0, 12)) {
    await clickAt(tab, row);
    const heading = await tab.locator('#element-panel h2').textContent();
    const same = ['shape', 'jacobian', 'element_area'].map(async (name) => (await figure(tab, name)) === String(Number(row[name])));
    if (heading === `Element ${row.triangle}` && (await Promise.all(same)).every(Boolean)) right++;
  }
  check(`degree ${degree}: clicks show the figures of the element`, right === 12, `${right} of 12`);
  await tab.keyboard.press('Escape');
  check(`degree ${degree}: Escape lets go`, await tab.locator('#element-panel').isHidden());
  await tab.finish();
}

// -- metric, histogram, worst elements
{
  const tab = await open('p2');
  const rows = table('p2');
  for (const metric of ['distortion', 'element_area', 'logical_angle']) {
    await tab.selectOption('#metric', metric);
    const bars = await tab.locator('.bar').evaluateAll((all) => all.map((bar) => Number(bar.dataset.count)));
    check(`${metric}: bars hold all elements`, bars.reduce((a, b) => a + b, 0) === rows.length);
    const bar = tab.locator('.bar').nth(bars.findIndex((number) => number > 0));
    await bar.click();
    const lit = await tab.evaluate(() => window.pliant.highlighted());
    check(`${metric}: a bar highlights its elements`, lit === Number(await bar.getAttribute('data-count')), lit);
    check(`${metric}: and says how many`, (await tab.locator('#histogram-caption').textContent()).startsWith(`${lit} element`));
    await bar.click();
    const worst = metric === 'distortion' ? Math.max : Math.min;
    const first = tab.locator('#worst-panel button').first();
    const expected = worst(...rows.map((row) => Number(row[metric])));
    await first.click();
    check(`${metric}: the first of the worst is the worst`, Number(await figure(tab, metric)) === expected, expected);
    const triangle = await first.getAttribute('data-element');
    const off = await tab.evaluate(([x, y]) => {
      const [sx, sy] = window.pliant.stage.camera.toScreen(x, y);
      return Math.hypot(sx - window.pliant.stage.camera.width / 2, sy - window.pliant.stage.camera.height / 2);
    }, ['x', 'y'].map((name) => Number(rows[triangle][name])));
    check(`${metric}: and is centred`, off < 150, `${off.toFixed(0)} pixels off`);
  }
  check('as many worst as were asked for', (await tab.locator('#worst-panel button').count()) === 7);
  await tab.selectOption('#metric', 'face');
  const kind = tab.locator('.kind').nth(1);
  await kind.click();
  check('a face highlights its elements',
    (await tab.evaluate(() => window.pliant.highlighted())) === Number((await kind.locator('td').textContent()).replace(',', '')));
  await tab.finish();
}

// -- zoom and pan: what is under the pointer stays there; deep zoom keeps the curve where it is
{
  const tab = await open('p3');
  const row = table('p3')[3];
  const pointer = (await tab.evaluate(([x, y]) => window.pliant.toScreen(x, y), [Number(row.x), Number(row.y)])).map(Math.round);
  // Pointers stand on whole pixels, so what is zoomed in on is near the barycentre.
  const target = await tab.evaluate(([sx, sy]) => {
    const box = document.getElementById('marks').getBoundingClientRect();
    return window.pliant.stage.camera.toPlane(sx - box.left, sy - box.top);
  }, pointer);
  await tab.mouse.move(...pointer);
  for (let i = 0; i < 60; i++) await tab.mouse.wheel(0, -300);
  await settled(tab);
  const after = await tab.evaluate(([x, y]) => window.pliant.toScreen(x, y), target);
  check('the wheel zooms about the pointer', Math.hypot(after[0] - pointer[0], after[1] - pointer[1]) < 2, after);
  check('far in', await tab.evaluate(() => window.pliant.stage.camera.scale > 1e10 * window.pliant.stage.camera.fitted));
  const inside = await pixelAt(tab, ...target);
  check('and the element fills the window', inside[3] === 255, inside);
  await tab.mouse.click(...pointer);
  check('and can be clicked', (await tab.locator('#element-panel h2').textContent()) === `Element ${row.triangle}`);
  // The point of a curved edge at its middle: inside on one side, another element or nothing on the other.
  const split = await tab.evaluate(() => {
    const { mesh } = window.pliant.state, { stage } = window.pliant;
    let t = 0;
    mesh.bulges.forEach((bulge, h) => { if (bulge > Math.max(...mesh.bulges.slice(3 * t, 3 * t + 3))) t = Math.floor(h / 3); });
    const point = (k) => mesh.points.slice(2 * mesh.nets[t * mesh.netSize + k], 2 * mesh.nets[t * mesh.netSize + k] + 2);
    let most = 0, chosen = 0;
    for (let e = 0; e < 3; e++) {
      const [a, b, c, d] = mesh.edgeIndex[e].map(point);
      const bend = Math.hypot(b[0] + c[0] - a[0] - d[0], b[1] + c[1] - a[1] - d[1]);
      if (bend > most) [most, chosen] = [bend, e];
    }
    const [a, b, c, d] = mesh.edgeIndex[chosen].map(point);
    const at = [0, 1].map((i) => (a[i] + 3 * b[i] + 3 * c[i] + d[i]) / 8);
    const along = [0, 1].map((i) => d[i] + c[i] - b[i] - a[i]);
    const length = Math.hypot(...along);
    Object.assign(stage.camera, { x: at[0], y: at[1], scale: stage.camera.fitted * 1e8 });
    window.pliant.redraw();
    const step = 12 / stage.camera.scale;
    return { bend: most, left: [at[0] - (step * along[1]) / length, at[1] + (step * along[0]) / length],
      right: [at[0] + (step * along[1]) / length, at[1] - (step * along[0]) / length] };
  });
  const [left, right] = [await pixelAt(tab, ...split.left), await pixelAt(tab, ...split.right)];
  check('a curve is where it should be, 10^8 times enlarged', split.bend > 0 && String(left) !== String(right), `${left} and ${right}`);
  await tab.click('#fit');
  await tab.locator('#marks').focus();
  const scale = await tab.evaluate(() => window.pliant.stage.camera.scale);
  await tab.keyboard.press('+');
  check('keys zoom', (await tab.evaluate(() => window.pliant.stage.camera.scale)) > 1.2 * scale);
  const x = await tab.evaluate(() => window.pliant.stage.camera.x);
  await tab.keyboard.press('ArrowRight');
  check('keys move', (await tab.evaluate(() => window.pliant.stage.camera.x)) > x);
  await tab.finish();
}

// -- invalid elements show, a name full of markup is text
{
  const tab = await open('tangled');
  const bad = readFileSync(`${folder}/tangled.csv`, 'utf8').split('\n').filter((line) => line.includes(',invalid,')).length;
  check('the verdict counts the invalid', (await tab.locator('#verdict').textContent()).includes(`${bad} invalid`));
  check('each of them can be visited', (await tab.locator('#problems-panel button').count()) === bad);
  await tab.locator('#problems-panel button').first().click();
  await settled(tab);
  await tab.screenshot({ path: `${folder}/tangled.png` });
  const share = await tab.evaluate(() => {
    const canvas = document.getElementById('mesh');
    const data = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
    let count = 0;
    for (let i = 0; i < data.length; i += 4) if (data[i] > 240 && data[i + 1] < 40 && Math.abs(data[i + 2] - 158) < 30 && data[i + 3] === 255) count++;
    return count;
  });
  check('their colour is on the drawing', share > 500, `${share} pixels`);
  check('no name became markup', (await tab.locator('#escaped').count()) === 0);
  check('but is shown as it is', (await tab.locator('#summary-panel').textContent()).includes('</script><b id=escaped>'));
  await tab.finish();
}

// -- a series: slider, history, playing
{
  const tab = await open('series');
  await tab.locator('#slider').fill('2');
  check('the slider chooses the frame', (await tab.evaluate(() => window.pliant.state.frame)) === 2);
  check('and its time is shown', (await tab.locator('#frame-label').textContent()).includes('t = 2'));
  check('there is a chart for every metric', (await tab.locator('.chart').count()) >= 12);
  const chart = await tab.locator('.chart.current svg').boundingBox();
  await tab.mouse.click(chart.x + 2, chart.y + 20);
  check('a click on the history goes to the frame', (await tab.evaluate(() => window.pliant.state.frame)) === 0);
  await tab.click('#play');
  await tab.waitForFunction(() => window.pliant.state.frame === 3, { timeout: 20000 });
  check('playing ends with the last frame', (await tab.locator('#verdict').textContent()).includes('invalid'));
  await tab.finish();
}

// -- a phone, in the dark
{
  const tab = await open('series', { viewport: { width: 375, height: 700 }, hasTouch: true, isMobile: true, colorScheme: 'dark' });
  const wide = await tab.evaluate(() => document.documentElement.scrollWidth);
  check('a narrow page does not scroll sideways', wide <= 375, `${wide} pixels wide`);
  await tab.finish();
}

// -- 50,000 elements
{
  const tab = await open('large');
  const rows = table('large');
  const times = await tab.evaluate(() => {
    const { stage, state } = window.pliant;
    const list = [];
    for (const factor of [1, 2, 4, 8, 20, 100]) {
      stage.camera.fit(stage.box);
      [stage.camera.x, stage.camera.y] = state.mesh.centre(1000);
      stage.camera.scale *= factor;
      const all = [1, 2, 3, 4, 5].map(() => window.pliant.redraw()).sort((a, b) => a - b);
      list.push(all[2]);
    }
    stage.camera.fit(stage.box);
    stage.changed();
    return list;
  });
  const words = times.map((time) => time.toFixed(0)).join(', ');
  check(`${rows.length} elements: drawn at six zooms in ${words} ms`, rows.length > 50000 && Math.max(...times) < 500);
  await tab.evaluate(([x, y]) => Object.assign(window.pliant.stage.camera, { x, y, scale: window.pliant.stage.camera.fitted * 30 }),
    ['x', 'y'].map((name) => Number(rows[4321][name])));
  await clickAt(tab, rows[4321]);
  check('a click among many', (await figure(tab, 'shape')) === String(Number(rows[4321].shape)));
  await tab.finish();
}

await browser.close();
exit();
