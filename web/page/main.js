// The page around the window: decides what the window may use, loads it, and
// says what there is to say before its first frame and after its last.

import * as drawers from './drawers.js';
import start, * as app from './sinew-page.js';

const BYTES = Number('%PAGE_BYTES%');
const query = new URLSearchParams(location.search);
const canvas = document.getElementById('canvas');
const cover = document.getElementById('cover');
const trouble = document.getElementById('trouble');

/** Whether the page is part of another one. */
const embedded = query.has('embed');

/** A worker for the solver, under way while the window is being loaded. */
let worker = startWorker();

let isReady = false;

// What the window asks for and tells: see src/app/page.rs and
// src/app/platform/web.rs.
globalThis.sinew_page = {
  canvas: () => canvas,
  worker: () => worker,
  wants_webgl: () => query.get('renderer') === 'webgl',
  is_embedded: () => embedded,
  wants_stillness: () => matchMedia('(prefers-reduced-motion: reduce)').matches,
  has_fingers: () => matchMedia('(pointer: coarse)').matches,
  visit: (fragment) => {
    location.hash = fragment;
  },
  ready,
  crashed,
  pick,
  download: save,
  download_pixels: savePixels,
  decode,
  address: () => location.href.split('#')[0],
  keep: drawers.keep,
  left: drawers.left,
  forget: drawers.forget,
  title: (text) => {
    document.title = text;
  },
};

function startWorker() {
  if (query.get('solver') === 'inline') return undefined;
  try {
    const started = new Worker(new URL('worker.js', import.meta.url), { type: 'module' });
    // The window listens later; until then it can only fail.
    started.onmessage = started.onerror = (event) => {
      console.warn('the solver cannot start, so the window solves by itself:', event.data);
      worker = undefined;
    };
    return started;
  } catch (error) {
    console.warn('no worker for the solver, so the window solves by itself:', error);
    return undefined;
  }
}

function ready() {
  isReady = true;
  performance.mark('sinew-ready');
  cover.classList.add('over');
  setTimeout(() => cover.remove(), 300);
  // Not at once: the window, which calls this, would not notice. It takes the
  // focus when it starts, which within another page is not its own to take.
  setTimeout(() => {
    if (embedded) document.activeElement?.blur();
    else canvas.focus({ preventScroll: true });
  });
}

/** Shows what went wrong, and ways out of it. */
function crashed(why, scene) {
  // What follows from the first failure says less.
  if (!trouble.hidden) return;
  const title = isReady ? 'Sinew has stopped' : 'Sinew cannot start here';
  const what = scene
    ? 'This is a fault in the program. The scene can be saved to a file and opened again.'
    : 'Reloading the page may help.';
  show(title, what, why);
  offer('.save', scene, (button) => button.addEventListener('click', () => save('saved-scene.toml', scene)));
  const isWebgl = query.get('renderer') === 'webgl';
  offer('.webgl', !isReady && !isWebgl, (link) => {
    const other = new URLSearchParams(query);
    other.set('renderer', 'webgl');
    link.href = `?${other}${location.hash}`;
  });
  offer('.afresh', location.hash.length > 1, (link) => {
    link.href = location.pathname + location.search;
  });
}

function show(title, what, details) {
  cover.remove();
  trouble.querySelector('h1').textContent = title;
  trouble.querySelector('.what').textContent = what;
  trouble.querySelector('details').hidden = !details;
  trouble.querySelector('pre').textContent = details;
  trouble.querySelector('.reload').addEventListener('click', () => location.reload());
  trouble.hidden = false;
  trouble.querySelector('.reload').focus();
}

function offer(name, wanted, prepare) {
  if (!wanted) return;
  const element = trouble.querySelector(name);
  prepare(element);
  element.hidden = false;
}

/** Resolves to a file of the user's choice, or to nothing. */
function pick(endings) {
  const input = document.createElement('input');
  input.type = 'file';
  input.accept = endings;
  return new Promise((resolve) => {
    input.addEventListener('change', () => resolve(input.files[0]));
    input.addEventListener('cancel', () => resolve(undefined));
    input.click();
  });
}

