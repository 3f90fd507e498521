// Gives the solver its messages and its time. It works in turns of a few
// milliseconds and takes what has come between them.

import start, { Solver } from './sinew-worker.js';

/** Milliseconds of a turn. */
const TURN = 4;

let solver;
/** Orders that have come since the last turn. */
const orders = [];
/** Milliseconds since the last answer or live request. */
let spent = 0;
let isGoing = false;

// A message to itself comes after those that wait already, and without the
// delay that timers have.
const turns = new MessageChannel();
turns.port1.onmessage = () => guarded(turn);

onmessage = ({ data }) => {
  orders.push(data);
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
  for (const order of orders.splice(0)) {
    if (solver.take(order)) spent = 0;
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
  if (solver.busy || orders.length) go();
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
  if (orders.length) go();
} catch (error) {
  postMessage(String(error?.message ?? error));
}
