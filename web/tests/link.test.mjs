// Links to scenes, good and broken; the page within another one.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { linkOf } from './link.mjs';
import { Page, stage } from './page.mjs';

const SCENE = `
version = 2
model = { mechanics = "equal" }
title = "From a link"
robot = { length_mm = 180, segments = 18, cable_offset_mm = 8 }
actuation = { pull_mm = 5 }
[[obstacle]]
shape = "disc"
center_mm = [30, 120]
radius_mm = 15
`;

let site;
before(async () => {
  site = await stage();
});
after(() => site.close());

const open = async (rest) => Page.open(await site.browser.newContext(), site.address + rest);

test('a link opens its scene, at once and in an open page', async () => {
  const page = await open(linkOf(SCENE));
  assert.equal((await page.state()).title, 'From a link');
  const other = linkOf(SCENE.replace('From a link', 'From another').replace('= 5', '= 6'));
  await page.tab.evaluate((link) => (location.hash = link), other);
  const state = await page.until(
    'the other scene is open',
    (now) => now.title === 'From another' && now.settled,
  );
  assert.equal(state.pull_mm, 6);
  assert.deepEqual(state.notices, []);
  assert.deepEqual(page.complaints, []);
});

test('a broken link is told and opens the first example', async () => {
  const whole = linkOf(SCENE);
  for (const [link, says] of [
    [whole.slice(0, -20), 'end of the link is missing'],
    ['#s9.abc', 'version 9'],
    ['#anything', 'no link to a scene'],
    [linkOf(SCENE.replace('segments = 18', 'segments = 0')), 'segments'],
  ]) {
    const page = await open(link);
    const state = await page.state();
    assert.match(state.title, /^Two posts/);
    assert.equal(state.notices.length, 1);
    assert.ok(state.notices[0].includes(says), `${says}: ${state.notices[0]}`);
  }
});

test("within another page the wheel is that page's until the window is clicked", async () => {
  const context = await site.browser.newContext({ viewport: { width: 900, height: 700 } });
  const host = `${site.address}host`;
  await context.route(host, (route) =>
    route.fulfill({
      contentType: 'text/html',
      body: `<body style="margin:0;height:3000px"><iframe src="./?embed" width="800" height="600">`,
    }),
  );
  const tab = await context.newPage();
  await tab.goto(host);
  const page = new Page(tab, tab.frames()[1]);
  const first = await page.until('the robot is settled', (state) => state.settled);
  await page.frame();
  const at = await page.pixel([60, 20]);
  const scrolled = () => tab.evaluate(() => scrollY);

  await tab.mouse.move(at.x, at.y);
  await tab.mouse.wheel(0, 40);
  await tab.waitForFunction(() => scrollY > 0);
  assert.equal((await page.state()).points_per_mm, first.points_per_mm);

  // The window has moved under the pointer, perhaps smoothly.
  await tab.waitForFunction(() => scrollY === 40);
  const before = await scrolled();
  await tab.mouse.click(at.x, at.y - before);
  await tab.mouse.wheel(0, -240);
  await page.until('it zooms', (state) => state.points_per_mm > first.points_per_mm);
  assert.equal(await scrolled(), before);
  // What the visitor does there is not stored.
  assert.deepEqual(await page.inside.evaluate(() => Object.keys(localStorage)), []);
});
