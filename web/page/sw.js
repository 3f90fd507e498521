// Keeps the page for when there is no network. The files of a version are kept
// together: nothing is mixed from two.

/** Whose caches are whose: pages of one server share them all. */
const MINE = `sinew ${registration.scope} `;
const VERSION = `${MINE}%VERSION%`;
/** The folder of all that the page loads; its name changes with its contents. */
const APP = '%APP%';
/** What is in that folder, with its checksums, and what is beside it. */
const CHECKED = %CHECKED%;
const BESIDE = %BESIDE%;
/** How long a network that hardly answers may take, in milliseconds. */
const PATIENCE = 3000;

addEventListener('install', (event) => {
  event.waitUntil(keep().then(() => skipWaiting()));
});

addEventListener('activate', (event) => {
  event.waitUntil(dropOthers().then(() => clients.claim()));
});

addEventListener('fetch', (event) => {
  const { request } = event;
  const isOurs = request.method === 'GET' && request.url.startsWith(registration.scope);
  if (!isOurs) return;
  event.respondWith(request.mode === 'navigate' ? page(request) : part(request));
});

async function keep() {
  const cache = await caches.open(VERSION);
  const checked = CHECKED.map(async ([path, integrity]) => {
    // The page has just loaded most of it.
    const response = await fetch(path, { integrity, cache: 'force-cache' });
    await put(cache, path, response);
  });
  const beside = BESIDE.map(async (path) => {
    await put(cache, path, await fetch(path, { cache: 'no-cache' }));
  });
  const index = fetch('./', { cache: 'no-cache' }).then(async (response) => {
    const text = await response.clone().text();
    if (!text.includes(APP)) throw new Error('the page is of another version');
    await put(cache, './', response);
  });
  await Promise.all([...checked, ...beside, index]);
}

async function put(cache, path, response) {
  if (!response.ok) throw new Error(`${path}: ${response.status}`);
  await cache.put(path, response);
}

async function dropOthers() {
  const names = await caches.keys();
  const old = names.filter((name) => name.startsWith(MINE) && name !== VERSION);
  await Promise.all(old.map((name) => caches.delete(name)));
}

/** The page itself: as the server has it, else as it was kept. */
async function page(request) {
  const kept = await (await caches.open(VERSION)).match('./');
  const late = new Promise((resolve) => setTimeout(resolve, PATIENCE, kept));
  const fresh = fetch(request).catch(() => kept);
  return (await Promise.race([fresh, late])) ?? fresh;
}

/** A part of it: as it was kept, since its address changes with its contents. */
async function part(request) {
  const cache = await caches.open(VERSION);
  return (await cache.match(request, { ignoreSearch: true })) ?? fetch(request);
}
