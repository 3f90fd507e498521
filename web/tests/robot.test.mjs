// The robot answers to the slider, to the pointer and to fingers, and its
// shapes are those that the command line finds.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync, readdirSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { linkOf } from './link.mjs';
import { Page, stage } from './page.mjs';

const SCENES = fileURLToPath(new URL('../../assets/scenes/', import.meta.url));

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

const tip = (state) => state.backbone_mm.at(-1);
const apart = ([a, b], [c, d]) => Math.hypot(a - c, b - d);

test('the slider bends the robot', async () => {
  const page = await open();
  const first = await page.state();
  const slider = await page.middle('Pull slider');
  const [least, most] = first.span_mm;
  const part = (first.pull_mm - least) / (most - least);
  const left = slider.x - slider.width / 2;
  const handle = { x: left + part * slider.width, y: slider.y };
  await page.drag(handle, { x: left + 0.45 * slider.width, y: slider.y });
  const bent = await page.until(
    'more is pulled',
    (state) => state.settled && state.pull_mm > first.pull_mm + 2,
  );
  assert.ok(apart(tip(bent), tip(first)) > 5);
  assert.ok(bent.energy > first.energy);
});

test('a disc that is dragged changes what the robot presses on', async () => {
  const page = await open();
  const first = await page.state();
  const disc = first.contacts[0].obstacle;
  const from = await page.pixel(first.obstacles_mm[disc]);
  // Away from the robot, by more than its own size.
  await page.drag(from, { x: from.x, y: from.y + 160 });
  const moved = await page.until(
    'the disc is free',
    (state) => state.settled && apart(state.obstacles_mm[disc], first.obstacles_mm[disc]) > 5,
  );
  assert.ok(!moved.contacts.some((contact) => contact.obstacle === disc && contact.multiplier > 0));
  // One gesture is one step back.
  assert.ok(moved.undo);
  await page.tab.keyboard.press('Control+z');
  await page.until(
    'the disc is back',
    (state) => state.settled && apart(state.obstacles_mm[disc], first.obstacles_mm[disc]) < 1e-9,
  );
});

test('fingers drag and pinch', async () => {
  const page = await open('', { hasTouch: true, isMobile: true, viewport: { width: 800, height: 900 } });
  const first = await page.state();
  const disc = first.contacts[0].obstacle;
  const from = await page.pixel(first.obstacles_mm[disc]);
  await page.fingers([[from, { x: from.x, y: from.y + 120 }]]);
  const moved = await page.until(
    'the disc has followed the finger',
    (state) => state.settled && apart(state.obstacles_mm[disc], first.obstacles_mm[disc]) > 5,
  );
  const middle = await page.pixel([0.5 * tip(moved)[0], 0.5 * tip(moved)[1]]);
  const near = (x) => ({ x: middle.x + x, y: middle.y });
  await page.fingers([
    [near(-40), near(-120)],
    [near(40), near(120)],
  ]);
  const pinched = await page.until(
    'the view is larger',
    (state) => state.points_per_mm > 1.5 * moved.points_per_mm,
  );
  assert.deepEqual(pinched.obstacles_mm, moved.obstacles_mm);
});

test('every scene has the shape that the command line finds', async () => {
  const page = await open();
  for (const solver of ['worker', 'inline']) {
    for (const name of readdirSync(SCENES)) {
      const file = SCENES + name;
      const told = execFileSync(process.env.SINEW, ['solve', file, '--format', 'json']);
      const native = JSON.parse(told);
      const link = linkOf(readFileSync(file, 'utf8'));
      await page.tab.goto('about:blank');
      const state = await page.go(`${site.address}?solver=${solver}${link}`);
      assert.equal(state.solver, solver);
      assert.equal(state.status, native.status, name);
      assert.equal(state.backbone_mm.length, native.backbone_mm.length, name);
      const away = state.backbone_mm.map((node, index) => apart(node, native.backbone_mm[index]));
      // The same program gives the same bits.
      assert.equal(Math.max(...away), 0, `${name}, ${solver}`);
      const pressed = (contact) => [contact.obstacle, contact.node];
      assert.deepEqual(state.contacts.map(pressed), native.contacts.map(pressed), name);
    }
  }
});

test('without its worker the window solves by itself', async () => {
  const context = await site.browser.newContext();
  // As where a policy forbids workers, or the file is lost on the way.
  await context.route('**/worker.js', (route) => route.abort());
  const page = await Page.open(context, site.address);
  const state = await page.state();
  assert.equal(state.solver, 'inline');
  assert.equal(state.contacts.length, 2);
});
