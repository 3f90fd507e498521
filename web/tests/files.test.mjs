// Files come from the browser's chooser or are dropped, and go to its
// downloads.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { Page, stage } from './page.mjs';

const SCENE = fileURLToPath(new URL('../../assets/scenes/one-disc.toml', import.meta.url));

let site;
before(async () => {
  site = await stage();
});
after(() => site.close());

async function open() {
  const context = await site.browser.newContext({ viewport: { width: 1280, height: 800 } });
  return Page.open(context, site.address);
}

/** What is downloaded after some keys. */
async function downloaded(page, keys) {
  const [download] = await Promise.all([
    page.tab.waitForEvent('download'),
    page.tab.keyboard.press(keys),
  ]);
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}

test('a scene is opened from a file and saved to one', async () => {
  const page = await open();
  const [chooser] = await Promise.all([
    page.tab.waitForEvent('filechooser'),
    page.tab.keyboard.press('Control+o'),
  ]);
  await chooser.setFiles(SCENE);
  const title = readFileSync(SCENE, 'utf8').match(/title = "(.*)"/)[1];
  await page.until('the file is open', (state) => state.title === title && state.settled);
  await page.tab.waitForFunction((name) => document.title.startsWith(name), title);
  const { name, bytes } = await downloaded(page, 'Control+s');
  assert.match(name, /\.toml$/);
  assert.ok(bytes.toString().includes(`title = "${title}"`));
  assert.deepEqual(page.complaints, []);
});

test('a file that is no scene is told and changes nothing', async () => {
  const page = await open();
  const before = await page.state();
  const [chooser] = await Promise.all([
    page.tab.waitForEvent('filechooser'),
    page.tab.keyboard.press('Control+o'),
  ]);
  await chooser.setFiles({ name: 'x.toml', mimeType: '', buffer: Buffer.from('robot = 1') });
  const told = await page.until('it is told', (state) =>
    Object.keys(state.widgets).some((text) => text.includes('x.toml cannot be opened')),
  );
  assert.equal(told.title, before.title);
});

test('a picture is exported as lines and as pixels', async () => {
  const page = await open();
  const svg = await downloaded(page, 'Control+Shift+V');
  const size = svg.bytes.toString().match(/^<svg[^>]* height="(\d+)"[^>]* width="(\d+)"/);
  assert.ok(size, svg.bytes.toString().slice(0, 200));
  const png = await downloaded(page, 'Control+Shift+E');
  assert.match(png.name, /\.png$/);
  const [width, height] = [png.bytes.readUInt32BE(16), png.bytes.readUInt32BE(20)];
  assert.deepEqual([width, height], [2 * size[2], 2 * size[1]]);
  const { different } = await page.coloursOf(png.bytes);
  assert.ok(different > 100, `${different} colours`);
});

test('a photograph is laid behind the robot, a damaged one is refused', async () => {
  const page = await open();
  const lay = async (name, buffer) => {
    const [chooser] = await Promise.all([
      page.tab.waitForEvent('filechooser'),
      page.tab.keyboard.press('Control+Shift+I'),
    ]);
    await chooser.setFiles({ name, mimeType: '', buffer });
  };
  const photo = await page.tab.screenshot({ type: 'jpeg' });
  await lay('photo.jpg', photo);
  await page.until('it is there', (state) =>
    state.notices.includes('Laid photo.jpg behind the robot'),
  );
  await lay('cut.png', (await page.tab.screenshot()).subarray(0, 60));
  await page.until('it is refused', (state) => {
    const told = Object.keys(state.widgets).join();
    return told.includes('cut.png cannot be laid') && told.includes('It is damaged');
  });
});

test('work that was not saved is offered again', async () => {
  const page = await open();
  const first = await page.state();
  const disc = await page.pixel(first.obstacles_mm[0]);
  await page.drag(disc, { x: disc.x + 60, y: disc.y });
  await page.until('the disc has moved', (state) => state.settled && state.undo);
  // Without a word to the program, as when a tab is closed.
  await page.tab.goto('about:blank');
  const again = await page.go(site.address);
  assert.ok(
    Object.keys(again.widgets).some((text) => /restore/i.test(text)),
    Object.keys(again.widgets).join(', '),
  );
});

test('two pages keep their own work, and a third offers both', async () => {
  const context = await site.browser.newContext({ viewport: { width: 1280, height: 800 } });
  const offers = (state) => Object.keys(state.widgets).some((text) => /restore/i.test(text));
  const pages = [];
  for (const index of [0, 1]) {
    const page = await Page.open(context, site.address);
    // What another page has open is not offered.
    assert.ok(!offers(await page.state()));
    const first = await page.state();
    const disc = await page.pixel(first.obstacles_mm[index]);
    await page.drag(disc, { x: disc.x + 60, y: disc.y });
    await page.until('the disc has moved', (state) => state.settled && state.undo);
    pages.push(page);
  }
  for (const page of pages) await page.tab.close();
  const third = await Page.open(context, site.address);
  const kept = await third.inside.evaluate(() => globalThis.sinew_page.left().length);
  assert.equal(kept, 4, 'the names and the work of two');
  assert.ok(offers(await third.state()));
});
