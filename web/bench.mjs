// How long the page takes to open, and how fast its solver is against the same
// program without a browser. Run by web/bench.
//
// On 2 cores, with WebGL in software: 0.80 s from navigation to the first frame,
// 1.75 s until a test sees the solved robot, 6.3 ms of the page's thread for a
// frame of a drag. The solver takes 1.15 to 1.36 times as long as without a
// browser (goal: at most 1.5), 1.23 times for the first example (0.089 ms), reading
// its request and writing its answer included on both sides. Vector instructions
// change nothing: 0.98 to 1.03 times, scene by scene.

import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { linkOf } from './tests/link.mjs';
import { Page, stage } from './tests/page.mjs';

const SCENES = fileURLToPath(new URL('../assets/scenes/', import.meta.url));
const OPENINGS = 7;
/** The clock of a page is coarse: solves are timed many at a time. */
const SOLVES = 100;
const BATCHES = 9;

const median = (numbers) => numbers.toSorted((a, b) => a - b)[Math.floor(numbers.length / 2)];

async function opening(site) {
  const frames = [];
  const shapes = [];
  for (let time = 0; time < OPENINGS; time += 1) {
    // A new context has nothing in its caches.
    const context = await site.browser.newContext();
    const page = await Page.open(context, site.address);
    const [frame, shape] = await page.tab.evaluate(() => [
      performance.getEntriesByName('sinew-ready')[0].startTime,
      performance.now(),
    ]);
    frames.push(frame);
    shapes.push(shape);
    await context.close();
  }
  console.log(`to the first frame   ${median(frames).toFixed(0).padStart(6)} ms`);
  console.log(`to the solved robot  ${median(shapes).toFixed(0).padStart(6)} ms`);
}

/** What the page's thread does in a frame; the drawing itself is another's. */
async function dragging(site) {
  const context = await site.browser.newContext({ viewport: { width: 1280, height: 800 } });
  const tab = await context.newPage();
  await tab.addInitScript(() => {
    globalThis.frames_ms = [];
    const request = globalThis.requestAnimationFrame;
    globalThis.requestAnimationFrame = (callback) =>
      request((now) => {
        const begin = performance.now();
        callback(now);
        frames_ms.push(performance.now() - begin);
      });
  });
  const page = new Page(tab);
  const state = await page.go(site.address);
  const disc = await page.pixel(state.obstacles_mm[0]);
  await tab.evaluate(() => (frames_ms.length = 0));
  await page.drag(disc, { x: disc.x + 80, y: disc.y + 80 }, 60);
  const frames = (await tab.evaluate(() => frames_ms)).filter((time) => time > 0.5);
  console.log(`a frame of a drag    ${median(frames).toFixed(1).padStart(6)} ms`);
}

async function solving(site) {
  console.log('\nfrom request to answer       native    browser     ratio');
  const tab = await (await site.browser.newContext()).newPage();
  // The window's requests to its solver, as bytes.
  await tab.addInitScript(() => {
    const post = Worker.prototype.postMessage;
    Worker.prototype.postMessage = function (bytes, ...rest) {
      globalThis.request = bytes.slice();
      post.call(this, bytes, ...rest);
    };
  });
  const page = new Page(tab);
  const folder = mkdtempSync(join(tmpdir(), 'sinew-'));
  for (const name of readdirSync(SCENES)) {
    const file = SCENES + name;
    await tab.goto('about:blank');
    await page.go(site.address + linkOf(readFileSync(file, 'utf8')));
    await page.until('the path is known', (state) => state.path_is_current);
    const browser = median(await tab.evaluate(solves, [BATCHES, SOLVES]));
    const request = join(folder, name);
    const bytes = await tab.evaluate(() => Array.from(globalThis.request));
    writeFileSync(request, Uint8Array.from(bytes));
    const told = execFileSync(process.env.NATIVE, [BATCHES, SOLVES, request].map(String));
    const native = Number(told);
    const columns = [`${native.toFixed(3)} ms`, `${browser.toFixed(3)} ms`];
    const ratio = (browser / native).toFixed(2);
    console.log(
      `${name.padEnd(24)}${columns.map((text) => text.padStart(11)).join('')}${ratio.padStart(9)}`,
    );
  }
  rmSync(folder, { recursive: true });
}

/** Milliseconds that the worker's program takes from a request to its answer,
 * in each of some batches of solves; in the page. */
async function solves([batches, count]) {
  const folder = new URL('.', document.querySelector('script[type=module]').src);
  const { default: start, Solver } = await import(new URL('sinew-worker.js', folder));
  await start({ module_or_path: new URL('sinew-worker_bg.wasm', folder) });
  const times = [];
  for (let batch = 0; batch < batches; batch += 1) {
    const solvers = Array.from({ length: count }, () => new Solver());
    const begin = performance.now();
    for (const solver of solvers) {
      solver.take(globalThis.request);
      while (!solver.work());
    }
    times.push((performance.now() - begin) / count);
    solvers.forEach((solver) => solver.free());
  }
  return times;
}

const site = await stage();
await opening(site);
await dragging(site);
await solving(site);
await site.close();
