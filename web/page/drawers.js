// Where pages keep what is not saved: a drawer for each in the browser's
// storage, so that none writes over another's. A page holds the lock of its
// drawer's name, which the browser takes back however the page ends.

const DRAWER = 'sinew-unsaved ';
/** How long a page that is being left may hold its drawer, in milliseconds. */
const PATIENCE = 300;

/** This page's drawer; none before it is opened. */
let mine;
/** Those of pages that are gone. */
let others = [];

/** Takes a drawer, and those of pages that are gone: no other page is given
 * them from now on. */
export async function open() {
  try {
    const names = Object.keys(localStorage).filter((name) => name.startsWith(DRAWER));
    const taken = await Promise.all(names.map(take));
    others = names.filter((_, index) => taken[index]);
    mine = `${DRAWER}${Date.now()}-${Math.random()}`;
    await take(mine);
  } catch (error) {
    console.warn('work that is not saved is not kept:', error);
  }
}

/** Resolves to whether the drawer is this page's from now on. */
function take(name) {
  // Where the page is not served over https there are no locks: rather offered
  // twice than never.
  if (!navigator.locks) return true;
  return new Promise((resolve) => {
    const signal = AbortSignal.timeout(PATIENCE);
    const hold = () => {
      resolve(true);
      return new Promise(() => {});
    };
    navigator.locks.request(name, { signal }, hold).catch(() => resolve(false));
  });
}

/** Keeps work, or nothing any more. */
export function keep(work) {
  if (!mine) return;
  try {
    if (work === undefined) localStorage.removeItem(mine);
    else localStorage.setItem(mine, work);
  } catch (error) {
    console.warn('work that is not saved is not kept:', error);
  }
}

/** The names of the drawers of pages that are gone, the newest first, and what
 * is in them, by turns. */
export function left() {
  const kept = [...others].sort().reverse();
  return kept.flatMap((name) => [name, localStorage.getItem(name)]);
}

/** Empties such a drawer. */
export function forget(name) {
  others = others.filter((other) => other !== name);
  localStorage.removeItem(name);
}
