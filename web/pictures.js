// Pictures and models of the user's own, for knobs that take a file: the browser reads them, and the module gets them by their names. What
// an address or a command names is one of the site's own, or was chosen before.
const most = { bytes: 64 << 20, side: 8192, pixels: 8192 * 4096 }; // as mv/image/load.h has it
const mostText = 32 << 20; // bytes, as mv/demo/own_file.h has it

const read = new Map(); // by their names: { width, height, pixels } or { text }, of this page

// Whether a file has one of the endings that a knob accepts.
export const isNamedAs = (name, accept) => accept.split(',').some((ending) => name.toLowerCase().endsWith(ending));

const begins = (bytes, ...with_) => with_.every((byte, i) => bytes[i] === byte);

// As it is stored, red, green, blue, alpha, the upper row first, upright as a camera's note says. (A 2D canvas would multiply the colours
// by alpha and divide them again.)
async function pixelsOf(file, name) {
  const refuse = (why, value) => {
    throw new Error(word(why, { name, value, most: { pictureLarge: most.bytes, pictureSides: most.side, picturePixels: most.pixels }[why] }));
  };
  if (file.size > most.bytes) refuse('pictureLarge', file.size);
  const first = new Uint8Array(await file.slice(0, 4).arrayBuffer());
  if (!begins(first, 0x89, 0x50, 0x4e, 0x47) && !begins(first, 0xff, 0xd8, 0xff)) refuse('pictureKind', '');
  const bitmap = await createImageBitmap(file, { premultiplyAlpha: 'none', colorSpaceConversion: 'none' }).catch(() => refuse('pictureDamaged', ''));
  const { width, height } = bitmap, gl = new OffscreenCanvas(1, 1).getContext('webgl2');
  if (Math.max(width, height) > Math.min(most.side, gl.getParameter(gl.MAX_TEXTURE_SIZE))) refuse('pictureSides', `${width} x ${height}`);
  if (width * height > most.pixels) refuse('picturePixels', `${width} x ${height}`);
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, bitmap);
  gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  const pixels = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  bitmap.close();
  return { width, height, pixels };
}

// A model's text as bytes, which the module reads.
async function textOf(file, name) {
  if (file.size > mostText) throw new Error(word('pictureLarge', { name, value: file.size, most: mostText }));
  return { text: new Uint8Array(await file.arrayBuffer()) };
}

// The file, chosen or dropped, under its own name, for a knob that accepts such endings; a promise. Error: it is no picture where the
// knob takes pictures, or too large.
export async function take(file, name, accept) {
  read.set(name, await (accept === '.obj' ? textOf : pixelsOf)(file, name));
}

// Of the knobs that take files: { name, accept }, where one is set.
const filesIn = (what, settings) =>
  what.knobs.filter((knob) => what.widgets[knob.name].kind === 'file' && settings[knob.name]).map((knob) => ({ name: settings[knob.name], accept: what.widgets[knob.name].accept }));

// Fetches those of the site's own files that the settings name and the page does not have yet: a promise, or nothing where there are
// none. What cannot be had is the module's to refuse.
export function fetched(what, settings) {
  const missing = filesIn(what, settings).filter(({ name }) => /^assets\/[\w.-]+$/.test(name) && !read.has(name));
  if (!missing.length) return undefined;
  return Promise.all(missing.map(async ({ name, accept }) => {
    const answer = await fetch(`../${name}`);
    if (answer.ok) await take(await answer.blob(), name, accept).catch(() => {});
  }));
}

// Hands the module what the settings name and it does not have.
const had = new WeakMap(); // by the module: a map from names to what it was given
export function provide(demo, what, settings) {
  if (!had.has(demo)) had.set(demo, new Map());
  const given = had.get(demo);
  for (const { name } of filesIn(what, settings)) {
    const picture = read.get(name);
    if (!picture || given.get(name) === picture) continue;
    demo.give(name, picture);
    given.set(name, picture);
  }
}