/** Hands a file to the browser's downloads. */
function save(name, contents) {
  const link = document.createElement('a');
  // What is in the program's memory changes.
  const parts = contents instanceof Uint8Array ? contents.slice() : contents;
  link.href = URL.createObjectURL(new Blob([parts]));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

async function savePixels(name, svg, scale) {
  const image = new Image();
  image.src = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
  await image.decode();
  const pixels = document.createElement('canvas');
  pixels.width = Math.round(scale * image.naturalWidth);
  pixels.height = Math.round(scale * image.naturalHeight);
  pixels.getContext('2d').drawImage(image, 0, 0, pixels.width, pixels.height);
  URL.revokeObjectURL(image.src);
  pixels.toBlob((blob) => save(name, blob), 'image/png');
}

/** A picture's sides, those with which it is shown, and its pixels then. */
async function decode(bytes, most) {
  const picture = await createImageBitmap(new Blob([bytes.slice()]));
  const scale = Math.min(1, most / Math.max(picture.width, picture.height));
  const canvas = document.createElement('canvas');
  canvas.width = Math.max(1, Math.round(scale * picture.width));
  canvas.height = Math.max(1, Math.round(scale * picture.height));
  const context = canvas.getContext('2d');
  context.imageSmoothingQuality = 'high';
  context.drawImage(picture, 0, 0, canvas.width, canvas.height);
  const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
  return [picture.width, picture.height, canvas.width, canvas.height, data];
}

/** Whether the browser can draw at all. */
async function canDraw() {
  const context = document.createElement('canvas').getContext('webgl2');
  if (context) {
    context.getExtension('WEBGL_lose_context')?.loseContext();
    return true;
  }
  if (query.get('renderer') === 'webgl') return false;
  return Boolean(await navigator.gpu?.requestAdapter());
}

/** The window's program, with a bar that shows how much of it is there. */
async function download() {
  const response = await fetch(new URL('sinew-page_bg.wasm', import.meta.url));
  if (!response.ok) throw new Error(`the server answers ${response.status}`);
  const bar = document.getElementById('bar');
  let seen = 0;
  const watch = new TransformStream({
    transform(chunk, controller) {
      seen += chunk.length;
      const percent = Math.min(100, Math.round((100 * seen) / BYTES));
      bar.setAttribute('aria-valuenow', percent);
      bar.firstElementChild.style.width = `${percent}%`;
      controller.enqueue(chunk);
    },
  });
  const headers = { 'Content-Type': 'application/wasm' };
  return new Response(response.body.pipeThrough(watch), { headers });
}

/** In a page of its own the wheel is the window's; in another one it scrolls
 * that, until the window was clicked. */
function leaveWheel() {
  const leave = (event) => {
    if (document.activeElement === document.body) event.stopImmediatePropagation();
  };
  canvas.addEventListener('wheel', leave, { capture: true });
  document.documentElement.classList.add('embedded');
}

function keepForOffline() {
  // Where the page is not served over https, there is no offline.
  navigator.serviceWorker?.register(new URL('../sw.js', import.meta.url)).catch((error) => {
    console.info('the page will not open offline:', error);
  });
}

canvas.addEventListener('webglcontextlost', () => {
  crashed('The graphics processor was taken away from the page.', app.sinew_kept());
});

if (embedded) leaveWheel();
if (await canDraw()) {
  try {
    const drawer = embedded ? undefined : drawers.open();
    const [program] = await Promise.all([download(), drawer]);
    await start({ module_or_path: program });
    // Only a build for tests has it.
    if (app.sinew_state) globalThis.sinew_test = app;
    keepForOffline();
  } catch (error) {
    crashed(String(error?.message ?? error), '');
  }
} else {
  const what =
    'It draws with WebGPU or with WebGL 2, and this browser offers neither. A current Firefox, ' +
    'Chrome, Edge or Safari does; hardware acceleration may have to be allowed in its settings.';
  show('Sinew cannot draw here', what, '');
}
