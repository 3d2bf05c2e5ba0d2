// node report_view.mjs FOLDER: opens the page that report_view.sh made of a square, in which the colour of every point
// is known, and reads pixels of screenshots.
import { execFile, spawn } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { promisify } from 'node:util';
import { args, check, executablePath, exit, launch } from './chromium.mjs';

const folder = process.argv[2], address = `file://${folder}/view.html`;
const browser = await launch();
async function open(hash = '', options = {}) {
  const context = await browser.newContext({ viewport: { width: 1000, height: 700 }, offline: true, reducedMotion: 'reduce', ...options });
  const tab = await context.newPage();
  tab.on('pageerror', (error) => check('no errors', false, error));
  await tab.goto(address + hash);
  return tab;
}
// The pixels of a screenshot, decoded by a browser.
const decoder = await (await browser.newContext()).newPage();
async function pixels(png, places) {
  return decoder.evaluate(async ([data, list]) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height), context = canvas.getContext('2d');
    context.drawImage(image, 0, 0);
    return list.map(([x, y]) => [...context.getImageData(x, y, 1, 1).data.slice(0, 3)]);
  }, [png.toString('base64'), places]);
}
const on = (tab, points) => tab.evaluate((list) => list.map(([x, y]) => window.pliant.toScreen(x, y).map(Math.round)), points);
const seen = async (tab, points) => pixels(await tab.screenshot(), await on(tab, points));
// A point inside an element of the face, away from the edges that are drawn.
const inside = (tab, face) => tab.evaluate((f) => window.pliant.state.mesh.centre(window.pliant.state.mesh.faces.indexOf(f)), face);
const near = (a, b, most = 12) => a.every((part, i) => Math.abs(part - b[i]) <= most);
const first = [0x44, 0x01, 0x54], last = [0xfd, 0xe7, 0x25], middle = [0x23, 0x8a, 0x8d];

// -- plain screenshots of a plain browser: the first one shows the drawing, also where others keep the machine busy
{
  const run = promisify(execFile);
  const tab = await open('#color=field:side');
  const [place] = await on(tab, [await inside(tab, 1)]);
  await tab.context().close();
  const busy = [1, 2].map(() => spawn(process.execPath, ['-e', 'for (;;);'], { stdio: 'ignore' }));
  let drawn = 0;
  // A page that is late is blank in a quarter of the tries: eight find it in nine cases of ten. TRIES=20 is for people.
  const tries = Number(process.env.TRIES ?? 8);
  try {
    for (let i = 0; i < tries; i++) {
      const profile = mkdtempSync(`${folder}/profile-`), png = `${folder}/shot.png`;
      await run('nice', [executablePath, '--headless', '--disable-gpu', ...args, `--user-data-dir=${profile}`,
        '--window-size=1000,700', `--screenshot=${png}`, `${address}#color=field:side`], { timeout: 60000 });
      // The window's height may leave less to the page: any of the field's colours near the place will do.
      if (existsSync(png)) {
        const around = [0, -20, 20, -40, 40].map((dy) => [place[0], place[1] + dy]);
        if ((await pixels(readFileSync(png), around)).some((color) => near(color, last))) drawn++;
      }
      rmSync(png, { force: true });
      rmSync(profile, { recursive: true, force: true });
    }
  } finally {
    busy.forEach((child) => child.kill());
  }
  check('every first screenshot is drawn', drawn === tries, `${drawn} of ${tries}`);
}

