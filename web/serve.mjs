// Serves a folder on 127.0.0.1: node web/serve.mjs FOLDER PORT
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';

const [folder, port] = process.argv.slice(2);
const kinds = { '.html': 'text/html; charset=utf-8', '.css': 'text/css', '.js': 'text/javascript', '.json': 'application/json',
  '.csv': 'text/csv', '.svg': 'image/svg+xml', '.png': 'image/png', '.wasm': 'application/wasm' };

const server = http.createServer((request, response) => {
  const answer = (status, kind, body) => response.writeHead(status, { 'Content-Type': kind }).end(body);
  let file;
  try {
    const asked = decodeURIComponent(new URL(request.url, 'http://localhost').pathname);
    file = path.join(folder, path.posix.normalize(asked.endsWith('/') ? `${asked}index.html` : asked));
  } catch {
    return answer(400, 'text/plain', 'no such address');
  }
  const kind = kinds[path.extname(file)];
  if (!kind || !file.startsWith(folder + path.sep)) return answer(404, 'text/plain', 'not found');
  // A browser keeps what it has loaded, and asks whether it is still that.
  fs.stat(file, (failed, found) => {
    if (failed || !found.isFile()) return answer(404, 'text/plain', 'not found');
    const tag = `"${found.size}-${found.mtimeMs}"`;
    if (request.headers['if-none-match'] === tag) return response.writeHead(304).end();
    response.setHeader('ETag', tag).setHeader('Cache-Control', 'no-cache');
    fs.readFile(file, (unread, body) => (unread ? answer(404, 'text/plain', 'not found') : answer(200, kind, body)));
  });
});
server.on('error', (error) => {
  console.error(`error: --serve: must be a free port, as in --serve=${Number(port) + 1}, ${port} (${error.code})`);
  process.exit(1);
});
server.listen(port, '127.0.0.1', () => console.log(`http://127.0.0.1:${server.address().port}/   Ctrl+C ends it`));
