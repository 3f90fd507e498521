// Gives the solver its messages and its time. It works in turns of a few
// milliseconds and looks for a newer request between them, which replaces the
// one before it.

import start, { Solver } from './sinew-worker.js';

/** Milliseconds of a turn. */
const TURN = 4;

let solver;
let newest;
let spent = 0;
let isGoing = false;

// A message to itself comes after those that wait already, and without the
// delay that timers have.
const turns = new MessageChannel();
turns.port1.onmessage = () => guarded(turn);

onmessage = ({ data }) => {
  newest = data;
  go();
};

function go() {
  if (solver && !isGoing) {
    isGoing = true;
    turns.port2.postMessage(null);
  }
}

function turn() {
  isGoing = false;
  const begin = performance.now();
  let now = begin;
  if (newest) {
    solver.take(newest);
    newest = undefined;
    spent = 0;
  }
  do {
    const before = now;
    const found = solver.work();
    now = performance.now();
    spent += now - before;
    if (found) {
      postMessage([spent, found], [found.buffer]);
      spent = 0;
    }
  } while (solver.busy && now - begin < TURN);
  if (solver.busy || newest) go();
}

/** Tells the page of a failure, which then does without the worker. */
function guarded(work) {
  try {
    return work();
  } catch (error) {
    postMessage(String(error?.message ?? error));
    close();
  }
}

try {
  await start({ module_or_path: new URL('sinew-worker_bg.wasm', import.meta.url) });
  guarded(() => {
    solver = new Solver();
  });
  if (newest) go();
} catch (error) {
  postMessage(String(error?.message ?? error));
}