// -- fields in their colours; obstacles; what the pointer reads
{
  const tab = await open('#color=field:x');
  const [left, centre, right] = await seen(tab, [[-0.97, 0.13], [0.02, 0.13], [0.97, 0.13]]);
  check('a field has its colours', near(left, first, 20) && near(centre, middle, 25) && near(right, last, 20), [left, centre, right].join(' | '));
  const [disk, wall, paper] = await seen(tab, [[-2, 0], [2.5, 0], [-1.5, 0.9]]);
  check('obstacles are drawn', near(disk, [0xd3, 0xd7, 0xdc], 2) && near(wall, disk, 2), `${disk} and ${wall}`);
  check('and nothing elsewhere', near(paper, [255, 255, 255], 0), paper);
  const [place] = await on(tab, [[0.25, 0.4]]);
  await tab.mouse.move(...place);
  const words = await tab.locator('#pointer').textContent(), value = Number(/field x ([-.\d]+)/.exec(words)?.[1]);
  check('the pointer reads the field', Math.abs(value - 0.25) < 0.01, words);
  await tab.selectOption('#metric', 'field:side');
  await tab.mouse.move(2, 2);
  const [west, east] = await seen(tab, [await inside(tab, 0), await inside(tab, 1)]);
  check('a field by face jumps', near(west, first) && near(east, last), `${west} and ${east}`);
  check('the range is that of the field', (await tab.inputValue('#range-low')) === '0' && (await tab.inputValue('#range-high')) === '1');
  check('the history of the document is shown', (await tab.locator('#summary-panel').textContent()).includes('--degree 2'));
  await tab.context().close();
}

// -- addresses
{
  const tab = await open('#frame=3&element=5');
  const heading = () => tab.locator('#element-panel h2').textContent();
  check('an address opens its frame', (await tab.evaluate(() => window.pliant.state.frame)) === 3);
  check('and its element', (await heading()) === 'Element 5');
  const [middleOfIt] = await tab.evaluate(() => [window.pliant.toScreen(...window.pliant.state.mesh.centre(window.pliant.state.selected))]);
  const paper = await tab.locator('#paper').boundingBox();
  check('in the middle', Math.hypot(middleOfIt[0] - paper.x - paper.width / 2, middleOfIt[1] - paper.y - paper.height / 2) < 60, middleOfIt);
  await tab.click('#fit');
  const [other] = await on(tab, [[0.8, 0.75]]);
  await tab.mouse.click(...other);
  const chosen = await heading();
  check('a click changes the address', chosen !== 'Element 5' && tab.url().includes(`element=${chosen.slice(8)}`), tab.url());
  const copy = await open(new URL(tab.url()).hash);
  check('a copy of it opens the same', (await copy.locator('#element-panel h2').textContent()) === chosen);
  const views = await Promise.all([tab, copy].map((each) => each.evaluate(() => [window.pliant.stage.camera.x, window.pliant.stage.camera.scale])));
  check('with the same view', Math.abs(views[0][1] / views[1][1] - 1) < 1e-3, views.join(' and '));
  await tab.goBack();
  check('back goes back', (await heading()) === 'Element 5');
  await tab.goForward();
  check('forward goes forward', (await heading()) === chosen);
  for (const hash of ['#frame=99&element=-1', '#frame=x&color=constructor&view=1,2', '#element=99999999&view=a,b,c', '#%%%']) {
    const odd = await open(hash);
    check(`${hash} shows the first frame`, (await odd.evaluate(() => window.pliant.state.frame)) === 0);
    await odd.context().close();
  }
}

// -- light, dark, as the system changes; paper
{
  const tab = await open('#color=field:side', { colorScheme: 'dark' });
  const points = [[-1.5, 0.9], await inside(tab, 1)];
  const [night, color] = await seen(tab, points);
  check('dark where the system is', near(night, [0x12, 0x18, 0x1e], 2) && near(color, last), `${night} and ${color}`);
  await tab.emulateMedia({ colorScheme: 'light' });
  const [day, same] = await seen(tab, points);
  check('light when it turns light', near(day, [255, 255, 255], 0) && near(same, last), `${day} and ${same}`);
  await tab.emulateMedia({ colorScheme: 'dark', media: 'print' });
  const [sheet, ink] = await seen(tab, points);
  check('paper is light', near(sheet, [255, 255, 255], 0) && near(ink, last), `${sheet} and ${ink}`);
  for (const id of ['#zoom', '#layers', '#player', '#range-row']) check(`${id} is not printed`, await tab.locator(id).isHidden());
  check('tables are printed', await tab.locator('#summary-panel table').first().isVisible());
  await tab.emulateMedia({ colorScheme: 'dark', media: 'screen' });
  check('and the screen is dark again', near((await seen(tab, points))[0], [0x12, 0x18, 0x1e], 2));
  check('a PDF comes out', (await tab.pdf({ format: 'A4', printBackground: true })).length > 10000);
  await tab.context().close();
}

await browser.close();
exit();
