// node serve_test.mjs SOURCE [SECONDS]: web/serve.mjs under requests that no browser makes. It answers the right ones before, meanwhile
// and after, with lengths, and gives nothing that is not in its folder.
import fs from 'node:fs';
import net from 'node:net';
import path from 'node:path';
import zlib from 'node:zlib';
import { counted, equal, expect, scratch, served } from './support.mjs';

const [source, seconds = '4'] = process.argv.slice(2);
const site = path.join(scratch, 'site'), outside = path.join(scratch, 'outside');
for (const folder of [site, outside, path.join(site, 'demos'), path.join(site, 'folder.html')]) fs.mkdirSync(folder);
const start = `<!doctype html>${'<p>the start page</p>'.repeat(2000)}`, secret = 'secret';
fs.writeFileSync(path.join(site, 'index.html'), start);
fs.writeFileSync(path.join(site, 'demos/ä b.json'), '{}');
fs.writeFileSync(path.join(site, 'picture.png'), Buffer.alloc(5000, 7));
fs.writeFileSync(path.join(site, 'hidden.txt'), secret);
fs.writeFileSync(path.join(outside, 'secret.html'), secret);
fs.symlinkSync(path.join(outside, 'secret.html'), path.join(site, 'link.html'));
fs.symlinkSync(outside, path.join(site, 'linked'));
fs.symlinkSync('index.html', path.join(site, 'inside.html'));
fs.symlinkSync('circle.html', path.join(site, 'circle.html'));
const address = await served(source, site);
const port = Number(new URL(address).port);

// (events.once() would take a reset for a fault of the test: a server may close before it has read all.)
const ended = (socket) => new Promise((resolve) => socket.once('close', resolve));
// What comes back to these bytes until the connection ends, or nothing comes for `patience` milliseconds. `last`: it is said that no more
// comes, and Node then answers only what it can at once.
async function said(bytes, patience = 10_000, last = false) {
  const socket = net.connect(port, '127.0.0.1');
  const parts = [];
  socket.on('data', (part) => parts.push(part)).on('error', () => {});
  socket.setTimeout(patience, () => socket.destroy());
  if (last) socket.end(bytes);
  else socket.write(bytes);
  await ended(socket);
  return Buffer.concat(parts);
}
const request = (method, target, headers = {}) => Buffer.from(`${method} ${target} HTTP/1.1\r\n${Object.entries({ Host: `127.0.0.1:${port}`, Connection: 'close', ...headers })
  .filter(([, value]) => value !== undefined).map(([name, value]) => `${name}: ${value}\r\n`).join('')}\r\n`, 'latin1');
async function asked(method, target, headers) {
  const bytes = await said(request(method, target, headers));
  const end = bytes.indexOf('\r\n\r\n');
  const [first, ...lines] = bytes.subarray(0, end).toString('latin1').split('\r\n');
  return { status: Number(first.split(' ')[1]), headers: Object.fromEntries(lines.map((line) => [line.split(':', 1)[0].toLowerCase(), line.slice(line.indexOf(':') + 2)])), body: bytes.subarray(end + 4) };
}
const isWell = async (when) => {
  const { status, body } = await asked('GET', '/');
  expect(status === 200 && body.toString() === start, `the start page, ${when}: ${status}`);
};

// ---- what is right

