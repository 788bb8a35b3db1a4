// node live_test.mjs SOURCE MVGL NATIVE BUILD [--ends] [--user] [DEMO...]: the demos alive in their pages, in headless Chromium that
// draws through the same Mesa: each preset's picture and words are the native program's (with --ends, each end of each knob's, too),
// and what a user does in a page does what it says. Of demos that are named only the former, with --user only the latter. It needs BUILD/web, the module, and BUILD/npm, puppeteer-core; without them it is skipped.
import { execFileSync, spawn, spawnSync } from 'node:child_process';
import fs from 'node:fs';
import { createRequire } from 'node:module';
import os from 'node:os';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import zlib from 'node:zlib';

const [source, program, native, build, ...rest] = process.argv.slice(2);
const ends = rest.includes('--ends'), onlyUser = rest.includes('--user'), named = rest.filter((word) => !word.startsWith('--'));
const skip = (why) => {
  console.log(`skipped: ${why}`);
  process.exit(77);
};
const chromium = ['chromium', 'chromium-browser', 'google-chrome'].find((name) => !spawnSync(name, ['--version']).error);
if (!chromium) skip('there is no Chromium');
if (!fs.existsSync(path.join(build, 'web/mvgl.wasm'))) skip('the demos are not built for browsers (./test does, with emscripten)');
if (!fs.existsSync(path.join(build, 'npm/node_modules/puppeteer-core'))) skip('puppeteer-core is not installed (./test does, with npm)');
const puppeteer = createRequire(path.join(build, 'npm/package.json'))('puppeteer-core');

let failures = 0, checks = 0;
const expect = (holds, says) => {
  ++checks;
  if (holds) return;
  ++failures;
  console.log(`FAILED: ${says}`);
};
const equal = (found, expected, what) => expect(found === expected, `${what}: expected '${expected}', found '${found}'`);

// What differs and why: sines and powers of another library of mathematics than the native program's end in another last digit.
const unlike = {
  'robot-arm': 'a foot whose edge goes through the middles of pixels',
  springs: 'a cloth that falls chaotically: what begins as the last digit is seen after some seconds',
};

// ---- the pages, served, in a browser

const scratch = fs.mkdtempSync(path.join(os.tmpdir(), 'live-'));
const site = path.join(scratch, 'site');
execFileSync('node', [path.join(source, 'web/make.mjs'), program, site, path.join(build, 'web')], { stdio: ['ignore', 'ignore', 'pipe'] });
const server = spawn('node', [path.join(source, 'web/serve.mjs'), site, '0'], { stdio: ['ignore', 'pipe', 'inherit'] });
const address = (await new Promise((resolve) => server.stdout.once('data', resolve))).toString().split(' ')[0];
const browser = await puppeteer.launch({
  executablePath: `/usr/bin/${chromium}`,
  userDataDir: path.join(scratch, 'profile'),
  protocolTimeout: 120_000,
  args: ['--no-sandbox', '--disable-background-networking', '--use-gl=angle', '--use-angle=gl-egl', '--ignore-gpu-blocklist'],
});
process.on('exit', () => {
  server.kill();
  fs.rmSync(scratch, { recursive: true, force: true });
});

// A page of a demo, once it is alive; what the console says fails the test.
async function opened(where, { width = 1280, height = 900 } = {}) {
  const page = await browser.newPage();
  page.on('console', (message) => expect(false, `${where}: the console says ${message.text()}`));
  page.on('pageerror', (error) => expect(false, `${where}: ${error.message}`));
  await page.setViewport({ width, height });
  await page.goto(`${address}demos/${where}`);
  await page.waitForSelector('.live.is-live, .live.is-still', { timeout: 120_000 });
  equal(await page.$eval('.panel', (panel) => panel.closest('.is-still')?.textContent ?? ''), '', `${where}: why it is not alive`);
  return page;
}

// To the six digits that are shown; below a billionth is what two libraries of mathematics round differently. What is measured in
// units of a double's last place is so by a long double, which has 11 binary digits more here and 60 in a page.
function isAlike(found, expected, unit = '') {
  if (typeof expected === 'number') return Math.abs(found - expected) <= Math.max(unit === 'ulp' ? 2 ** -11 : 1e-9, 1e-6 * Math.abs(expected));
  if (expected === null || typeof expected !== 'object') return found === expected;
  const keys = Object.keys(expected);
  return Object.keys(found).join() === keys.join() && keys.every((key) => isAlike(found[key], expected[key], expected.unit));
}

// ---- each preset as the native program shows it

const demos = [...execFileSync(program, ['--list'], { encoding: 'utf8' }).matchAll(/^ {2}(\S+)/gm)].map(([, name]) => name)
  .filter((name) => !onlyUser && (!named.length || named.includes(name)));
