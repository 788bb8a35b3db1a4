// Serves a folder on 127.0.0.1: node web/serve.mjs FOLDER PORT
//
// For browsers on this machine and nobody else: a page of another name that leads here (DNS rebinding) is refused, and so is what is
// not in the folder, by a link either. What is asked, a request must not end it (tests/site/serve_test.mjs).
import fs from 'node:fs/promises';
import { realpathSync } from 'node:fs';
import http from 'node:http';
import path from 'node:path';
import { promisify } from 'node:util';
import zlib from 'node:zlib';

const [folder, port] = process.argv.slice(2);
const kinds = { '.html': 'text/html; charset=utf-8', '.css': 'text/css', '.js': 'text/javascript', '.json': 'application/json',
  '.csv': 'text/csv', '.svg': 'image/svg+xml', '.png': 'image/png', '.wasm': 'application/wasm', '.obj': 'model/obj' };
const hosts = /^(127\.0\.0\.1|localhost)(:\d+)?$/i;
const root = realpathSync(folder);
const compressed = promisify(zlib.gzip);

class Refusal extends Error {
  constructor(status, says) {
    super(says);
    this.status = status;
  }
}
const notFound = () => new Refusal(404, 'not found');

// The file in the folder that is asked for, where it really is.
async function fileOf(address) {
  let asked;
  try {
    asked = decodeURIComponent(address.split(/[?#]/, 1)[0]);
  } catch {
    throw new Refusal(400, 'no such address');
  }
  if (!asked.startsWith('/') || asked.includes('\0')) throw new Refusal(400, 'no such address');
  const file = path.join(root, asked.endsWith('/') ? `${asked}index.html` : asked);
  if (!kinds[path.extname(file)]) throw notFound();
  const real = await fs.realpath(file);
  if (!real.startsWith(root + path.sep)) throw notFound();
  return real;
}

// What was read is kept, with what it is compressed, for as long as the file stays as it is: 500 that ask at once have one copy.
const kept = new Map();
async function contentOf(file) {
  const found = await fs.stat(file);
  if (!found.isFile()) throw notFound();
  const tag = `${found.size}-${found.mtimeMs}`;
  if (kept.get(file)?.tag !== tag) {
    const body = fs.readFile(file);
    const zipped = path.extname(file) === '.png' ? undefined : body.then((bytes) => compressed(bytes));
    kept.set(file, { tag, body, zipped });
    Promise.all([body, zipped]).catch(() => kept.delete(file));
  }
  return kept.get(file);
}

const takesGzip = (accepted = '') =>
  accepted.split(',').some((one) => /^\s*(gzip|\*)\s*(;\s*q=(0?\.0*[1-9]\d*|1(\.0*)?)\s*)?$/i.test(one));

async function answer(request, response) {
  const reply = (status, headers, body) =>
    response.writeHead(status, { 'Content-Length': body.length, 'X-Content-Type-Options': 'nosniff', ...headers }).end(request.method === 'HEAD' ? undefined : body);
  try {
    if (!hosts.test(request.headers.host ?? '')) throw new Refusal(421, 'this is 127.0.0.1');
    if (request.method !== 'GET' && request.method !== 'HEAD') throw new Refusal(405, 'GET or HEAD');
    const file = await fileOf(request.url);
    const content = await contentOf(file);
    const zips = content.zipped && takesGzip(request.headers['accept-encoding']);
    // A browser keeps what it has loaded, and asks whether it is still that.
    const tag = `"${content.tag}${zips ? '-gzip' : ''}"`;
    const headers = { ETag: tag, 'Cache-Control': 'no-cache', 'Accept-Ranges': 'none', ...(content.zipped && { Vary: 'Accept-Encoding' }) };
    if (request.headers['if-none-match'] === tag) return response.writeHead(304, headers).end();
    const body = await (zips ? content.zipped : content.body);
    reply(200, { ...headers, 'Content-Type': kinds[path.extname(file)], ...(zips && { 'Content-Encoding': 'gzip' }) }, body);
  } catch (error) {
    // That a file is not there, or cannot be: its name is too long, a part of it is no folder. And what the system has no more of.
    const refusal = error instanceof Refusal ? error : /^(EMFILE|ENFILE|ENOMEM)$/.test(error.code) ? new Refusal(503, 'busy') : notFound();
    reply(refusal.status, { 'Content-Type': 'text/plain', ...(refusal.status === 405 && { Allow: 'GET, HEAD', Connection: 'close' }) },
      Buffer.from(refusal.message));
  }
}

const server = http.createServer((request, response) => void answer(request, response));
server.on('error', (error) => {
  console.error(`error: --serve: must be a free port, as in --serve=${Number(port) + 1}, ${port} (${error.code})`);
  process.exit(1);
});
server.listen(port, '127.0.0.1', () => console.log(`http://127.0.0.1:${server.address().port}/   Ctrl+C ends it`));
