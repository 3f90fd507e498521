// A scene in a link, written without the window's own code.

import { deflateRawSync } from 'node:zlib';

/** The fragment that holds a scene's TOML. */
export function linkOf(toml) {
  return `#s1.${deflateRawSync(toml, { level: 9 }).toString('base64url')}`;
}