let pictures = 0, same = 0;
for (const demo of demos) {
  const native_ = JSON.parse(execFileSync(native, [...(ends ? ['--ends'] : []), demo], { encoding: 'utf8', maxBuffer: 1 << 28 }))[demo];
  const page = await opened(`${demo}.html`);
  const found = await page.evaluate((name, cases) => {
    const { demo, what } = document.querySelector('.live').live;
    return cases.map(({ settings, frame }) => {
      const opening = demo.says('Open', name, JSON.stringify(settings), frame, true);
      if (opening) return { error: opening };
      while (demo.does('Draw', what.width, what.height, true));
      const { error } = demo.tells('State');
      if (error) return { error };
      let sum = 2166136261;
      for (const byte of demo.pixels(what.width * what.height)) sum = Math.imul(sum ^ byte, 16777619);
      const { knobs, idle, readouts, matrices, messages } = demo.tells('Report');
      return { error, knobs, idle, readouts, matrices, messages, sum: sum >>> 0 };
    });
  }, demo, native_);
  found.forEach((one, i) => {
    const expected = native_[i], what = `${demo} ${JSON.stringify(expected.settings)}`;
    equal(one.error, expected.error, `${what}: its sentence`);
    if (expected.error) return;
    ++pictures;
    if (one.sum === expected.sum) ++same;
    else expect(demo in unlike, `${what}: another picture than the native program's`);
    equal(JSON.stringify(one.messages), JSON.stringify(expected.messages), `${what}: messages`);
    if (one.idle.threads === 'a page in a browser has one thread') delete one.idle.threads;
    equal(JSON.stringify([one.knobs, one.idle]), JSON.stringify([expected.knobs, expected.idle]), `${what}: knobs`);
    if (demo in unlike) return;
    for (const part of ['readouts', 'matrices'])
      expect(isAlike(one[part], expected[part]), `${what}: ${part}: expected ${JSON.stringify(expected[part])}, found ${JSON.stringify(one[part])}`);
  });
  await page.close();
}

// ---- what a user does

// A canvas out of sight is not drawn.
const settled = (page) => page.evaluate(async () => {
  document.querySelector('.view').scrollIntoView({ behavior: 'instant' });
  const { demo, what, state } = document.querySelector('.live').live;
  do await new Promise(requestAnimationFrame); while (demo.does('IsDue', what.width, what.height) && !state().playing);
  await new Promise(requestAnimationFrame);
});
const sumOf = async (page) => {
  await settled(page);
  return page.evaluate(() => {
    const { demo, what } = document.querySelector('.live').live;
    return demo.pixels(what.width * what.height).reduce((sum, byte) => Math.imul(sum ^ byte, 16777619), 2166136261) >>> 0;
  });
};
const text = (page, selector) => page.$eval(selector, (element) => element.textContent);
async function type(page, selector, words) {
  await page.$eval(selector, (field) => (field.value = ''));
  await page.type(selector, words);
  await page.keyboard.press('Enter');
}

