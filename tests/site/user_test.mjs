// node user_test.mjs SOURCE MVGL BUILD: what a user does in a live page does what it says: controls, links, refusals, drags, keys, shaders,
// time, a comparison, a lost context, narrow and wide; what a page loads is small; and without WebGL, or from a disk, pictures stand.
import fs from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { browserOf, counted, demosOf, equal, expect, largestAllowed, largestFunction, liveSite, loadedBy, modulesOf, mostLoaded, mostOf, opened as openedIn, served, skipUnlessBuilt } from './support.mjs';

const [source, program, build] = process.argv.slice(2);
skipUnlessBuilt(build);
const site = liveSite(build);
const address = await served(source, site);
const browser = await browserOf(build);
const opened = (where, view) => openedIn(browser, address, where, view);

// A canvas out of sight is not drawn.
const settled = (page) => page.evaluate(async () => {
  document.querySelector('.view').scrollIntoView({ behavior: 'instant' });
  const { demo, size, state } = document.querySelector('.live').live;
  do await new Promise(requestAnimationFrame); while (demo.does('IsDue', size().width, size().height) && !state().playing);
  await new Promise(requestAnimationFrame);
});
const sumOf = async (page, which = 'first') => {
  await settled(page);
  return page.evaluate((which) => {
    const { demo, size, compare } = document.querySelector('.live').live;
    const pixels = (which === 'first' ? demo : compare.second()).pixels(size().width * size().height);
    return pixels.reduce((sum, byte) => Math.imul(sum ^ byte, 16777619), 2166136261) >>> 0;
  }, which);
};
// How many pictures a demo that has come to rest draws while the browser shows thirty.
const drawnMeanwhile = async (page) => {
  await settled(page);
  return page.evaluate(async () => {
    const { demo } = document.querySelector('.live').live, before = demo.tells('State').pictures;
    for (let i = 0; i < 30; ++i) await new Promise(requestAnimationFrame);
    return demo.tells('State').pictures - before;
  });
};
// Unfolds what is folded, or folds it, and returns once the page has heard of it.
const unfold = (page, selector, open = true) => page.$eval(selector, (details, open) => new Promise((heard) => {
  details.addEventListener('toggle', () => heard(), { once: true });
  details.open = open;
}), open);
// Presses a button wherever it stands: what is around it may move meanwhile.
const press = (page, selector) => page.$eval(selector, (button) => button.click());
const text = (page, selector) => page.$eval(selector, (element) => element.textContent);
async function type(page, selector, words) {
  await page.$eval(selector, (field) => (field.value = ''));
  await page.type(selector, words);
  await page.keyboard.press('Enter');
}

// A control, the address, a link, and back
let page = await opened('shadow-map.html');
const first = await sumOf(page);
await page.select('#knob-resolution', '64');
const coarse = await sumOf(page);
expect(coarse !== first, 'another resolution is another picture');
await page.waitForFunction(() => location.hash === '#resolution=64'); // once it rests
equal(await text(page, '.command code'), './run shadow-map --resolution 64', 'the command line');
const linked = await opened('shadow-map.html#resolution=64');
equal(await sumOf(linked), coarse, 'the linked picture');
equal(await linked.$eval('#knob-resolution', (select) => select.value), '64', 'the linked control');
await linked.close();
await page.evaluate(() => (location.hash = '#resolution=256&filter=pcf3'));
await page.waitForFunction(() => document.querySelector('#knob-filter').value === 'pcf3'); // a link within the page
equal(await page.$eval('#knob-resolution', (select) => select.value), '256', 'a link within the page');
await page.evaluate(() => [...document.querySelectorAll('.panel button')].find((button) => button.textContent === 'Reset').click());
equal(await sumOf(page), first, 'the picture after Reset');
equal(await text(page, '.presets [aria-pressed="true"]'), 'original', 'the preset that it is');
equal(await drawnMeanwhile(page), 0, 'pictures that a resting canvas draws');
// What is far below is laid out when it comes near
const lastIsLaidOut = () => document.querySelector('article > section:last-of-type > :last-child').checkVisibility({ contentVisibilityAuto: true });
equal(await page.evaluate(lastIsLaidOut), false, 'the end of the lesson is laid out');
await page.$eval('article > section:last-of-type', (section) => section.scrollIntoView({ behavior: 'instant' }));
await page.waitForFunction(lastIsLaidOut);
await page.evaluate(() => scrollTo({ top: 0, behavior: 'instant' }));
// The lesson's own lines, and a picture of it
const above = await page.$$('article .above');
expect(above.length > 0, 'lines of the lesson that can be shown above');
await page.$$eval('article .above', (buttons) => buttons.find((button) => button.previousSibling.textContent.includes('--')).click());
await settled(page);
const shown = await text(page, '.command code');
expect(shown !== './run shadow-map', `a line of the lesson, shown: ${shown}`);
await page.$$eval('.thumbs a', (links) => links[0].click());
equal(await sumOf(page), first, 'the first of the small pictures');
// Two values compared: the other picture is the one that this value makes alone
await page.select('#knob-filter', 'pcf7');
const alone = await sumOf(page);
await page.evaluate(() => document.querySelector('.live').live.settle({ settings: {}, compared: { knob: 'filter', other: 'pcf7' } }));
await settled(page);
equal(await text(page, '.command code'), './run shadow-map --compare filter=none,pcf7', 'the line of a comparison');
equal(await text(page, '.label.is-b'), 'filter pcf7', 'what the other picture is');
equal(await page.evaluate(() => performance.getEntriesByType('resource').filter((one) => one.name.endsWith('.wasm')).length), 1, 'times that the module of both is loaded');
equal(await sumOf(page), first, 'the one picture');
equal(await sumOf(page, 'second'), alone, 'the other picture');
await page.select('#knob-resolution', '64');
expect((await sumOf(page, 'second')) !== alone, 'a knob that is moved moves both');
equal(await drawnMeanwhile(page), 0, 'pictures that two resting canvases draw');
// It is in the link, which opens it again; its line is dragged; and a value that is refused leaves the clock running
await page.waitForFunction(() => location.hash === '#resolution=64&compare=filter,pcf7');
const pair = await opened('shadow-map.html#resolution=64&compare=filter,pcf7');
await pair.waitForFunction(() => document.querySelector('.label.is-b')?.textContent === 'filter pcf7');
const grip = await (await pair.$('.grip')).boundingBox(), lineAt = () => pair.$eval('.divider', (line) => Number(line.value));
const began = await lineAt();
await pair.mouse.move(grip.x + grip.width / 2, grip.y + 40);
await pair.mouse.down();
await pair.mouse.move(grip.x + grip.width / 2 + 50, grip.y + 40, { steps: 3 });
await pair.mouse.up();
expect((await lineAt()) > began, `a line that is dragged: ${began} to ${await lineAt()}`);
await pair.close();
const moving = await opened('viewpoints.html#compare=height,abc');
await moving.waitForFunction(() => document.querySelector('.refused').textContent.startsWith('with height abc: '));
const frameOf = (of) => of.evaluate(() => document.querySelector('.live').live.demo.tells('State').frame);
const stood = await frameOf(moving);
await moving.waitForFunction((past) => document.querySelector('.live').live.demo.tells('State').frame > past, {}, stood);
await moving.close();
expect(await page.$eval('canvas.second', (canvas) => canvas.clientWidth > 0 && canvas.style.clipPath.startsWith('inset(0')), 'a second canvas, cut at the line');
await page.close();

