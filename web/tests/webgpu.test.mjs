// The same page on WebGPU, where the browser has an adapter in software.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Page, stage } from './page.mjs';

const FLAGS = [
  '--enable-unsafe-webgpu',
  '--enable-features=Vulkan,WebGPU',
  '--use-vulkan=swiftshader',
  '--use-angle=vulkan',
  '--use-webgpu-adapter=swiftshader',
  '--ignore-gpu-blocklist',
];

test('draws with WebGPU', async (context) => {
  const site = await stage({ browser: { flags: FLAGS } });
  try {
    const tab = await site.browser.newContext({ viewport: { width: 1280, height: 800 } });
    const probe = await tab.newPage();
    await probe.goto(`${site.address}icon.svg`);
    const has = await probe.evaluate(async () => Boolean(await navigator.gpu?.requestAdapter()));
    if (!has) {
      context.skip('this browser has no WebGPU adapter in software');
      return;
    }
    const page = await Page.open(tab, site.address);
    const state = await page.state();
    assert.equal(state.renderer, 'webgpu');
    await page.tab.waitForSelector('#cover', { state: 'detached' });
    const { different, mostFrequent } = await page.colours();
    if (process.env.SHOTS) {
      await page.tab.screenshot({ path: `${process.env.SHOTS}/webgpu.png` });
    }
    assert.ok(different > 200, `${different} colours`);
    assert.ok(mostFrequent < 0.9, `${mostFrequent} of one colour`);
    assert.deepEqual(page.complaints, []);
  } finally {
    await site.close();
  }
});