if (!named.length) {
  // A control, the address, a link, and back
  let page = await opened('shadow-map.html');
  const first = await sumOf(page);
  await page.select('#knob-resolution', '64');
  const coarse = await sumOf(page);
  expect(coarse !== first, 'another resolution is another picture');
  equal(await page.evaluate(() => location.hash), '#resolution=64', 'the address');
  equal(await text(page, '.command code'), './run shadow-map --resolution 64', 'the command line');
  const linked = await opened('shadow-map.html#resolution=64');
  equal(await sumOf(linked), coarse, 'the linked picture');
  equal(await linked.$eval('#knob-resolution', (select) => select.value), '64', 'the linked control');
  await linked.close();
  await page.evaluate(() => (location.hash = '#resolution=256&filter=pcf3'));
  equal(await page.$eval('#knob-filter', (select) => new Promise((done) => setTimeout(() => done(select.value), 300))), 'pcf3', 'a link within the page');
  await page.evaluate(() => [...document.querySelectorAll('.panel button')].find((button) => button.textContent === 'Reset').click());
  equal(await sumOf(page), first, 'the picture after Reset');
  equal(await text(page, '.presets [aria-pressed="true"]'), 'original', 'the preset that it is');
  // The lesson's own lines, and a picture of it
  const above = await page.$$('article .above');
  expect(above.length > 0, 'lines of the lesson that can be shown above');
  await page.$$eval('article .above', (buttons) => buttons.find((button) => button.closest('pre').textContent.includes('--')).click());
  await settled(page);
  const shown = await text(page, '.command code');
  expect(shown !== './run shadow-map', `a line of the lesson, shown: ${shown}`);
  await page.$$eval('.thumbs a', (links) => links[0].click());
  equal(await sumOf(page), first, 'the first of the small pictures');
  // Two values compared
  await page.evaluate(() => document.querySelector('.live').live.settle({ settings: {}, compared: { knob: 'filter', other: 'pcf7' } }));
  await settled(page);
  equal(await text(page, '.command code'), './run shadow-map --compare filter=none,pcf7', 'the line of a comparison');
  equal(await text(page, '.label.is-b'), 'filter pcf7', 'what the other picture is');
  expect(await page.$eval('canvas.second', (canvas) => canvas.clientWidth > 0 && canvas.style.clipPath.startsWith('inset(0')), 'a second canvas, cut at the line');
  await page.close();

  // What a knob refuses, and what a demo refuses
  page = await opened('cube-persp.html');
  const good = await sumOf(page);
  await type(page, '#knob-near', '9999');
  equal(await text(page, '.refused'), "--near: must be 0.01 .. 2.4, '9999'", 'a value out of range');
  equal(await sumOf(page), good, 'the picture after it');
  await page.close();
  page = await opened('view-volume.html');
  const whole = await sumOf(page), joint = await page.evaluate(() => {
    const { demo, what } = document.querySelector('.live').live;
    // Ends of knobs that make no picture together
    const numbers = what.knobs.filter(({ name }) => what.widgets[name].kind === 'number');
    for (const one of numbers) for (const other of numbers) {
      const settings = { [one.name]: String(what.widgets[one.name].high), [other.name]: String(what.widgets[other.name].low) };
      if (one === other || demo.says('SetAll', JSON.stringify(settings))) continue;
      demo.does('Draw', what.width, what.height, false);
      if (demo.tells('State').error) return settings;
    }
  });
  expect(joint, 'two ends of view-volume that make no picture together');
  await page.evaluate((settings) => document.querySelector('.live').live.settle({ settings }), joint);
  await settled(page);
  expect((await text(page, '.refused')).startsWith('--'), `the sentence of ${JSON.stringify(joint)}: ${await text(page, '.refused')}`);
  expect(await page.$('.view.is-refused'), 'the last good picture is dimmed');
  await page.evaluate(() => document.querySelector('.live').live.settle({ settings: {} }));
  equal(await sumOf(page), whole, 'the picture when the settings are good again');
  expect(!(await page.$('.view.is-refused')), 'it is dimmed no more');
  await page.close();

  // The mouse, the keys and a shader
  page = await opened('cube-cull.html');
  const still = await sumOf(page), box = await (await page.$('#canvas')).boundingBox();
  await page.mouse.move(box.x + 200, box.y + 200);
  await page.mouse.down();
  await page.mouse.move(box.x + 260, box.y + 220, { steps: 4 });
  await page.mouse.up();
  const turned = await sumOf(page);
  expect(turned !== still, 'a drag turns the cube');
  expect((await page.evaluate(() => location.hash)).includes('spin-y='), 'and is in the address');
  await page.focus('#canvas');
  await page.keyboard.press('ArrowUp');
  await settled(page);
  const before = await page.evaluate(() => location.hash);
  await page.$eval('.shaders', (details) => (details.open = true));
  await page.select('.shaders select', 'cube-cull.frag');
  const unedited = await sumOf(page);
  const edit = (from, to) => page.$eval('.shaders textarea', (area, a, b) => {
    if (!area.value.includes(a)) throw new Error(`no ${a} in ${area.value}`);
    area.value = area.value.replace(a, b);
    area.dispatchEvent(new Event('input'));
  }, from, to);
  await edit('fragColor = vertexColor;', 'fragColor = vertexColour;');
  await page.waitForSelector('.mistakes button');
  expect(/^shaders\/cube-cull\.frag:4: .*vertexColour/.test(await text(page, '.mistakes button')), `a typo at its line: ${await text(page, '.mistakes')}`);
  equal(await text(page, '.numbers .is-wrong'), '4\n', 'its line is marked');
  equal(await sumOf(page), unedited, 'the last good shader stays');
  await edit('vertexColour;', 'vertexColor.brga;');
  await page.waitForFunction(() => !document.querySelector('.mistakes').textContent);
  expect((await sumOf(page)) !== unedited, 'a shader that compiles is seen');
  await page.evaluate(() => [...document.querySelectorAll('.shaders button')].find((button) => button.textContent === 'Put back').click());
  equal(await sumOf(page), unedited, 'the shader put back');
  equal(await page.evaluate(() => location.hash), before, 'shaders are not in the address');
  // A context that is lost comes back
  await page.evaluate(() => {
    const lose = document.querySelector('#canvas').getContext('webgl2').getExtension('WEBGL_lose_context');
    lose.loseContext();
    setTimeout(() => lose.restoreContext(), 500);
  });
  await page.waitForFunction(() => document.querySelector('.refused').textContent.includes('asked for again'));
  await page.waitForFunction(() => document.querySelector('.live.is-live')?.live && !document.querySelector('.refused').textContent, { timeout: 60_000 });
  equal(await sumOf(page), unedited, 'the picture after the context was lost');
  await page.close();

  // Time: what moves moves on, what is paused rests
  page = await opened('frame-rate.html');
  const frame = () => page.evaluate(() => document.querySelector('.live').live.demo.tells('State').frame);
  const from = await frame();
  await page.waitForFunction((past) => document.querySelector('.live').live.demo.tells('State').frame > past, {}, from);
  await page.focus('#canvas');
  await page.keyboard.press(' ');
  await page.waitForFunction(() => !document.querySelector('.live').live.demo.tells('State').playing);
  const at = await frame();
  equal(await page.evaluate(() => new Promise((done) => setTimeout(() => done(document.querySelector('.live').live.demo.tells('State').frame), 500))), at, 'a paused frame');
  await page.evaluate(() => [...document.querySelectorAll('.time button')].find((button) => button.textContent === 'Step').click());
  equal(await frame(), at + 1, 'one step');
  await page.close();

  // A point that is dragged in the picture
  page = await opened('clipping.html');
  const handle = await page.$eval('.rings span', (ring) => ({ x: parseFloat(ring.style.left), y: parseFloat(ring.style.top) }));
  const untouched = await sumOf(page), place = await (await page.$('#canvas')).boundingBox();
  const [x, y] = [place.x + (place.width * handle.x) / 100, place.y + (place.height * handle.y) / 100];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 20, y + 15, { steps: 3 });
  await page.mouse.up();
  expect((await sumOf(page)) !== untouched, 'a dragged point changes the picture');
  await page.close();

  // A curve's point sets the knobs
  page = await opened('shadow-map.html');
  await page.$$eval('.curve circle', (points) => points.at(-1).dispatchEvent(new MouseEvent('click')));
  await settled(page);
  expect((await page.evaluate(() => location.hash)) !== '', 'a point of the curve sets the picture');
  await page.close();

  // Narrow and wide: nothing is cut off, nothing moves sideways
  for (const width of [360, 800, 1600]) {
    for (const demo of ['shadow-map', 'springs', 'cube-cull']) {
      page = await opened(`${demo}.html`, { width, height: 900 });
      const beyond = await page.evaluate(() => document.scrollingElement.scrollWidth - innerWidth);
      expect(beyond <= 0, `${demo} on ${width} pixels: ${beyond} beyond the edge`);
      await page.close();
    }
  }
}
await browser.close();

