// What the page does where something is missing or fails: the network, the
// graphics processor, the program itself.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { Page, stage } from './page.mjs';

test('opens without a network after the first visit', async () => {
  const site = await stage();
  try {
    const context = await site.browser.newContext();
    const page = await Page.open(context, site.address);
    await page.tab.evaluate(async () => {
      await navigator.serviceWorker.ready;
    });
    await site.stop();
    const state = await page.go(`${site.address}?again`);
    assert.equal(state.contacts.length, 2);
    assert.equal(state.solver, 'worker');
  } finally {
    await site.browser.close();
  }
});

test('says so where nothing can draw', async () => {
  const site = await stage({ browser: { flags: ['--disable-3d-apis'] } });
  try {
    const tab = await (await site.browser.newContext()).newPage();
    await tab.goto(site.address);
    const trouble = tab.locator('#trouble');
    await trouble.waitFor({ state: 'visible' });
    assert.match(await trouble.innerText(), /cannot draw here[^]*WebGL 2/);
  } finally {
    await site.close();
  }
});

test('after a fault offers the scene', async () => {
  const site = await stage();
  try {
    const context = await site.browser.newContext();
    const page = await Page.open(context, site.address);
    await page.tab.evaluate(() => {
      try {
        globalThis.sinew_test.sinew_panic();
      } catch {
        // A panic ends in a trap.
      }
    });
    const trouble = page.tab.locator('#trouble');
    await trouble.waitFor({ state: 'visible' });
    assert.match(await trouble.innerText(), /Sinew has stopped/);
    const [download] = await Promise.all([
      page.tab.waitForEvent('download'),
      trouble.getByRole('button', { name: 'Save the scene' }).click(),
    ]);
    assert.equal(download.suggestedFilename(), 'saved-scene.toml');
    const scene = readFileSync(await download.path(), 'utf8');
    assert.match(scene, /^version = 2[^]*pull_mm = 5\.55/);
    await trouble.getByRole('button', { name: 'Reload' }).click();
    await page.until('the robot is settled again', (state) => state.settled);
  } finally {
    await site.close();
  }
});
