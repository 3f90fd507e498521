// How long the page takes to open, and how fast its solver is against the same
// program without a browser. Run by web/bench.

import { execFileSync } from 'node:child_process';
import { readFileSync, readdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { linkOf } from './tests/link.mjs';
import { Page, stage } from './tests/page.mjs';

const SCENES = fileURLToPath(new URL('../assets/scenes/', import.meta.url));
const OPENINGS = 7;
const SOLVES = 60;

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

async function solving(site) {
  console.log('\nsolved from straight     native   browser     ratio');
  const page = await Page.open(await site.browser.newContext(), site.address);
  for (const name of readdirSync(SCENES)) {
    const file = SCENES + name;
    await page.tab.goto('about:blank');
    await page.go(site.address + linkOf(readFileSync(file, 'utf8')));
    await page.until('the path is known', (state) => state.path_is_current);
    const browser = median(await page.tab.evaluate(solves, SOLVES));
    const repeat = ['--repeat', '200', '--format', 'json'];
    const told = JSON.parse(execFileSync(process.env.SINEW, ['solve', file, ...repeat]));
    const native = told.timing_us.path.median / 1000;
    const columns = [`${native.toFixed(2)} ms`, `${browser.toFixed(2)} ms`];
    const ratio = (browser / native).toFixed(2);
    console.log(
      `${name.padEnd(20)}${columns.map((text) => text.padStart(11)).join('')}${ratio.padStart(9)}`,
    );
  }
}

/** Milliseconds that the solver spent on each of some solves; in the page. */
async function solves(count) {
  const times = [];
  for (let time = 0; time < count; time += 1) {
    sinew_test.sinew_restart();
    do {
      await new Promise(requestAnimationFrame);
    } while (!JSON.parse(sinew_test.sinew_state()).settled);
    times.push(JSON.parse(sinew_test.sinew_state()).solve_ms);
  }
  return times;
}

const site = await stage();
await opening(site);
await solving(site);
await site.close();
