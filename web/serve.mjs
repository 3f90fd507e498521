// A web server for a folder of files: enough to try the page and to test it.
//
//   node web/serve.mjs FOLDER PORT

import { createReadStream } from 'node:fs';
import { stat } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, resolve, sep } from 'node:path';
import { pathToFileURL } from 'node:url';

const TYPES = {
  '.css': 'text/css; charset=utf-8',
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.png': 'image/png',
  '.svg': 'image/svg+xml',
  '.wasm': 'application/wasm',
  '.webmanifest': 'application/manifest+json',
};

/** Serves a folder below a path, as `/` or `/some/where/`, on this machine
 * only; a port of 0 is any that is free. `headers` are added to all answers. */
export async function serve(folder, { port = 0, path = '/', headers = {} } = {}) {
  const root = resolve(folder);
  const server = createServer(async (request, response) => {
    const url = new URL(request.url, 'http://localhost');
    const file = await find(root, path, decodeURIComponent(url.pathname));
    if (!file) {
      response.writeHead(404, headers).end();
      return;
    }
    const type = TYPES[extname(file)] ?? 'application/octet-stream';
    response.writeHead(200, { 'Content-Type': type, 'Cache-Control': 'no-cache', ...headers });
    createReadStream(file).pipe(response);
  });
  await new Promise((done) => server.listen(port, '127.0.0.1', done));
  const address = `http://localhost:${server.address().port}${path}`;
  const stop = () =>
    new Promise((done) => {
      server.close(done);
      server.closeAllConnections();
    });
  return { address, stop };
}

/** The file that a path names, if there is one. */
async function find(root, prefix, path) {
  if (!path.startsWith(prefix)) return undefined;
  const name = path.slice(prefix.length) || 'index.html';
  const file = join(root, name);
  if (!file.startsWith(root + sep)) return undefined;
  const found = await stat(file).catch(() => undefined);
  return found?.isFile() ? file : undefined;
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  const [folder, port] = process.argv.slice(2);
  const { address } = await serve(folder, { port: Number(port) });
  console.log(`${address}  (Ctrl-C to stop)`);
}