await isWell('first');
for (const [target, status] of [['/index.html?a=b#c', 200], ['/demos/%C3%A4%20b.json', 200], ['/inside.html', 200], ['/demos/../index.html', 200],
  ['/hidden.txt', 404], ['/link.html', 404], ['/linked/secret.html', 404], ['/circle.html', 404], ['/folder.html', 404], ['/demos', 404],
  ['/../outside/secret.html', 404], ['/..%2foutside/secret.html', 404], ['/%2e%2e/outside/secret.html', 404], ['//etc/passwd.html', 404],
  ['/..\\outside\\secret.html', 404], [`/${'x'.repeat(3000)}.html`, 404], [`/${'x/'.repeat(3000)}index.html`, 404], ['/index.html/x.html', 404],
  ['/%00.html', 400], ['/index.html%00.html', 400], ['/%', 400], ['/%ff.html', 400], ['/%c0%ae.html', 400], ['*', 400],
  ['http://127.0.0.1/index.html', 400], ['index.html', 400]]) {
  const { status: found, headers, body } = await asked('GET', target);
  equal(found, status, target.slice(0, 60));
  if (found !== 400 || headers['content-type']) equal(Number(headers['content-length']), body.length, `the length of ${target.slice(0, 60)}`);
  expect(!body.includes(secret), `${target} gives what is not in the folder`);
}
for (const host of ['evil.example', `evil.example:${port}`, '127.0.0.1.evil.example', '', 'localhost.evil', '[::1]', '127.0.0.2', 'x@localhost'])
  equal((await asked('GET', '/', { Host: host })).status, 421, `host '${host}'`);
for (const host of ['localhost', `localhost:${port}`, 'LOCALHOST:9', '127.0.0.1']) equal((await asked('GET', '/', { Host: host })).status, 200, `host '${host}'`);
equal((await asked('GET', '/', { Host: undefined })).status, 400, 'no host');
for (const method of ['POST', 'PUT', 'DELETE', 'OPTIONS', 'TRACE', 'PATCH', 'PROPFIND']) {
  const { status, headers } = await asked(method, '/');
  equal(`${status} ${headers.allow}`, '405 GET, HEAD', method);
}
const head = await asked('HEAD', '/');
equal(`${head.status} ${head.headers['content-length']} ${head.body.length}`, `200 ${start.length} 0`, 'HEAD');
expect((await asked('GET', '/', { Range: 'bytes=5-9' })).body.toString() === start, 'asked for a part it gives the whole');

// Compressed once, and told apart.
const zipped = await asked('GET', '/', { 'Accept-Encoding': 'br, gzip;q=0.8' });
expect(zlib.gunzipSync(zipped.body).toString() === start, 'compressed');
equal(`${zipped.headers['content-encoding']} ${zipped.headers['content-length']} ${zipped.headers.vary}`, `gzip ${zipped.body.length} Accept-Encoding`, 'compressed');
for (const encoding of ['gzip;q=0', 'identity', 'br', 'gzip;q=0.000', 'x-gzipped']) expect(!(await asked('GET', '/', { 'Accept-Encoding': encoding })).headers['content-encoding'], `as it is for ${encoding}`);
expect(!(await asked('GET', '/picture.png', { 'Accept-Encoding': 'gzip' })).headers['content-encoding'], 'a PNG is compressed already');
equal((await asked('GET', '/', { 'Accept-Encoding': 'gzip', 'If-None-Match': zipped.headers.etag })).status, 304, 'what the browser has already');
equal((await asked('GET', '/', { 'If-None-Match': zipped.headers.etag })).status, 200, 'what it has in another form');
// A file that is written anew is served anew.
fs.writeFileSync(path.join(site, 'demos/ä b.json'), '[1, 2]');
equal((await asked('GET', '/demos/%C3%A4%20b.json')).body.toString(), '[1, 2]', 'written anew');

// ---- what is hostile