// Slow 4G: what the demo needs is asked for at once, and the picture in its place is there long before
page = await browser.newPage();
const wires = await page.createCDPSession();
await wires.send('Network.enable');
await wires.send('Network.emulateNetworkConditions', { offline: false, latency: 150, downloadThroughput: 1.6e6 / 8, uploadThroughput: 0.75e6 / 8 });
await page.goto(`${address}demos/cube-cull.html`, { waitUntil: 'domcontentloaded' });
await page.waitForSelector('.live.is-live');
const came = await page.evaluate(() => {
  const of = (name) => performance.getEntriesByType('resource').find((one) => one.name.endsWith(name));
  const picture = of(document.querySelector('.shown').getAttribute('src').replace(/.*\//, '/')), module = of('.wasm');
  return { picture: picture.responseEnd, asked: module.startTime, module: module.responseEnd };
});
expect(came.asked < came.picture && came.picture < 0.7 * came.module, `a slow network: the module is asked for before the picture is there, and comes after it: ${JSON.stringify(came)}`);
await page.close();
// A slow processor: the page is there before its demo is drawn, which takes long
page = await browser.newPage();
await (await page.createCDPSession()).send('Emulation.setCPUThrottlingRate', { rate: 6 });
await page.goto(`${address}demos/springs.html`);
await page.waitForSelector('.live.is-live');
const shownAt = await page.evaluate(() => ['first-contentful-paint', 'first-picture'].map((name) => performance.getEntriesByName(name)[0].startTime));
expect(shownAt[0] < shownAt[1], `a slow processor: the page is painted before its demo is drawn: ${shownAt}`);
await page.close();
// What measures that (measure.mjs) finds a picture that a person sees: the demo's first one is on the canvas as it is marked
page = await browser.newPage();
await page.evaluateOnNewDocument(() => {
  const mark = performance.mark.bind(performance);
  performance.mark = (name) => {
    if (name === 'first-picture') {
      const { gl, bytes } = { gl: document.querySelector('.view canvas').getContext('webgl2'), bytes: new Uint8Array(4) };
      gl.readPixels(gl.drawingBufferWidth / 2, gl.drawingBufferHeight / 2, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
      globalThis.firstPixel = [...bytes];
    }
    return mark(name);
  };
});
await page.goto(`${address}demos/cube-cull.html`);
await page.waitForSelector('.live.is-live');
equal(String(await page.evaluate(() => firstPixel)), '0,0,255,255', "the middle of cube-cull's first picture");
await page.close();

// What a knob refuses, and what a demo refuses
page = await opened('cube-persp.html');
const good = await sumOf(page);
await type(page, '#knob-near', '9999');
equal(await text(page, '.wrong:not(:empty)'), "near: must be 0.01 .. 2.4, '9999'", 'a value out of range, at its knob');
equal(await page.$eval('#knob-near', (field) => field.getAttribute('aria-invalid')), 'true', 'and to a screen reader');
await page.focus('#knob-far');
equal(await page.$eval('#knob-near', (field) => field.value), '0.3', 'the field that is left goes back');
await type(page, '#knob-near', ' 0,5 ');
await page.waitForFunction(() => location.hash === '#near=0.5'); // a comma and blanks are typed by most of Europe
equal(await text(page, '#knob-near ~ .unit, .slider'), '\u25b6', 'no unit has no room');
equal(await page.$eval('.slider input[type=range]', (slider) => slider.getAttribute('aria-valuetext') !== ''), true, 'a slider says its value');
await page.evaluate(() => document.querySelector('.live').live.settle({ settings: {} }));
await settled(page);
equal(await sumOf(page), good, 'the picture after it');
await page.evaluate(() => (location.hash = '#near=0.5%0Afar 2'));
await page.waitForFunction(() => document.querySelector('.refused').textContent.includes('\u21b5'));
equal(await text(page, '.refused'), "near: must be 0.01 .. 2.4, '0.5\u21b5far 2'", "a line's end in an address is part of the value, and sets nothing else");
await page.close();
page = await opened('view-volume.html');
const whole = await sumOf(page), joint = await page.evaluate(() => {
  const { demo, what } = document.querySelector('.live').live;
  // Ends of knobs that make no picture together
  const numbers = what.knobs.filter(({ name }) => what.widgets[name].kind === 'number');
  for (const one of numbers) for (const other of numbers) {
    const settings = { [one.name]: String(what.widgets[one.name].high), [other.name]: String(what.widgets[other.name].low) };
    if (one === other || demo.says('SetAll', settings)) continue;
    demo.does('Draw', what.width, what.height, false);
    if (demo.tells('State').error) return settings;
  }
});
expect(joint, 'two ends of view-volume that make no picture together');
await page.evaluate((settings) => document.querySelector('.live').live.settle({ settings }), joint);
await settled(page);
expect(/^[a-z]/.test(await text(page, '.refused')), `the sentence of ${JSON.stringify(joint)}: ${await text(page, '.refused')}`);
expect(await page.$('.view.is-refused'), 'the last good picture is dimmed');
await page.evaluate(() => document.querySelector('.live').live.settle({ settings: {} }));
equal(await sumOf(page), whole, 'the picture when the settings are good again');
expect(!(await page.$('.view.is-refused')), 'it is dimmed no more');
await page.close();

// The mouse, the keys and a shader
page = await opened('cube-cull.html');
const straight = await sumOf(page), box = await (await page.$('#canvas')).boundingBox();
await page.mouse.move(box.x + 200, box.y + 200);
await page.mouse.down();
await page.mouse.move(box.x + 260, box.y + 220, { steps: 4 });
await page.mouse.up();
const turned = await sumOf(page);
expect(turned !== straight, 'a drag turns the cube');
await page.waitForFunction(() => location.hash.includes('spin-y=')); // and is in the address
await page.focus('#canvas');
await page.keyboard.press('ArrowUp');
await settled(page);
await page.waitForFunction(() => location.hash.includes('z-dist='));
const before = await page.evaluate(() => location.hash);
await unfold(page, '.shaders');
await page.select('.shaders select', 'cube-cull/cube-cull.frag');
const unedited = await sumOf(page);
const edit = (from, to) => page.$eval('.shaders textarea', (area, a, b) => {
  if (!area.value.includes(a)) throw new Error(`no ${a} in ${area.value}`);
  area.value = area.value.replace(a, b);
  area.dispatchEvent(new Event('input'));
}, from, to);
await edit('= vertexColor;', '= vertexColour;');
await page.waitForSelector('.mistakes button');
expect(/^shaders\/cube-cull\/cube-cull\.frag:4: .*vertexColour/.test(await text(page, '.mistakes button')), `a typo at its line: ${await text(page, '.mistakes')}`);
equal(await text(page, '.numbers .is-wrong'), '4\n', 'its line is marked');
equal(await sumOf(page), unedited, 'the last good shader stays');
await edit('= vertexColour;', '= vertexColor.brga;');
await page.waitForFunction(() => !document.querySelector('.mistakes').textContent);
expect((await sumOf(page)) !== unedited, 'a shader that compiles is seen');
await page.evaluate(() => [...document.querySelectorAll('.shaders button')].find((button) => button.textContent === 'Put back').click());
equal(await sumOf(page), unedited, 'the shader put back');
// A loop without an end would hold all the browser's pictures: it is told at its line, and not drawn
await edit('void main() {', 'void main() {\n    for (int i = 0; i < 3;) ;');
await page.waitForSelector('.mistakes button');
expect(/^shaders\/cube-cull\/cube-cull\.frag:\d+: this loop has no end/.test(await text(page, '.mistakes button')), `a loop without an end: ${await text(page, '.mistakes')}`);
equal(await sumOf(page), unedited, 'the picture beside it');
await page.evaluate(() => [...document.querySelectorAll('.shaders button')].find((button) => button.textContent === 'Put back').click());
// Another file is chosen before what was typed is compiled
await page.$eval('.shaders textarea', (area) => {
  area.value = area.value.replace('= vertexColor;', '= vertexColor.brga;');
  area.dispatchEvent(new Event('input'));
  const choice = document.querySelector('.shaders select');
  choice.value = 'cube-cull/cube-cull.vert';
  choice.dispatchEvent(new Event('change'));
});
expect((await sumOf(page)) !== unedited, 'a shader that is left at once is compiled');
await page.evaluate(() => [...document.querySelectorAll('.shaders button')].find((button) => button.textContent === 'Put back').click());
equal(await sumOf(page), unedited, 'it is put back from the other file');
await page.select('.shaders select', 'cube-cull/cube-cull.frag');
equal(await page.evaluate(() => location.hash), before, 'shaders are not in the address');
// What was typed outlives a reload, and is in the link that is copied; a shader that is not in use says so, and is compiled
await edit('= vertexColor;', '= vec4(0.0, 0.6, 0.2, 1.0);')
await page.waitForFunction(() => sessionStorage.getItem('mvgl cube-cull').includes('0.6, 0.2'));
const flat = await sumOf(page);
expect(flat !== unedited, 'a shader of one colour is seen');
await page.reload();
await page.waitForFunction(() => document.querySelector('.live.is-live')?.live);
equal(await sumOf(page), flat, 'the picture after a reload');
await page.evaluate(() => [...document.querySelectorAll('.shaders button')].find((button) => button.textContent === 'Put back').click());
equal(await sumOf(page), unedited, 'put back after a reload');
const typed = await opened(`cube-cull.html${before}&shader.cube-cull%2Fcube-cull.frag=${encodeURIComponent('in vec4 vertexColor;\nout vec4 fragColor;\nvoid main() { fragColor = vec4(0.0, 0.6, 0.2, 1.0); }\n')}`);
equal(await sumOf(typed), flat, 'a link to a shader');
await typed.close();
const lit = await opened('shading.html');
await unfold(lit, '.shaders');
await lit.waitForFunction(() => document.querySelector('.shaders select').value.endsWith('.frag') && !document.querySelector('.shaders .notes').textContent);
const idle = await lit.evaluate(() => {
  const used = document.querySelector('.live').live.demo.tells('ShadersInUse');
  return [...document.querySelectorAll('.shaders option')].map((one) => one.value).find((name) => /\.(vert|frag)$/.test(name) && !used.includes(name));
});
await lit.select('.shaders select', idle);
expect((await text(lit, '.shaders .notes')).includes('does not use this file'), `${idle}: what is said of it`);
await lit.$eval('.shaders textarea', (area) => {
  area.value = 'this is no shader at all';
  area.dispatchEvent(new Event('input'));
});
await lit.waitForSelector('.mistakes li');
expect((await lit.$$eval('.shaders option', (options) => options.map((one) => one.value))).includes('include/reflection.glsl'), 'what shaders include can be edited');
await lit.close();
// A context that is lost comes back; the sentence stays until it does
await page.evaluate(() => {
  globalThis.memory = document.querySelector('#canvas').getContext('webgl2').getExtension('WEBGL_lose_context');
  globalThis.memory.loseContext();
});
await page.waitForFunction(() => document.querySelector('.refused').textContent.includes('asked for again'));
await page.evaluate(() => setTimeout(() => globalThis.memory.restoreContext())); // after this answer: the page is loaded anew
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
equal(await drawnMeanwhile(page), 0, 'pictures while it is paused');
equal(await frame(), at, 'a paused frame');
await page.evaluate(() => [...document.querySelectorAll('.time button')].find((button) => button.textContent === 'Step').click());
equal(await frame(), at + 1, 'one step');
await page.focus('#canvas');
await page.keyboard.press(' ');
await page.waitForFunction((past) => document.querySelector('.live').live.demo.tells('State').frame > past, {}, at + 1);
// Out of sight it stops, and in sight it goes on
const isMoving = (expected) => page.waitForFunction(async (expected) => {
  const { demo } = document.querySelector('.live').live, before = demo.tells('State').pictures;
  for (let i = 0; i < 30; ++i) await new Promise(requestAnimationFrame);
  return demo.tells('State').pictures > before === expected;
}, { timeout: 60_000 }, expected);
await page.evaluate(() => document.querySelector('footer, article :last-child').scrollIntoView({ behavior: 'instant' }));
await isMoving(false);
await page.evaluate(() => document.querySelector('.view').scrollIntoView({ behavior: 'instant' }));
await isMoving(true);
await page.close();

// A frame draw by draw: the first draw of shadow-map makes the map, the last makes the picture whole
page = await opened('shadow-map.html');
const complete = await sumOf(page);
await unfold(page, '.steps');
await page.waitForFunction(() => document.querySelector('.steps p').textContent.startsWith('Draw 1 of '));
expect((await sumOf(page)) !== complete, 'after one draw there is another picture');
equal(await text(page, '.command code'), './run shadow-map --until 1', 'the line of a stopped frame');
expect((await text(page, '.steps p')).includes('shadow-map.depth'), `the program of the first draw: ${await text(page, '.steps p')}`);
const depths = await text(page, '.steps figcaption');
expect(/^depth of .*: \S+ is black, \S+ white$/.test(depths), `what it has drawn into: ${depths}`);
const shades = await page.$eval('.steps figure canvas', (canvas) => new Set(canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data).size);
expect(shades > 10, `depths are read by a shader, and seen: ${shades} shades`);
const draws = Number(await page.$eval('.steps input', (slider) => slider.max));
for (let draw = 1; draw < draws; ++draw) {
  await press(page, '.steps [aria-label="one draw more"]');
  await page.waitForFunction((draw) => document.querySelector('.steps p').textContent.startsWith(`Draw ${draw} of `), {}, draw + 1);
}
equal(await sumOf(page), complete, 'after all draws the picture is whole');
expect((await page.$$('.steps figure canvas')).length > 0, 'the buffers of the picture');
await unfold(page, '.steps', false);
await page.waitForFunction(() => document.querySelector('.command code').textContent === './run shadow-map');
equal(await sumOf(page), complete, 'the picture when the steps are closed');
await page.close();

// Two fingers that spread come nearer in each demo, whichever way the wheel goes there
for (const [demo, knob] of [['cube-cull', 'z-dist'], ['pipeline', 'distance'], ['shadow-map', 'distance'], ['stereocube', 'z-dist'], ['procedural', 'zoom']]) {
  page = await opened(`${demo}.html`);
  const away = () => page.evaluate((knob) => document.querySelector('.live').live.demo.tells('Knobs')[knob] * (knob === 'z-dist' ? -1 : 1), knob); // z-dist is negative
  const apart = await away(), { x: left, y: up } = await (await page.$('#canvas')).boundingBox(), touches = await page.createCDPSession();
  const touch = (type, spread) => touches.send('Input.dispatchTouchEvent', { type, touchPoints: spread ? [-spread, spread].map((far, id) => ({ x: left + 200 + far, y: up + 200, id })) : [] });
  await touch('touchStart', 50);
  for (const spread of [70, 90, 110]) await touch('touchMove', spread);
  await touch('touchEnd');
  await settled(page);
  expect(knob === 'zoom' ? (await away()) > apart : (await away()) < apart, `${demo}: ${knob} after two fingers were spread: ${apart} to ${await away()}`);
  await page.close();
}

// A demo that remembers: what was changed on the way is in the link, and the linked picture is the one that was shown
page = await opened('springs.html');
await page.focus('#canvas');
await page.keyboard.press(' ');
await page.waitForFunction(() => !document.querySelector('.live').live.demo.tells('State').playing);
for (const [field, value] of [['.time input[type="number"]', '30'], ['#knob-substeps', '9'], ['#knob-damping', '0.7'], ['.time input[type="number"]', '50']]) {
  await type(page, field, value);
  await settled(page);
}
await page.waitForFunction(() => location.hash === '#at=30,substeps=9&at=30,damping=0.7&frame=50');
const [changed, told] = [await sumOf(page), await text(page, '.command code')];
equal(told, './run springs --at 30 substeps=9 --at 30 damping=0.7 --frame 50', 'the line of changes on the way');
const again = await opened('springs.html#at=30,substeps=9&at=30,damping=0.7&frame=50');
equal(await sumOf(again), changed, 'the picture of a link with changes on the way');
equal(await text(again, '.command code'), told, 'and its line');
await again.evaluate(() => (location.hash = '#at=30,substeps=many&frame=50'));
await again.waitForFunction(() => document.querySelector('.refused').textContent.includes("'many'"));
await again.close();
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

// A colour is chosen by the browser's own field, and the field follows the knobs
page = await opened('color-models.html');
equal((await page.$$eval('input[type="color"]', (fields) => fields.map((field) => field.ariaLabel))).join('; '), 'red, green, blue: choose a colour; to-red, to-green, to-blue: choose a colour', 'colours that can be chosen');
const uncolored = await sumOf(page);
await page.$eval('input[type="color"]', (field) => {
  field.value = '#3366cc';
  field.dispatchEvent(new Event('input'));
});
expect((await sumOf(page)) !== uncolored, 'another colour is another picture');
equal((await page.$$eval('#knob-red, #knob-green, #knob-blue', (fields) => fields.map((field) => field.value))).join(), '0.2,0.4,0.8', 'a colour sets its three knobs');
await page.evaluate(() => document.querySelector('.live').live.settle({ settings: { green: '1' } }));
await settled(page);
equal(await page.$eval('input[type="color"]', (field) => field.value.slice(3, 5)), 'ff', 'the field follows its knobs');
await page.close();

// Matrices say what they are made of, with their present numbers
const madeOf = async (demo) => {
  page = await opened(`${demo}.html`);
  await unfold(page, '.matrices');
  await page.waitForSelector('.matrices table');
  const says = await page.$$eval('.matrices table', (tables) => tables.map((table) => `${table.caption.textContent} | ${table.rows[0].cells[0].title}`).join('; '));
  await page.close();
  return says;
};
expect(/worldFromLower = worldFromUpper \* upperFromLower \| .*\nRow 1 of worldFromUpper times column 1 of upperFromLower: .* = /.test(await madeOf('robot-arm')), 'a product, and its entries as sums');
expect(/\nAt distance 1 the view goes from x = \S+ to \S+: 50 degrees\./.test(await madeOf('cube-cull')), 'a projection by its angle');

// A curve's point sets the knobs
page = await opened('shadow-map.html');
await page.$$eval('.curve figure:not([hidden]) [data-row]', (points) => points.at(-1).dispatchEvent(new MouseEvent('click')));
await settled(page);
await page.waitForFunction(() => location.hash !== ''); // a point of the curve sets the picture
await page.close();

// Undone, by Ctrl+Z; a far frame is come to step by step, and can be left; what an address names in vain is told
page = await opened('springs.html');
await page.focus('#canvas');
await page.keyboard.press(' ');
await page.waitForFunction(() => !document.querySelector('.live').live.demo.tells('State').playing);
await page.evaluate(() => (location.hash = '#frame=100000000&tilt=3'));
await page.waitForFunction(() => document.querySelector('.panel').textContent.includes('On the way to frame 100000000'));
equal(await text(page, '.refused'), 'The address names what this lesson does not have: tilt=3', 'an unknown name');
await page.evaluate(() => [...document.querySelectorAll('.panel button')].find((button) => button.textContent === 'Stop').click());
equal(await drawnMeanwhile(page), 0, 'pictures after the way was left');
await page.close();
page = await opened('cube-cull.html#tilt=3');
equal(await text(page, '.refused'), 'The address names what this lesson does not have: tilt=3', 'an unknown name in the address that the page is opened by');
await page.close();
page = await opened('cube-cull.html');
const initial = await sumOf(page);
await page.select('#knob-cull', 'front');
await page.waitForFunction(() => location.hash === '#cull=front');
await page.focus('#canvas');
await page.keyboard.down('Control');
await page.keyboard.press('z');
await page.keyboard.up('Control');
await page.waitForFunction(() => location.hash === '');
equal(await sumOf(page), initial, 'the picture before');
// A slider that plays moves its knob
await press(page, '[aria-label="spin-y there and back"]');
await page.waitForFunction((before) => document.querySelector('#knob-spin-y').value !== before, {}, await page.$eval('#knob-spin-y', (field) => field.value));
await press(page, '[aria-label="spin-y there and back"]');
await page.close();
// What is copied is a link to all that is there, and a frame of it; a film has what the canvas shows
page = await opened('cube-cull.html');
await page.evaluate(() => Object.defineProperty(navigator, 'clipboard', { value: { writeText: async (words) => (globalThis.copied = words) } }));
const pressed = (words) => page.evaluate((words) => [...document.querySelectorAll('.panel button')].find((button) => button.textContent === words).click(), words);
await page.evaluate(() => { // in one breath, before a picture of it is drawn
  const knob = document.querySelector('#knob-cull');
  knob.value = 'both';
  knob.dispatchEvent(new Event('change', { bubbles: true }));
  [...document.querySelectorAll('.panel button')].find((button) => button.textContent === 'Copy link').click();
});
await page.waitForFunction(() => globalThis.copied);
expect((await page.evaluate(() => globalThis.copied)).endsWith('cube-cull.html#cull=both'), 'a link has what was just set');
await pressed('Copy iframe');
await page.waitForFunction(() => /^<iframe src="[^"]*\?embed#cull=both" width="700" height="500" allow="[^"]*" title="[^"]*"><\/iframe>$/.test(globalThis.copied));
await page.evaluate(() => {
  const makeLink = URL.createObjectURL;
  URL.createObjectURL = (blob) => ((globalThis.film = blob), makeLink(blob));
  HTMLAnchorElement.prototype.click = () => {};
  // What is recorded is handed over in small parts, so that the test sees it grow.
  const start = MediaRecorder.prototype.start;
  globalThis.filmed = 0;
  MediaRecorder.prototype.start = function () {
    this.addEventListener('dataavailable', ({ data }) => (globalThis.filmed += data.size));
    start.call(this, 50);
  };
});
await pressed('Record'); // of a picture that rests
await page.waitForFunction(() => globalThis.filmed > 0);
await pressed('End the film');
await page.waitForFunction(() => globalThis.film?.size > 0 && /^video\//.test(globalThis.film.type));
await page.close();

// Another language: its words, and what the demo says in it; the way there and back keeps what is shown
page = await opened('cube-cull.is.html#cull=none');
equal(await page.$eval('html', (root) => root.lang), 'is', 'the language of a page');
equal(await text(page, '#help-cull'), 'hvaða hliðum á að eyða', "a knob's help");
equal(await page.$eval('#knob-winding option', (option) => option.title), 'rangsælis á skjánum', "a choice's meaning");
equal(await text(page, '.knob.is-idle .idle'), 'tekatillinn einn er gerður úr bótum', 'why a knob does nothing');
equal(await page.$eval('.readouts tr', (one) => one.title), 'hliðar teningsins sem snúa að auganu, af 6', 'what a readout says');
equal(await text(page, '.compare summary'), 'Bera saman', "the page's own words");
equal(await text(page, '.panel td'), '3', 'and the number');
const inIcelandic = await sumOf(page);
const followed = async (selector) => {
  await Promise.all([page.waitForNavigation(), press(page, selector)]);
  await page.waitForFunction(() => document.querySelector('.live.is-live')?.live);
};
await followed('a.language[hreflang="en"]');
equal(await page.evaluate(() => `${document.documentElement.lang} ${location.pathname.replace(/.*\//, '')}${location.hash}`), 'en cube-cull.html#cull=none', 'the same in English');
equal(await text(page, '#help-cull'), 'which faces to discard', 'its help');
equal(await sumOf(page), inIcelandic, 'the same picture');
await followed('a.language[hreflang="is"]');
equal(await page.evaluate(() => `${document.documentElement.lang} ${location.pathname.replace(/.*\//, '')}${location.hash}`), 'is cube-cull.is.html#cull=none', 'and back');
await page.close();
page = await opened('shadow.is.html');
equal(await text(page, 'main > .notes'), 'Þessi kafli hefur ekki verið þýddur enn og stendur hér á ensku.', 'a lesson that is not translated says so');
equal(await page.$eval('article', (lesson) => lesson.lang), 'en', 'and is English');
await page.close();

// In the frame of another page: the picture and the knobs that are asked for
page = await opened('cube-cull.html?embed&knobs=cull,z-dist', { width: 700, height: 500 });
equal((await page.$$eval('.knob', (knobs) => knobs.map((knob) => knob.querySelector('label').textContent))).join(), 'cull,z-dist', 'knobs that are asked for');
expect(await page.$eval('.knob', (knob) => knob.getBoundingClientRect().bottom < innerHeight), 'they are in sight');
expect(await page.$eval('h1', (heading) => !heading.clientHeight), 'and no heading is');
await page.close();

// The picture stays in sight over its controls, on a phone and a laptop, and covers none that the keyboard comes to
for (const [width, height] of [[390, 700], [1366, 641]]) {
  for (const demo of ['robot-arm', 'pipeline', 'cube-cull']) {
    page = await opened(`${demo}.html`, { width, height });
    const found = await page.$$eval('.knobs :is(input, select)', (controls) => controls.filter((control) => !control.closest('details:not([open])')).map((control) => {
      control.focus();
      const at = control.getBoundingClientRect(), picture = document.querySelector('#canvas').getBoundingClientRect();
      const seen = Math.min(innerHeight, picture.bottom) - Math.max(0, picture.top);
      const above = document.elementFromPoint(at.left + at.width / 2, at.top + at.height / 2);
      return !at.width || (seen >= 0.6 * picture.height && (above === control || control.contains(above))) ? '' : control.id || control.ariaLabel;
    }).filter(Boolean));
    equal(found.join(), '', `${demo} at ${width} x ${height}: controls without the picture, or under it`);
    await page.close();
  }
}

// On a dense screen, and on a phone, the canvas has the screen's pixels, and nothing else is other than on an ordinary one: a drag goes as
// far, a handle to where the pointer is, and link and command are the same
const seenOn = async (deviceScaleFactor, where, act, view) => {
  page = await opened(where, { ...view, deviceScaleFactor });
  const at = await (await page.$('#canvas')).boundingBox();
  await act?.(at);
  await settled(page);
  const found = await page.evaluate(() => ({
    canvas: ['#canvas', 'canvas.second'].map((one) => document.querySelector(one)).filter(Boolean).map(({ width, height, clientWidth, clientHeight }) => [width, height, clientWidth, clientHeight].join()),
    command: document.querySelector('.command code').textContent,
    handles: document.querySelector('.live').live.demo.tells('Handles').map(({ x, y }) => [x, y]),
  }));
  if (act) await page.waitForFunction((opened) => { // once it rests
    const knobs = document.querySelector('.live').live.demo.tells('Knobs');
    return location.hash !== opened && [...new URLSearchParams(location.hash.slice(1))].every(([name, value]) => !(name in knobs) || knobs[name] === value);
  }, {}, where.replace(/^[^#]*/, ''));
  found.hash = await page.evaluate(() => location.hash);
  await page.close();
  return found;
};
const dragged = (from, to) => async (at) => {
  await page.mouse.move(at.x + from[0], at.y + from[1]);
  await page.mouse.down();
  await page.mouse.move(at.x + to[0], at.y + to[1], { steps: 4 });
  await page.mouse.up();
};
for (const [where, act] of [['cube-cull.html', dragged([200, 200], [261, 223])], ['shadow-map.html#compare=filter,pcf7', dragged([100, 300], [140, 310])]]) {
  const [ordinary, dense] = [await seenOn(1, where, act), await seenOn(2, where, act)];
  equal(ordinary.canvas[0], '600,600,600,600', `${where}: the canvas on an ordinary screen`);
  for (const one of dense.canvas) equal(one, '1200,1200,600,600', `${where}: the canvas on a dense screen`);
  equal(dense.canvas.length, ordinary.canvas.length, `${where}: pictures`);
  equal(dense.command, ordinary.command, `${where}: the command line on a dense screen`);
  equal(dense.hash, ordinary.hash, `${where}: the link on a dense screen`);
  expect(!/--size|--density/.test(dense.command) && dense.command.includes('spin-y'), `${where}: the command line has the drag and no size: ${dense.command}`);
}
const { handles: [here] } = await seenOn(1, 'clipping.html');
const there = [Math.round(here[0]) + 40, Math.round(here[1]) + 30];
const moved = await seenOn(2, 'clipping.html', dragged(here, there));
expect(moved.handles.some(([x, y]) => Math.hypot(x / 2 - there[0], y / 2 - there[1]) <= 1), `a handle that is dragged from ${here} to ${there} on a dense screen: ${JSON.stringify(moved.handles)}`);
equal((await seenOn(3, 'keyframes.html', undefined, { width: 390, height: 844 })).canvas[0].split(',')[0], `${3 * 358}`, "the canvas' width on a phone");
// Words are twice as many pixels high there: the same rows of the picture hold them
const wordRows = async (deviceScaleFactor) => {
  page = await opened('gpu-stages.html', { deviceScaleFactor });
  await settled(page);
  const rows = await page.evaluate(() => {
    const { demo, size } = document.querySelector('.live').live, { width, height } = size(), pixels = demo.pixels(width * height);
    // The table's head: dark on light, from three quarters of the width on
    const isDark = (row) => { for (let x = Math.round(0.75 * width); x < width; ++x) if (pixels[4 * (row * width + x)] < 100) return true; return false; };
    let first = 0, last;
    while (!isDark(first)) ++first;
    for (last = first; isDark(last); ++last);
    return last - first;
  });
  await page.close();
  return rows;
};
const rows = [await wordRows(1), await wordRows(2)];
expect(rows[0] >= 6 && Math.abs(rows[1] - 2 * rows[0]) <= 2, `rows of a word on an ordinary screen and a dense one: ${rows}`);
page = await opened('gpu-stages.html#compare=show,stages', { width: 390, deviceScaleFactor: 2 }); // where words have their least size
await page.waitForFunction(() => document.querySelector('.label.is-b')?.textContent === 'show stages');
equal(await sumOf(page, 'second'), await sumOf(page), 'the other picture of the same settings, on a dense screen');
await page.close();
// Where there is less room, a table of numbers is smaller and not cut off, and where nobody could read it there is none
for (const [width, isThere] of [[700, true], [390, false]]) {
  page = await opened('pipeline.html', { width });
  await settled(page);
  const ink = await page.evaluate(() => {
    const { demo, size } = document.querySelector('.live').live, { width, height } = size(), pixels = demo.pixels(width * height);
    const dark = (from, to, low, high) => { for (let y = low; y < high; ++y) for (let x = from; x < to; ++x) if (pixels[4 * (y * width + x)] < 150 && pixels[4 * (y * width + x) + 2] < 190) return true; return false; };
    return [dark(Math.round(0.88 * width), width - 2, 0, height), dark(width - 2, width, 0, height) || dark(Math.round(0.6 * width), width, height - 2, height)];
  });
  equal(ink.join(), `${isThere},false`, `pipeline on ${width} pixels: its numbers, and any that are cut off`);
  await page.close();
}
// Where frames take long, the picture is coarser, and a line says so
page = await opened('springs.html', { deviceScaleFactor: 2 });
await page.evaluate(() => { // a processor that has other work
  const work = () => {
    for (const end = performance.now() + 40; performance.now() < end;);
    if (document.querySelector('.coarse').hidden) requestAnimationFrame(work);
  };
  work();
});
await page.waitForFunction(() => !document.querySelector('.coarse').hidden && document.querySelector('#canvas').width === document.querySelector('#canvas').clientWidth);
await page.close();

// Narrow and wide: nothing is cut off, nothing moves sideways
page = await browser.newPage();
await page.setViewport({ width: 320, height: 700 });
for (const demo of demosOf(program)) {
  await page.goto(`${address}demos/${demo}.html`);
  await page.waitForSelector('.live.is-live');
  const beyond = await page.evaluate(() => document.scrollingElement.scrollWidth - innerWidth);
  expect(beyond <= 0, `${demo} on 320 pixels: ${beyond} beyond the edge`);
}
await page.close();
for (const width of [360, 800, 1600]) {
  for (const demo of ['shadow-map', 'springs', 'cube-cull']) {
    page = await opened(`${demo}.html`, { width, height: 900 });
    const beyond = await page.evaluate(() => document.scrollingElement.scrollWidth - innerWidth);
    expect(beyond <= 0, `${demo} on ${width} pixels: ${beyond} beyond the edge`);
    await page.close();
  }
}
// Beside its controls the picture stays in sight
page = await opened('shadow-map.html');
const top = await page.evaluate(() => {
  document.querySelector('.readouts').scrollIntoView({ behavior: 'instant', block: 'end' });
  return document.querySelector('#canvas').getBoundingClientRect().top;
});
expect(top >= 0, `the canvas while its last controls are in sight: ${-top} pixels above the window`);
await page.close();

// On paper, as wide as a sheet between its margins: nothing is cut off, and answers are open
for (const demo of ['shadow-map', 'springs']) {
  page = await opened(`${demo}.html`, { width: 720, height: 1000 });
  await page.emulateMediaType('print');
  await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
  const cut = await page.$$eval('pre, .wide', (boxes) => boxes.filter((box) => box.scrollWidth > box.clientWidth + 1).map((box) => box.textContent.trim().slice(0, 60)));
  equal(cut.join('; '), '', `${demo} on paper: what is cut off`);
  equal(await page.$$eval('article details', (answers) => answers.filter((answer) => !answer.open).length), 0, `${demo} on paper: answers that are folded`);
  await page.close();
}
// And the picture is what the canvas shows
page = await opened('cube-cull.html#cull=front');
const onPaper = () => page.$eval('.shown', (picture) => picture.getAttribute('src'));
const fromFile = await onPaper();
await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
const printed = await page.$eval('.shown', async (picture) => {
  await picture.decode();
  const copy = Object.assign(document.createElement('canvas'), { width: picture.width, height: picture.height }), pen = copy.getContext('2d');
  pen.drawImage(picture, 0, 0);
  const { demo, what } = document.querySelector('.live').live, own = demo.pixels(what.width * what.height);
  return pen.getImageData(0, 0, what.width, what.height).data.every((byte, i) => byte === own[i]);
});
expect(printed, 'on paper stands the picture of the canvas');
await page.evaluate(() => dispatchEvent(new Event('afterprint')));
equal(await onPaper(), fromFile, 'and the file again after it');
// A button that copies stands beside no letter of the line
const covered = await page.$eval('article pre > button', (button) => {
  const one = button.getBoundingClientRect(), other = button.parentElement.querySelector('code').getBoundingClientRect();
  return one.top < other.bottom && one.bottom > other.top;
});
expect(!covered, 'the button lies over the line that it copies');
// A text that the module has no room for is refused in words
await unfold(page, '.shaders');
await page.$eval('.shaders textarea', (area) => {
  area.value = 'x'.repeat(1_000_000);
  area.dispatchEvent(new Event('input'));
});
await page.waitForSelector('.mistakes li');
equal(await text(page, '.mistakes li'), 'A shader may have at most 100000 letters, not 1000000.', 'a shader that is too long');
await page.close();
// On a phone a drag goes by whole pixels of the picture, and a knob keeps its few digits
page = await opened('cube-cull.html', { width: 391, height: 700 });
const small = await (await page.$('#canvas')).boundingBox();
await page.mouse.move(small.x + 100, small.y + 100);
await page.mouse.down();
await page.mouse.move(small.x + 151.3, small.y + 117.7, { steps: 3 });
await page.mouse.up();
await settled(page);
const digits = await page.$eval('#knob-spin-y', (field) => field.value);
expect(/^-?\d+$/.test(digits) && digits !== '30', `a knob that is dragged on a phone: ${digits}`);
await page.close();

// ---- what a page loads: docs/browser.md has it by files

const loaded = mostOf(loadedBy(site));
expect(loaded <= mostLoaded, `what a page loads, in brotli: at most ${mostLoaded} bytes, ${loaded}`);

const largest = Math.max(...modulesOf(site).map((file) => largestFunction(fs.readFileSync(path.join(site, file)))));
expect(largest <= largestAllowed, `the largest function of the module: at most ${largestAllowed} bytes, ${largest}: lessons are made when they are asked for`);

// ---- without WebGL, and from a disk: pictures and a sentence

const plain = await browserOf(build, ['--disable-3d-apis']);
const still = await plain.newPage();
await still.goto(`${address}demos/cube-cull.html`);
await still.waitForSelector('.live.is-still');
expect((await text(still, '.refused')).includes('WebGL 2: must be there'), `a sentence where there is no WebGL: ${await text(still, '.refused')}`);
expect(await still.$eval('.shown', (picture) => picture.clientWidth > 0), 'and the picture');
await still.$$eval('.thumbs a', (links) => links[1].click());
expect((await text(still, '.command code')).includes('--'), `a small picture is shown: ${await text(still, '.command code')}`);
// A module that does not come is told, after ten seconds; a script that cannot be loaded at once; and so is a page whose host forbids what a
// module needs
const slow = await browser.newPage();
await slow.setRequestInterception(true);
slow.on('request', (request) => (request.url().endsWith('.wasm') ? undefined : request.continue()));
await slow.goto(`${address}demos/cube-cull.html`, { waitUntil: 'domcontentloaded' });
await slow.waitForFunction(() => document.querySelector('.loading')?.textContent.includes('has not come for ten seconds'));
await slow.close();
const lost = await browser.newPage();
await lost.setRequestInterception(true);
lost.on('request', (request) => (request.url().endsWith('/live.js') ? request.abort() : request.continue()));
await lost.goto(`${address}demos/cube-cull.html`);
equal(await text(lost, '.refused'), 'The demo cannot be drawn here, so its pictures stand: its script (live.js) could not be loaded', 'a script that does not come');
expect(await lost.$eval('.sources', (last) => last.clientHeight > 0), 'and the lesson');
await lost.close();
const strict = await browser.newPage();
await strict.setRequestInterception(true);
strict.on('request', async (request) => {
  if (!request.isNavigationRequest()) return request.continue();
  const answer = await fetch(request.url());
  request.respond({ status: 200, headers: { 'content-type': 'text/html', 'content-security-policy': "default-src 'self'" }, body: await answer.text() });
});
await strict.goto(`${address}demos/cube-cull.html`);
await strict.waitForSelector('.live.is-still');
expect((await text(strict, '.refused')).startsWith('The demo cannot be drawn here'), `under a strict policy: ${await text(strict, '.refused')}`);
await strict.close();
// And where the page that holds this one forbids modules
await still.setContent(`<iframe sandbox="allow-scripts" src="${address}demos/cube-cull.html"></iframe>`);
const inner = await (await still.waitForSelector('iframe')).contentFrame();
await inner.waitForFunction(() => document.querySelector('.live.is-still'));
await still.goto(`${pathToFileURL(site)}/demos/cube-cull.html`);
expect((await text(still, '.panel')).includes('./run --site --serve'), `from a disk: ${await text(still, '.panel')}`);
expect(await still.$eval('.shown', (picture) => picture.clientWidth > 0 && picture.naturalWidth > 0), 'with the picture');
await plain.close();
await browser.close();

console.log(`${counted.checks} checks, ${counted.failures} failed`);
process.exit(counted.failures ? 1 : 0);
