// Makes the pictures and the model of this folder: node assets/make.mjs FOLDER. Each is a function of its place and nothing else, so that
// they are the same wherever they are made.
import fs from 'node:fs';
import path from 'node:path';
import zlib from 'node:zlib';

const [folder] = process.argv.slice(2);
if (!folder) {
  console.error('error: make.mjs: must have a folder to write to');
  process.exit(1);
}

// ---- PNG files of 8 bits a channel, by the specification (ISO/IEC 15948)

const crcTable = Array.from({ length: 256 }, (none, i) => {
  let crc = i;
  for (let bit = 0; bit < 8; ++bit) crc = crc & 1 ? 0xedb88320 ^ (crc >>> 1) : crc >>> 1;
  return crc >>> 0;
});
const crc32 = (bytes) => (bytes.reduce((crc, byte) => crcTable[(crc ^ byte) & 255] ^ (crc >>> 8), 0xffffffff) ^ 0xffffffff) >>> 0;

function chunk(type, data) {
  const named = Buffer.concat([Buffer.from(type, 'latin1'), data]), around = Buffer.alloc(8);
  around.writeUInt32BE(data.length, 0);
  around.writeUInt32BE(crc32(named), 4);
  return Buffer.concat([around.subarray(0, 4), named, around.subarray(4)]);
}

