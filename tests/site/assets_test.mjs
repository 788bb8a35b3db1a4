// node assets_test.mjs SOURCE: the pictures of assets/ are those that its script makes, pixel by pixel (another zlib may pack them
// otherwise), its model is that byte by byte, they are small, and each stands in the list of licences.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import zlib from 'node:zlib';

const [source] = process.argv.slice(2), assets = path.join(source, 'assets');
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'assets-'));
process.on('exit', () => fs.rmSync(folder, { recursive: true, force: true }));
let failures = 0;
const expect = (holds, says) => holds || (++failures, console.log(`FAILED: ${says}`));

// Header and unpacked rows of a PNG file, the text of another.
function contents(file) {
  const bytes = fs.readFileSync(file), packed = [];
  if (!file.endsWith('.png')) return bytes.toString('latin1');
  let header = '';
  for (let at = 8; at < bytes.length; at += 12 + bytes.readUInt32BE(at)) {
    const type = bytes.toString('latin1', at + 4, at + 8), data = bytes.subarray(at + 8, at + 8 + bytes.readUInt32BE(at));
    if (type === 'IHDR') header = data.toString('hex');
    if (type === 'IDAT') packed.push(data);
  }
  return `${header} ${zlib.inflateSync(Buffer.concat(packed)).toString('hex')}`;
}

execFileSync('node', [path.join(assets, 'make.mjs'), folder]);
const made = fs.readdirSync(folder).sort(), kept = fs.readdirSync(assets).filter((file) => /\.(png|jpe?g|obj)$/.test(file)).sort();
expect(made.join() === kept.join(), `assets/ has ${kept}, and the script makes ${made}`);
const licences = fs.readFileSync(path.join(assets, 'LICENSES.md'), 'utf8');
for (const file of made) {
  if (!kept.includes(file)) continue;
  expect(contents(path.join(folder, file)) === contents(path.join(assets, file)), `${file} is not as the script makes it`);
  expect(fs.statSync(path.join(assets, file)).size < 64 * 1024, `${file} is not small`);
  expect(licences.includes(file), `${file} has no line in LICENSES.md`);
}
process.exit(failures ? 1 : 0);
