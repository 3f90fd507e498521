// A browser on the page, driven as a person would drive it. The page is the
// build for tests, whose state can be asked for.

import assert from 'node:assert/strict';
import { chromium } from 'playwright-core';
import { serve } from '../serve.mjs';

/** The folder of the build for tests. */
export const DIST = process.env.DIST;

/** WebGL 2 in software; nothing that a browser does of its own accord. */
const FLAGS = [
  '--enable-unsafe-swiftshader',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--disable-quic',
];

/** What Chromium says of drawing in software, and of the screenshots that are
 * taken of it. */
const EXPECTED = /No available adapters|Software rasterizer detected|GPU stall due to ReadPixels/;

export function browse({ flags = [], ...options } = {}) {
  return chromium.launch({
    executablePath: process.env.BROWSER,
    chromiumSandbox: false,
    args: [...FLAGS, ...flags],
    ...options,
  });
}

/** The page, in a browser of its own or in a context of another's. */
export class Page {
  /** Opens `address`; resolves when the first shape is settled. */
  static async open(context, address) {
    const page = new Page(await context.newPage());
    await page.go(address);
    return page;
  }

  /** The page in a tab, or in a frame of it. */
  constructor(tab, frame = tab) {
    this.tab = tab;
    this.inside = frame;
    /** What the page has complained of. */
    this.complaints = [];
    tab.on('console', (message) => {
      const isComplaint = ['error', 'warning'].includes(message.type());
      if (isComplaint && !EXPECTED.test(message.text())) this.complaints.push(message.text());
    });
    // From the start: whoever begins to listen when the chooser opens is late.
    tab.on('filechooser', () => {});
    tab.on('pageerror', (error) => this.complaints.push(String(error)));
  }

  async go(address) {
    await this.tab.goto(address);
    return this.until('the robot is settled', (state) => state.settled);
  }

  /** What the window shows; nothing before its first frame. */
  async state() {
    const text = await this.inside.evaluate(() => globalThis.sinew_test?.sinew_state());
    return text ? JSON.parse(text) : undefined;
  }

  /** The state as soon as it is as wanted. */
  async until(what, holds, patience = 20_000) {
    const end = Date.now() + patience;
    let state;
    while (Date.now() < end) {
      state = await this.state();
      if (state && holds(state)) return state;
      await this.frame();
    }
    const trouble = await this.tab.locator('#trouble:visible').allInnerTexts();
    const seen = JSON.stringify({ ...state, backbone_mm: undefined, widgets: undefined });
    return assert.fail(`not: ${what}\n${seen}\n${trouble}\n${this.complaints.join('\n')}`);
  }

  frame() {
    return this.inside.evaluate(() => new Promise((done) => requestAnimationFrame(done)));
  }

  /** Where a point of the plane is on the page, in CSS pixels. */
  async pixel([x, y]) {
    const pixel = (at) => [...globalThis.sinew_test.sinew_pixel(...at)];
    const at = await this.inside.evaluate(pixel, [x, y]);
    return { x: at[0], y: at[1] };
  }

  /** The middle of a widget, by its name. */
  async middle(name) {
    const { widgets } = await this.state();
    const area = widgets[name];
    assert.ok(area, `no widget ${name} among ${Object.keys(widgets).join(', ')}`);
    const [left, top, width, height] = area;
    return { x: left + width / 2, y: top + height / 2, width, height };
  }

  /** Drags by mouse, with a frame at each step. */
  async drag(from, to, steps = 12) {
    const { mouse } = this.tab;
    await mouse.move(from.x, from.y);
    await mouse.down();
    for (let step = 1; step <= steps; step += 1) {
      const part = step / steps;
      await mouse.move(from.x + part * (to.x - from.x), from.y + part * (to.y - from.y));
      await this.frame();
    }
    await mouse.up();
    await this.frame();
  }

  /** Puts fingers on the page, moves them in step and takes them away. Each
   * is given by where it starts and where it ends. */
  async fingers(tracks, steps = 12) {
    const session = await this.tab.context().newCDPSession(this.tab);
    const at = (part) =>
      tracks.map(([from, to], id) => ({
        id,
        x: from.x + part * (to.x - from.x),
        y: from.y + part * (to.y - from.y),
      }));
    const send = (type, touchPoints) =>
      session.send('Input.dispatchTouchEvent', { type, touchPoints });
    await send('touchStart', at(0));
    for (let step = 1; step <= steps; step += 1) {
      await send('touchMove', at(step / steps));
      await this.frame();
    }
    await send('touchEnd', []);
    await this.frame();
    await session.detach();
  }

  /** How many different colours the page's pixels have, and in which part of
   * them the most frequent one. */
  async colours() {
    return this.coloursOf(await this.tab.screenshot());
  }

  /** The same of a picture. */
  async coloursOf(png) {
    return this.tab.evaluate(async (base64) => {
      const blob = await (await fetch(`data:image/png;base64,${base64}`)).blob();
      const image = await createImageBitmap(blob);
      const canvas = new OffscreenCanvas(image.width, image.height);
      const context = canvas.getContext('2d');
      context.drawImage(image, 0, 0);
      const { data } = context.getImageData(0, 0, image.width, image.height);
      const counts = new Map();
      for (const pixel of new Uint32Array(data.buffer)) {
        counts.set(pixel, (counts.get(pixel) ?? 0) + 1);
      }
      const most = Math.max(...counts.values());
      return { different: counts.size, mostFrequent: most / (image.width * image.height) };
    }, png.toString('base64'));
  }
}

/** Serves the page and opens a browser on it for all tests of a file. */
export async function stage({ path = '/', browser: options } = {}) {
  const site = await serve(DIST, { path });
  const browser = await browse(options);
  const close = async () => {
    await browser.close();
    await site.stop();
  };
  return { ...site, browser, close };
}
