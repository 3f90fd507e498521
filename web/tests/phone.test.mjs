// A phone: panels are sheets, everything is large enough for a finger, and
// what a mouse does with its other button a long press does.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Page, stage } from './page.mjs';

/** Frames within which whatever opens is open. */
const OPENING = 40;
/** What of the bars is named so. */
const CONTROL =
  /^(Menu|Undo|Redo|Play|Pull|Pull slider|Select and move|Add a \w+|Draw a polygon|Search)( \(|$)|^(Set|Show) the|^Status:|^Settings/;
/** Least side of what is touched, in points. */
const FINGER = 32;

let site;
before(async () => {
  site = await stage();
});
after(() => site.close());

async function open(width = 390, height = 844) {
  const viewport = { width, height };
  const options = { hasTouch: true, isMobile: true, viewport };
  return Page.open(await site.browser.newContext(options), site.address);
}

/** The first widget with such a name. */
async function named(page, pattern) {
  const { widgets } = await page.state();
  const name = Object.keys(widgets).find((text) => pattern.test(text));
  assert.ok(name, `no widget ${pattern} among ${Object.keys(widgets).join(', ')}`);
  return page.middle(name);
}

async function tap(page, pattern) {
  const { x, y } = await named(page, pattern);
  await page.tab.touchscreen.tap(x, y);
  for (let frame = 0; frame < OPENING; frame += 1) await page.frame();
}

const shows = (pattern) => (state) => Object.keys(state.widgets).some((text) => pattern.test(text));

test('on a phone everything fits, and is as large as a fingertip', async () => {
  for (const [width, height] of [
    [360, 640],
    [390, 844],
    [844, 390],
  ]) {
    const page = await open(width, height);
    const { widgets } = await page.state();
    const controls = Object.entries(widgets).filter(([name]) =>
      CONTROL.test(name),
    );
    assert.ok(controls.length > 12);
    for (const [name, [left, top, wide, high]] of controls) {
      const at = `${name} of a page ${width} wide: ${[left, top, wide, high]}`;
      assert.ok(left >= 0 && left + wide <= width && top >= 0 && top + high <= height, at);
      assert.ok(wide >= FINGER && high >= FINGER, at);
    }
    // Nothing lies on its neighbour.
    for (const [name, [left, top, wide, high]] of controls) {
      for (const [other, [x, y, w, h]] of controls) {
        const apart = x >= left + wide || left >= x + w || y >= top + high || top >= y + h;
        assert.ok(name === other || apart, `${name} and ${other}, ${width} wide`);
      }
    }
    assert.deepEqual(page.complaints, []);
  }
});

test('the panels of a phone are sheets', async () => {
  const page = await open();
  await tap(page, /outline/);
  await page.until('the scene is there', shows(/^Obstacles$/));
  await tap(page, /^Plots$/);
  await page.until('the plots are there', shows(/^Multipliers by node$/));
  await tap(page, /^Close$/);
  const closed = await page.until('they are gone', (state) => !shows(/^Close$/)(state));
  assert.equal(closed.contacts.length, 2);
});

test('a finger pulls the cable', async () => {
  const page = await open();
  const first = await page.state();
  const slider = await page.middle('Pull slider');
  const [least, most] = first.span_mm;
  const part = (first.pull_mm - least) / (most - least);
  const left = slider.x - slider.width / 2;
  const from = { x: left + part * slider.width, y: slider.y };
  await page.fingers([[from, { x: left + 0.45 * slider.width, y: slider.y }]]);
  await page.until('more is pulled', (state) => state.settled && state.pull_mm > first.pull_mm + 2);
});

test('a long press opens the menu of what it is on', async () => {
  const page = await open();
  const [disc] = (await page.state()).obstacles_mm;
  const at = await page.pixel(disc);
  const session = await page.tab.context().newCDPSession(page.tab);
  const send = (type, touchPoints) =>
    session.send('Input.dispatchTouchEvent', { type, touchPoints });
  await send('touchStart', [at]);
  await page.until('the menu is open', shows(/^Duplicate/));
  await send('touchEnd', []);
  await tap(page, /^Delete/);
  const left = await page.until('the disc is gone', (state) => state.settled && state.obstacles_mm.length === 1);
  assert.ok(left.undo);
});

test("an example is opened, and the browser's way back leads from it", async () => {
  const page = await open();
  const first = await page.state();
  await tap(page, /^Menu/);
  await tap(page, /Examples …/);
  await tap(page, /^Load cell, true forces/);
  const one = await page.until(
    'the example is open',
    (state) => state.settled && state.title.startsWith('Load cell'),
  );
  assert.equal(one.obstacles_mm.length, 1);
  assert.match(page.tab.url(), /#example=load-cell-forces$/);
  await page.tab.goBack();
  await page.until('the first one is back', (state) => state.settled && state.title === first.title);
  await page.tab.goForward();
  await page.until('the other is again', (state) => state.settled && state.title === one.title);
  await page.tab.reload();
  await page.until('and stays', (state) => state.settled && state.title === one.title);
  assert.deepEqual(page.complaints, []);
});
