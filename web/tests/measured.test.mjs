// The pull that suits a measurement best is found while the page goes on.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { linkOf } from './link.mjs';
import { Page, stage } from './page.mjs';

/** The pull that is to be found, in mm. */
const PULL = 7;
/** So many that the search takes seconds. */
const SEGMENTS = 1000;

let site;
before(async () => {
  site = await stage();
});
after(() => site.close());

/** A robot against a post, as a scene. */
function scene(pull, more = '') {
  return `version = 2
model = { mechanics = "equal" }
robot = { length_mm = 180, segments = ${SEGMENTS}, cable_offset_mm = 8 }
actuation = { pull_mm = ${pull} }
obstacle = [{ shape = "disc", center_mm = [44, 104], radius_mm = 15 }]
${more}`;
}

/** Opens a scene in a page of its own. */
async function open(toml) {
  const context = await site.browser.newContext({ viewport: { width: 1280, height: 800 } });
  return Page.open(context, site.address + linkOf(toml));
}

async function click(page, name) {
  const { x, y } = await page.middle(name);
  await page.tab.mouse.click(x, y);
}

test('the best pull is found while the page goes on', async () => {
  const known = await open(scene(PULL));
  const all = (await known.state()).backbone_mm;
  await known.tab.close();
  const nodes = Array.from({ length: 20 }, (_, index) => ((index + 1) * SEGMENTS) / 20);
  const points = nodes.map((node) => all[node]);
  const held = `nodes = ${JSON.stringify(nodes)}, points_mm = ${JSON.stringify(points)}`;

  const page = await open(scene(2, `measured = { ${held} }`));
  assert.equal((await page.state()).solver, 'worker');
  await page.until('the path is known', (state) => state.path_is_current, 60_000);
  await page.tab.waitForSelector('#cover', { state: 'detached' });
  await click(page, 'Measurements');
  await page.until('it can be asked for', (state) => state.widgets['Find the best pull']);
  await click(page, 'Find the best pull');
  // A page that stood still would show what was found, and nothing before.
  const first = await page.until('frames are drawn', (state) => 'Trying every pull' in state.widgets);
  const slider = await page.middle('Pull slider');
  const [least, most] = first.span_mm;
  const part = (4 - least) / (most - least);
  await page.tab.mouse.click(slider.x + (part - 0.5) * slider.width, slider.y);
  await page.until(
    'the robot is pulled',
    (state) => state.settled && Math.abs(state.pull_mm - 4) < 1,
  );
  const found = `Best pull ${PULL.toFixed(2)} mm`;
  await page.until('it is found', (state) => found in state.widgets, 60_000);
  // It is one that the robot comes to.
  await click(page, 'Apply');
  const there = await page.until(
    'it is applied',
    (state) => state.settled && Math.abs(state.pull_mm - PULL) < 1e-3,
  );
  const apart = all.map(([x, y], node) => {
    const [there_x, there_y] = there.backbone_mm[node];
    return Math.hypot(x - there_x, y - there_y);
  });
  assert.ok(Math.max(...apart) < 1e-2, `${Math.max(...apart)} mm`);
  assert.deepEqual(page.complaints, []);
});