const megabyte = 'x'.repeat(1 << 20);
for (const [name, bytes] of Object.entries({
  'a header of a megabyte': request('GET', '/', { X: megabyte }),
  'an address of a megabyte': request('GET', `/${megabyte}`),
  'a hundred thousand headers': request('GET', '/', Object.fromEntries(Array.from({ length: 100_000 }, (_, i) => [`X${i}`, 'y']))),
  'a body of a megabyte': Buffer.concat([request('POST', '/', { 'Content-Length': 1 << 20 }), Buffer.from(megabyte)]),
  'a body that does not come': request('POST', '/', { 'Content-Length': 1e15 }),
  'two lengths': request('GET', '/', { 'Content-Length': '1, 2', 'Transfer-Encoding': 'chunked' }),
  'an upgrade': request('GET', '/', { Connection: 'Upgrade', Upgrade: 'websocket' }),
  'an expectation': request('GET', '/', { Expect: 'miracles' }),
  'a tunnel': request('CONNECT', 'evil.example:443'),
  'nothing': Buffer.alloc(0), 'noughts': Buffer.alloc(10_000), 'a handshake of TLS': Buffer.from('160301020001000100', 'hex'),
})) {
  await said(bytes, 1000);
  await isWell(`after ${name}`);
}
const many = Array.from({ length: 500 }, () => net.connect(port, '127.0.0.1').on('error', () => {}));
await Promise.all(many.map((socket) => Promise.race([new Promise((resolve) => socket.once('connect', resolve)), ended(socket)])));
await isWell('beside 500 that say nothing');
for (const socket of many) socket.write('GET /picture.png HTTP/1.1\r\n');
await isWell('beside 500 that do not end');
for (const socket of many) socket.destroy();
await isWell('after 500 that went');
expect((await Promise.all(Array.from({ length: 500 }, () => asked('GET', '/', { 'Accept-Encoding': 'gzip' })))).every(({ status, body }) => status === 200 && body.equals(zipped.body)), '500 at once');

// By chance, with a seed: the same requests each time.
let state = 20_240_607;
const chance = (below) => {
  state = Math.imul(state ^ (state >>> 15), 0x2c1b3c6d) + 0x9e3779b9 | 0;
  return ((state ^ (state >>> 13)) >>> 0) % below;
};
const any = (...of) => of[chance(of.length)];
const noise = (length) => Array.from({ length }, () => String.fromCharCode(chance(256))).join('');
const targets = () => any('/', '/index.html', '/link.html', '/picture.png', '/%00.html', `/${noise(chance(40))}`, `/${Array.from({ length: chance(30) }, () => any('..', '/', '%2f', '%2e', '%00', '%', '%ff', '\\', 'demos', 'ä', '.html', '?', '#', ';')).join('')}`);
function hostile() {
  const bytes = request(any('GET', 'HEAD', 'POST', 'get', 'X', noise(3), 'DELETE', 'BREW'), targets(), {
    Host: any('127.0.0.1', 'localhost', 'evil.example', noise(8), undefined),
    Range: any(undefined, 'bytes=0-', 'bytes=-1', 'bytes=9-2', 'bytes=0-0,0-0', `bytes=${'0-1,'.repeat(chance(2000))}`, noise(9)),
    'Accept-Encoding': any(undefined, 'gzip', 'gzip;q=0', ','.repeat(chance(9000)), noise(9)),
    'If-None-Match': any(undefined, '*', noise(20)),
    'Content-Length': any(undefined, '0', '5', '-1', '1e9', noise(2)),
    Connection: any('close', 'keep-alive', noise(4)),
    [any('X', 'Expect', 'Transfer-Encoding', 'Upgrade', noise(5))]: any('chunked', '100-continue', 'h2c', noise(chance(50))),
  });
  if (chance(3) === 0) bytes[chance(bytes.length)] = chance(256);
  return chance(4) === 0 ? bytes.subarray(0, chance(bytes.length)) : bytes;
}
const until = Date.now() + 1000 * Number(seconds);
let made = 0;
while (Date.now() < until) {
  const answers = await Promise.all(Array.from({ length: 50 }, () => said(hostile(), 300, chance(2) === 0)));
  made += answers.length;
  expect(answers.every((answered) => !answered.includes(secret)), 'what is not in the folder');
  await isWell(`after ${made} requests by chance`);
}
console.log(`${counted.checks} checks, ${counted.failures} failed; ${made} requests by chance`);
process.exit(counted.failures > 0 ? 1 : 0);
