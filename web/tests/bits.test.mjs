// The page's solver answers bit for bit what the native one does, over
// thousands of random scenes: `web/test` has them written down by
// tests/same_bits.rs. No browser is needed: the worker's program runs here.

import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { DIST } from './page.mjs';

/** The messages of a record: each follows its length in four bytes. */
function* messages(record) {
  for (let at = 0; at < record.length; ) {
    const end = at + 4 + record.readUInt32LE(at);
    yield record.subarray(at + 4, end);
    at = end;
  }
}

/** The worker's program, started as the page does. */
async function solver() {
  const names = readdirSync(DIST, { recursive: true });
  const file = (name) => readFileSync(join(DIST, names.find((path) => path.endsWith(name))));
  const script = file('sinew-worker.js').toString('base64');
  const program = await import(`data:text/javascript;base64,${script}`);
  program.initSync({ module: file('sinew-worker_bg.wasm') });
  return program.Solver;
}

test('thousands of shapes have the same bits as without a browser', async () => {
  const Solver = await solver();
  const all = [...messages(readFileSync(process.env.SINEW_BITS))];
  assert.ok(all.length > 3000, `${all.length}`);
  for (let at = 0; at < all.length; at += 2) {
    const one = new Solver();
    one.take(all[at]);
    let answer;
    while (!answer) answer = one.work();
    assert.ok(all[at + 1].equals(answer), `request ${at / 2}`);
    one.free();
  }
});