// ---- what a page loads: docs/browser.md has it by files; a guard against growing, the goal is 14 KB a demo
if (!named.length) {
  const loaded = fs.readdirSync(site).filter((file) => /\.(wasm|js|css)$/.test(file)).map((file) => zlib.brotliCompressSync(fs.readFileSync(path.join(site, file))).length);
  const each = loaded.reduce((sum, bytes) => sum + bytes, 0) / 1024 / fs.readdirSync(path.join(site, 'demos')).filter((file) => file.endsWith('.html')).length;
  expect(each <= 20, `a demo, with its part of what all load, in brotli: at most 20 KB, ${each}`);
}

// ---- without WebGL, and from a disk: pictures and a sentence

if (!named.length) {
  const plain = await puppeteer.launch({ executablePath: `/usr/bin/${chromium}`, args: ['--no-sandbox', '--disable-background-networking', '--disable-3d-apis'] });
  const page = await plain.newPage();
  await page.goto(`${address}demos/cube-cull.html`);
  await page.waitForSelector('.live.is-still');
  expect((await text(page, '.refused')).includes('WebGL 2: must be there'), `a sentence where there is no WebGL: ${await text(page, '.refused')}`);
  expect(await page.$eval('.shown', (picture) => picture.clientWidth > 0), 'and the picture');
  await page.goto(`${pathToFileURL(site)}/demos/cube-cull.html`);
  expect((await text(page, '.panel')).includes('./run --site --serve'), `from a disk: ${await text(page, '.panel')}`);
  expect(await page.$eval('.shown', (picture) => picture.clientWidth > 0 && picture.naturalWidth > 0), 'with the picture');
  await plain.close();
}
console.log(`${demos.length} demos, ${pictures} pictures, ${same} byte for byte the native ones; ${checks} checks, ${failures} failed`);
process.exit(failures ? 1 : 0);