// `color(x, y)` gives the channels, 0..1, of the pixel in column x and row y from the top; one channel is grey.
function write(name, width, height, color) {
  const channels = color(0, 0).length, rows = Buffer.alloc(height * (1 + width * channels));
  let at = 0;
  for (let y = 0; y < height; ++y) {
    rows[at++] = 1; // each byte less that of the pixel to the left
    let left = new Array(channels).fill(0);
    for (let x = 0; x < width; ++x) {
      const pixel = color(x, y).map((part) => Math.round(255 * Math.min(1, Math.max(0, part))));
      pixel.forEach((byte, i) => (rows[at++] = (byte - left[i]) & 255));
      left = pixel;
    }
  }
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set([8, channels === 1 ? 0 : 2, 0, 0, 0], 8);
  fs.writeFileSync(
    path.join(folder, name),
    Buffer.concat([Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'), chunk('IHDR', header), chunk('IDAT', zlib.deflateSync(rows, { level: 9 })), chunk('IEND', Buffer.alloc(0))]),
  );
}

// ---- what pictures are made of

const mix = (a, b, part) => a.map((one, i) => one + (b[i] - one) * part);
const smooth = (low, high, x) => {
  const t = Math.min(1, Math.max(0, (x - low) / (high - low)));
  return t * t * (3 - 2 * t);
};
// A shape's colour over what is below it: wholly where `inside` is positive, with an edge one unit wide.
const over = (below, color, inside) => mix(below, color, smooth(-0.5, 0.5, inside));

// ---- a postcard: nothing in it looks the same from the left, from the right, or upside down

function postcard(x, y) {
  const [px, py] = [x + 0.5, y + 0.5];
  let color = mix([0.35, 0.6, 0.9], [0.85, 0.92, 0.97], py / 150);
  const toSun = Math.hypot(px - 60, py - 50), ray = Math.cos(8 * Math.atan2(py - 50, px - 60));
  color = over(color, [1, 0.85, 0.3], 26 + 9 * smooth(0.2, 1, ray) - toSun);
  color = over(color, [1, 0.95, 0.55], 22 - toSun);
  color = over(color, [0.55, 0.62, 0.75], py - 120 + 34 * Math.exp(-(((px - 210) / 50) ** 2)) + 12 * Math.sin(px / 37));
  color = over(color, [0.3, 0.58, 0.28], py - 150 - 10 * Math.sin(px / 60));
  // A house: wall, roof, door to the right, window to the left
  color = over(color, [0.93, 0.88, 0.78], Math.min(px - 180, 270 - px, py - 120, 190 - py));
  color = over(color, [0.7, 0.22, 0.16], Math.min(py - 78, 122 - py, (py - 78) * 1.3 - Math.abs(px - 225)));
  color = over(color, [0.4, 0.25, 0.12], Math.min(px - 238, 258 - px, py - 150, 190 - py));
  color = over(color, [0.3, 0.5, 0.75], Math.min(px - 192, 216 - px, py - 136, 158 - py));
  // A tree to the left of it
  color = over(color, [0.38, 0.24, 0.12], Math.min(px - 106, 116 - px, py - 150, 205 - py));
  color = over(color, [0.12, 0.4, 0.16], 32 + 3 * Math.sin(9 * Math.atan2(py - 130, px - 111)) - Math.hypot(px - 111, py - 130));
  // The card's edge, with a stamp's red corner at the lower right
  color = over(color, [0.85, 0.15, 0.2], Math.min(px - 284, py - 204));
  return over(color, [1, 1, 1], 7 - Math.min(px, py, 320 - px, 240 - py));
}

// ---- tiles that go on without a seam, in three colours

function tiles(x, y) {
  const [u, v] = [(x + 0.5) / 128 - 0.5, (y + 0.5) / 128 - 0.5], blue = [0.12, 0.28, 0.55], cream = [0.95, 0.92, 0.82], rust = [0.75, 0.33, 0.16];
  const star = Math.min(Math.max(Math.abs(u), Math.abs(v)), (Math.abs(u) + Math.abs(v)) * Math.SQRT1_2);
  let color = over(cream, blue, 128 * (0.33 - star));
  color = over(color, rust, 128 * (0.2 - Math.hypot(u, v)));
  color = over(color, cream, 128 * (0.08 - Math.hypot(u - 0.04, v - 0.06)));
  const corner = Math.hypot(0.5 - Math.abs(u), 0.5 - Math.abs(v));
  color = over(color, rust, 128 * (0.14 - corner));
  return over(color, blue, 128 * (0.06 - corner));
}

// ---- a coin's relief, white where it is high

function coin(x, y) {
  const [u, v] = [(x + 0.5) / 128 - 1, 1 - (y + 0.5) / 128], r = Math.hypot(u, v), around = Math.atan2(u, v);
  let height = 0.25 + 0.45 * smooth(0.96, 0.9, r) * smooth(0.78, 0.84, r); // the rim
  height += 0.2 * smooth(0.84, 0.78, r) * smooth(0.02, 0.1, Math.abs(Math.sin(20 * around))) * smooth(0.68, 0.72, r); // beads
  // A star of five points, each with a ridge
  const fifth = (2 * Math.PI) / 5, within = Math.abs(around - fifth * Math.round(around / fifth));
  const edge = (0.55 * Math.sin(Math.PI / 5) * 0.42) / (Math.sin(Math.PI / 5 - within) * 0.42 + Math.sin(within));
  height += 0.5 * smooth(0, 0.5, edge - r);
  // A small moon at the upper right, so that it is seen what is turned
  return [height + 0.3 * smooth(0.1, 0.07, Math.hypot(u - 0.42, v - 0.42)) * smooth(0.07, 0.1, Math.hypot(u - 0.47, v - 0.47))];
}

// ---- an evening by the sea, by the direction: y is up, the picture's middle looks along -z

function evening([x, y, z]) {
  const around = Math.atan2(x, -z), toSun = x * 0.6 + y * 0.06 - z * 0.798; // nearly of unit length
  let color = mix([0.98, 0.62, 0.35], [0.13, 0.2, 0.42], smooth(-0.02, 0.65, y));
  color = mix(color, [1, 0.8, 0.5], 0.6 * Math.max(0, toSun) ** 12);
  color = mix(color, [1, 0.97, 0.85], smooth(0.994, 0.9965, toSun));
  const bank = 0.18 + 0.05 * Math.sin(3 * around) + 0.03 * Math.sin(7 * around + 1);
  color = mix(color, [0.85, 0.45, 0.4], 0.7 * smooth(0.05, 0, Math.abs(y - bank) - 0.02 * Math.sin(5 * around)));
  // Mountains all round, and a lighthouse behind
  const ridge = 0.06 + 0.05 * Math.sin(2 * around + 0.5) + 0.025 * Math.sin(9 * around) + 0.012 * Math.sin(23 * around + 2);
  color = mix(color, [0.2, 0.17, 0.3], smooth(0.004, -0.004, y - Math.max(ridge, 0)));
  const aside = Math.abs(Math.atan2(-x, z)); // from +z
  color = mix(color, Math.floor(y / 0.06) % 2 ? [0.95, 0.92, 0.88] : [0.8, 0.15, 0.12], smooth(0.045, 0.04, aside + 0.05 * y) * smooth(0.36, 0.355, y));
  if (y >= 0) return color;
  // The sea, with the sun's way on it
  const wave = 0.5 + 0.5 * Math.sin(40 / (0.08 - y)) * Math.cos(6 * around);
  const sea = mix([0.1, 0.17, 0.3], [0.16, 0.27, 0.4], wave * smooth(-1, -0.05, y));
  const glitter = Math.max(0, 1 - 6 * Math.abs(Math.atan2(x * 0.798 + z * 0.6, x * 0.6 - z * 0.798))) * wave;
  return mix(sea, [1, 0.75, 0.45], glitter * smooth(-0.9, -0.1, y));
}

// One panorama: its width is all round, its height from above to below.
function panorama(x, y) {
  const around = 2 * Math.PI * ((x + 0.5) / 512 - 0.5), up = Math.PI * (0.5 - (y + 0.5) / 256);
  return evening([Math.cos(up) * Math.sin(around), Math.sin(up), -Math.cos(up) * Math.cos(around)]);
}

// Six faces of 96 pixels as a cube that is cut open: left, ahead, right, behind in the middle row; above and below what is ahead.
function cross(x, y) {
  const side = 96, column = Math.floor(x / side), row = Math.floor(y / side);
  const across = (2 * ((x % side) + 0.5)) / side - 1, up = 1 - (2 * ((y % side) + 0.5)) / side;
  const way = row === 0 ? [across, 1, up] : row === 2 ? [across, -1, -up] : column === 0 ? [-1, up, -across] : column === 1 ? [across, up, -1] : column === 2 ? [1, up, across] : [-across, up, 1];
  if (row !== 1 && column !== 1) return [0, 0, 0];
  const length = Math.hypot(...way);
  return evening(way.map((one) => one / length));
}

// ---- a trefoil knot, as a tube of squares with normals

function knot(along, around, thick) {
  const lines = ['# A trefoil knot, made by make.mjs'], normals = [], faces = [];
  const less = (a, b) => a.map((one, i) => one - b[i]), unit = (a) => a.map((one) => one / Math.hypot(...a));
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const middle = (t) => [Math.sin(t) + 2 * Math.sin(2 * t), Math.cos(t) - 2 * Math.cos(2 * t), -Math.sin(3 * t)];
  const written = (word, numbers) => `${word} ${numbers.map((one) => (Math.round(1000 * one) / 1000 || 0).toString()).join(' ')}`;
  for (let i = 0; i < along; ++i) {
    const t = (2 * Math.PI * i) / along, forward = unit(less(middle(t + 1e-4), middle(t - 1e-4)));
    const aside = unit(cross(forward, [0, 0, 1])), up = cross(aside, forward); // the knot is nowhere upright
    for (let j = 0; j < around; ++j) {
      const turn = (2 * Math.PI * j) / around, out = aside.map((one, k) => Math.cos(turn) * one + Math.sin(turn) * up[k]);
      lines.push(written('v', middle(t).map((one, k) => one + thick * out[k])));
      normals.push(written('vn', out));
      const corner = (a, b) => 1 + ((i + a) % along) * around + ((j + b) % around);
      faces.push(`f ${[corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0)].map((n) => `${n}//${n}`).join(' ')}`);
    }
  }
  return [...lines, ...normals, ...faces, ''].join('\n');
}

fs.writeFileSync(path.join(folder, 'knot.obj'), knot(66, 12, 0.62));
write('postcard.png', 320, 240, postcard);
write('tiles.png', 128, 128, tiles);
write('coin.png', 256, 256, coin);
write('evening.png', 512, 256, panorama);
write('evening-faces.png', 384, 288, cross);
