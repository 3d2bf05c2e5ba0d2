// What the scripts of this folder, and samples/gallery/browser.mjs, share: headless Chromium, a page of three.js with
// the file that it shows, and claims of which those that fail are counted.
import { existsSync, readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { chromium } from 'playwright-core';

export const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium';
export const args = ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking',
  '--disable-component-update', '--disable-sync'];
export const launch = () => chromium.launch({ executablePath, args });

// Serves the page at / and three.js at /npm/; a request for /file gets what `fileOf` makes of its query.
export async function serve(page, fileOf) {
  const server = createServer((request, response) => {
    const { pathname, search } = new URL(request.url, 'http://localhost');
    const path = new URL(`./node_modules/${pathname.slice(5)}`, import.meta.url);
    if (pathname === '/') response.setHeader('content-type', 'text/html').end(page);
    else if (pathname === '/file') response.end(readFileSync(fileOf(search.slice(1))));
    else if (pathname.startsWith('/npm/') && existsSync(path))
      response.setHeader('content-type', 'text/javascript').end(readFileSync(path));
    else response.writeHead(404).end();
  });
  await new Promise((ready) => server.listen(0, '127.0.0.1', ready));
  return { address: `http://127.0.0.1:${server.address().port}/`, close: () => server.close() };
}

// Opens a page that three.js draws, and waits until it has.
export async function opened(tab, address) {
  await tab.goto(address);
  await tab.waitForFunction(() => document.title === 'ready', { timeout: 60000 });
}

let failed = 0;
export function check(claim, good, seen = '') {
  console.log(`${good ? 'ok    ' : 'FAILED'} ${claim}${good && seen === '' ? '' : `: ${seen}`}`);
  if (!good) failed++;
}
export const exit = () => process.exit(failed ? 1 : 0);
