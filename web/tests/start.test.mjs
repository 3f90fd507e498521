// The page opens, draws and rests.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Page, stage } from './page.mjs';

let site;
before(async () => {
  site = await stage();
});
after(() => site.close());

async function open(query = '', options = {}) {
  const context = await site.browser.newContext({
    viewport: { width: 1280, height: 800 },
    ...options,
  });
  return Page.open(context, site.address + query);
}

test('opens on the robot leaning on two discs, solved by a worker', async () => {
  const page = await open();
  const state = await page.state();
  assert.equal(state.status, 'converged');
  assert.equal(state.contacts.length, 2);
  assert.ok(state.contacts.every((contact) => contact.multiplier > 0));
  assert.equal(state.solver, 'worker');
  assert.equal(state.renderer, 'webgl');
  const path = await page.until('the path is known', (now) => now.path_is_current);
  assert.ok(path.path_states > 100, `${path.path_states} states`);
  assert.deepEqual(page.complaints, []);
});

test('draws in many colours', async () => {
  for (const colorScheme of ['light', 'dark']) {
    const page = await open('', { colorScheme });
    await page.tab.waitForSelector('#cover', { state: 'detached' });
    const { different, mostFrequent } = await page.colours();
    // The background takes most of the window, but not nearly all.
    assert.ok(different > 200, `${colorScheme}: ${different} colours`);
    assert.ok(mostFrequent < 0.9, `${colorScheme}: ${mostFrequent} of one colour`);
    if (process.env.SHOTS) {
      await page.tab.screenshot({ path: `${process.env.SHOTS}/${colorScheme}.png` });
    }
  }
});

test('rests when there is nothing to do', async () => {
  const page = await open();
  await page.until('the path is known', (state) => state.path_is_current);
  await page.tab.waitForSelector('#cover', { state: 'detached' });
  let frames = -1;
  // Tips fade and the like; then all is still.
  const still = await page.until('no frames are drawn', (state) => {
    const same = state.frames === frames;
    frames = state.frames;
    return same;
  });
  const moments = Array.from({ length: 30 }, () => page.frame());
  await Promise.all(moments);
  for (let moment = 0; moment < 30; moment += 1) await page.frame();
  assert.ok((await page.state()).frames - still.frames <= 2);
});

test('draws as finely as the screen', async () => {
  // Playwright's own way to a finer screen does not reach the canvas.
  const fine = await stage({ browser: { flags: ['--force-device-scale-factor=2'] } });
  try {
    const page = await Page.open(await fine.browser.newContext({ viewport: null }), fine.address);
    assert.equal((await page.state()).pixels_per_point, 2);
    const [pixels, points] = await page.tab.evaluate(() => {
      const canvas = document.getElementById('canvas');
      return [canvas.width, canvas.clientWidth];
    });
    assert.equal(pixels, 2 * points);
  } finally {
    await fine.close();
  }
});

test('nothing moves by itself where that is wished', async () => {
  const moving = await open();
  assert.equal((await moving.state()).still, false);
  const still = await open('', { reducedMotion: 'reduce' });
  assert.equal((await still.state()).still, true);
});

test('uses WebGL where it is asked to', async () => {
  const page = await open('?renderer=webgl');
  assert.equal((await page.state()).renderer, 'webgl');
});

test('works below any path', async () => {
  const below = await stage({ path: '/some/where/' });
  try {
    const page = await Page.open(await below.browser.newContext(), below.address);
    assert.equal((await page.state()).solver, 'worker');
    assert.deepEqual(page.complaints, []);
  } finally {
    await below.close();
  }
});
