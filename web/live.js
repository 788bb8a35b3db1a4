// A demo alive in its page: the module that all pages share draws it into a canvas, where the picture was.
import openModule from 'mvgl';
import { comparison } from './compare.js';
import { knobRows, matrixTables, presetButtons, readoutTable, tag } from './controls.js';
import { endless, shaderEditor } from './edit.js';
import { handIn } from './hand.js';
import { fetched, isNamedAs, provide, take } from './pictures.js';
import { fromAddress, fromCommand, toAddress, typedNumber } from './settings.js';
import { asCanvas, shareButtons } from './share.js';
import { drawSteps } from './steps.js';

const pause = 100; // milliseconds between two looks at the readouts of what moves
const quiet = 250; // milliseconds after which the address is written
const mostShader = 100_000; // letters of a shader: what the module is handed at once has room in its memory
const near = 2000; // so many frames are computed at once
const densest = 3; // pixels of the canvas for each of the page's: more of them nobody sees
const patience = 200; // milliseconds: a page that has taken longer to come so far is shown before its demo is begun
const slowest = 1000 / 30, slowFrames = 30; // milliseconds of a frame; after so many that took longer there are fewer pixels

// Settings as the module takes them, a line for each. (A line's end within a value is refused as part of it.)
const lines = (settings) => Object.entries(settings).map(([knob, value]) => `${knob} ${value.replaceAll('\n', '\u21b5')}\n`).join('');

// A page has no flags: what is said of --near is said of near.
const withoutFlags = (words) => words.replace(/(^|[\s('])--(?=[a-z])/g, '$1');

// What a demo says in English, in this page's language where it has the words.
let says; // is below the demo in the page
const said = (words) => (says ??= JSON.parse(document.querySelector('.says')?.textContent ?? '{}'))[words] ?? words;
function translated(what) {
  for (const knob of what.knobs) knob.help = said(knob.help);
  for (const { options = [] } of Object.values(what.widgets)) for (const option of options) option.meaning = said(option.meaning);
  for (const preset of what.presets) preset.lookFor = said(preset.lookFor);
  for (const name of Object.keys(what.readouts)) what.readouts[name] = said(what.readouts[name]);
  what.controls = what.controls.map((row) => row.map(said));
  return what;
}

// The module's functions, by their names in web/page.cpp. Texts come as texts, JSON as what it says.
async function open(canvas) {
  begun.makeContext(canvas);
  const compiled = await begun.compiled, locateFile = () => begun.moduleAt;
  const module = await (compiled ? new Promise((resolve, reject) => openModule({ canvas, locateFile, instantiateWasm(imports, made) {
    let instance;
    try {
      instance = new WebAssembly.Instance(compiled, imports); // at once, before the browser goes on with the page
    } catch { // a Chrome before 114 makes no large one at once; what else is wrong with it, is told by the second try
      WebAssembly.instantiate(compiled, imports).then(made, reject);
    }
    if (instance) made(instance);
    return {};
  } }).then(resolve, reject)) : openModule({ canvas, locateFile }));
  const kinds = { string: 'string', number: 'number', boolean: 'boolean' };
  const call = (answer) => (name, ...given) => {
    const passed = given.map((one) => (typeof one === 'object' ? lines(one) : one));
    return module.ccall(`mv${name}`, answer, passed.map((one) => kinds[typeof one]), passed);
  };
  const text = call('string');
  return {
    does: call('boolean'),
    says: text,
    tells: (name, ...given) => JSON.parse(text(name, ...given)),
    // A picture or a text of that name, for knobs that take a file.
    give(name, { width, height, pixels, text }) {
      const at = text ? call('number')('ReceiveText', name, text.length) : call('number')('ReceivePicture', name, width, height);
      if (at) module.HEAPU8.set(pixels ?? text, at);
    },
    // The bytes of so many pixels: of the picture, or by another function's name of what that one gives.
    pixels(size, name = 'Pixels', ...given) {
      const at = call('number')(name, ...given);
      return new Uint8ClampedArray(module.HEAPU8.slice(at, at + 4 * size).buffer);
    },
  };
}

async function live(box) {
  const panel = box.querySelector('.panel'), isWide = box.classList.contains('is-wide');
  const name = box.dataset.demo, view = box.querySelector('.view'), shown = view.querySelector('.shown');
  const canvas = Object.assign(begun.canvas, { id: 'canvas', tabIndex: 0, hidden: true });
  view.append(canvas);
  const painted = () => new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
  if (performance.now() > patience) await painted();
  const demo = await open(canvas);
  const calm = matchMedia('(prefers-reduced-motion: reduce)').matches;
  let what = { width: Number(shown.getAttribute('width')), height: Number(shown.getAttribute('height')) }; // until the demo is asked
  let values = {}, state, size, slow = 0, drawnAt = 0, isCoarse = false;
  let beside = '', comparing = false; // what is said of the picture that is compared; whether it is to be drawn anew
  let shaders = { changed: () => [], apply() {} }, goal; // the editor of shaders, once there is one; a frame that is far
  let scheduled = false, told = 0, last = performance.now(), visible = true, wanted = false, lost = false, setBy = '';

  // ---- the first picture, as the address says, before what stands beside it is made, and before the demo is asked what that is

  view.style.setProperty('--wide', what.width);
  view.style.setProperty('--high', what.height);
  sized(Math.min(what.width, screen.width)); // what room it has, the browser would lay out the page to say
  const opening = demo.says('Open', name, {}, 1, calm, size.width, size.height);
  if (opening) {
    canvas.remove();
    throw new Error(opening);
  }
  const describe = () => (what = translated({ ...demo.tells('KnobsAndPresets'), ...demo.tells('Describe') }));
  // (#picture= names one of the page's pictures, or is a knob's.)
  const asked = async () => {
    if (location.hash.startsWith('#picture=')) await begun.isRead;
    const pictured = [...document.querySelectorAll('.thumbs a')].find((link) => location.hash === `#picture=${link.dataset.name}`);
    return pictured ? fromCommand(pictured.dataset.command, name, what.knobs, what.presets) : fromAddress(location.hash, what.knobs);
  };
  let given;
  if (location.hash) {
    describe();
    given = await asked();
  }
  if (given) {
    await fetched(what, given.settings);
    provide(demo, what, given.settings);
    const words = setAll(given);
    if (given.frame !== undefined) goTo(given.frame);
    if (given.unknown?.length) await begun.isRead; // whose words say so
    setBy = words || unknown(given.unknown);
  }
  demo.does('Density', size.density);
  demo.does('Draw', size.width, size.height, false);
  performance.mark('first-picture');
  shown.hidden = true;
  canvas.hidden = false;
  await begun.isRead;
  // Once it is on the screen, what it reads out is measured, and the rest of the page is made.
  await painted();
  measure();
  demo.does('Density', size.density);
  if (!given) describe();
  demo.does('Touch');
  demo.does('Draw', size.width, size.height, true);
  state = demo.tells('State');
  canvas.setAttribute('aria-label', word('canvas', { demo: name }));
  document.querySelector('.thumbs [aria-current]')?.removeAttribute('aria-current'); // the canvas shows what its knobs say

  // The knobs, and what is changed at later frames. Why not, or "".
  function setAll({ settings, changes = [] }) {
    return demo.says('SetAll', settings) || (changes.length ? demo.says('SetChanges', changes.map(({ frame, knob, value }) => `${frame} ${knob} ${value.replaceAll('\n', '\u21b5')}\n`).join('')) : '');
  }
  // A frame at once, but where it is far.
  function goTo(frame) {
    goal = undefined;
    if (what.remembers && frame > near) goal = frame;
    else demo.does('GoTo', frame);
  }
  // The canvas has the screen's pixels, of as many of the page's as there is room for.
  function measure() {
    const room = view.getBoundingClientRect().width || what.width;
    sized(room, document.fullscreenElement === box ? innerHeight : undefined);
  }
  function sized(width, height = (width * what.height) / what.width) {
    const density = isCoarse ? 1 : Math.min(densest, Math.max(1, devicePixelRatio)), pixels = (length) => Math.max(1, Math.round(length * density));
    size = { width: pixels(width), height: pixels(height), density };
  }
  function unknown(names = []) {
    return names.length ? word('unknownNames', { names: names.join(', ') }) : '';
  }
  const refused = tag('p', { class: 'refused', role: 'alert' }), notes = tag('p', { class: 'notes', 'aria-live': 'polite' });

  // ---- drawing: a resting canvas draws nothing, and one that is out of sight stops, but for what the user asks for

  function schedule() {
    if (scheduled || lost || !(visible || wanted)) return;
    scheduled = true;
    requestAnimationFrame(tick);
  }
  function tick(now) {
    scheduled = wanted = false;
    if (drawnAt) {
      slow = now - drawnAt > slowest ? slow + 1 : 0;
      drawnAt = 0;
      if (slow === slowFrames) coarsen();
    }
    demo.does('Advance', Math.min(0.1, (now - last) / 1000));
    last = now;
    const before = state.error;
    let more = true;
    try {
      more = travel(); // on the way to a far frame
      const drawn = demo.does('IsDue', size.width, size.height) || comparing;
      more = demo.does('Draw', size.width, size.height, true) || more;
      state = demo.tells('State');
      comparing = false;
      // How long it takes says the next frame. (A picture in passes may take its time: it is shown meanwhile.)
      if (drawn && size.density > 1 && !state.passes) {
        drawnAt = now;
        more = true;
      }
      if (drawn) beside = compare.on() ? compare.draw(demo.tells('Knobs'), state.frame, size, demo) : '';
      if (compare.on()) more = compare.more(size) || more;
      if (drawn && (!state.playing || now - told > pause || state.error !== before)) tellAll(now);
    } finally {
      if (more || state.playing) schedule(); // the clock goes on, whatever failed
    }
  }
  // As many pixels as the page's, where more of them take too long.
  function coarsen() {
    isCoarse = true;
    coarse.hidden = false;
    resized();
  }
  // A demo that remembers is at a far frame after all those before it: some of them at a time, so that the page answers.
  function travel() {
    if (goal === undefined) return false;
    const from = performance.now();
    do {
      const { frame: at } = demo.tells('State'), next = what.remembers ? Math.min(goal, (at > goal ? 1 : at) + 50) : goal;
      demo.does('GoTo', next);
      demo.does('Draw', size.width, size.height, false);
      if (next === goal) goal = undefined;
    } while (goal !== undefined && performance.now() - from < 80);
    state = demo.tells('State');
    tellTime();
    return goal !== undefined;
  }
  // What stands beside the picture.
  function tellAll(now = performance.now()) {
    told = now;
    const report = demo.tells('Report');
    for (const name of Object.keys(report.idle)) report.idle[name] = said(report.idle[name]);
    values = report.knobs;
    knobs.update(values, report.idle);
    if (knobs.haveButtons) knobs.enable(demo.tells('Widgets'));
    presets.update(values);
    readouts.update(report.readouts);
    matrices.update(report.matrices);
    tellTime();
    const { knob, other } = compare.compared();
    command.textContent = demo.says('Command', knob, other);
    say(refused, withoutFlags(state.error || setBy || beside));
    say(notes, state.error ? '' : report.messages.map(said).join(' '));
    view.classList.toggle('is-refused', state.error !== '');
    progress.hidden = state.passes === 0;
    progress.classList.toggle('is-done', state.passesDone === state.passes); // its room stays: nothing below it jumps
    progress.max = Math.max(1, state.passes);
    progress.value = state.passesDone;
    hand.show();
    steps.update(report, state.pictures);
    if (moved && !resting) resting = setTimeout(rest, quiet);
  }
  // What is shown, as an address. (The shaders are in what is copied: an address that changes with each letter is none.)
  // It asks the demo: what was set a moment ago is not drawn yet.
  function addressNow(shaders = []) {
    const { knobs: set } = demo.tells('Report'), { beginning, changes } = demo.tells('Timeline');
    return toAddress(what.knobs.map((knob) => ({ ...knob, value: beginning ? beginning[knob.name] ?? knob.initial : set[knob.name] })), {
      changes, frame: what.animated && !state.playing && state.frame !== 1 ? state.frame : undefined, compared: compare.compared(), until: steps.until(), shaders,
    });
  }
  // Once nothing has changed for a while, the address says what there is: browsers allow a hundred changes in half a minute. And the
  // settings can be come back to.
  let resting = 0, undoing = false;
  const past = [];
  function rest() {
    resting = 0;
    const address = addressNow();
    if (address !== past.at(-1) && !undoing) past.push(address);
    undoing = false;
    try {
      history.replaceState(null, '', address === '#' ? location.pathname + location.search : address);
    } catch {} // a browser that counts otherwise
  }
  addEventListener('pagehide', () => resting && rest());
  addEventListener('keydown', (event) => {
    if (event.key !== 'z' || !(event.ctrlKey || event.metaKey) || event.shiftKey || event.target.matches('textarea, input[type="text"], input[type="number"]') || past.length < 2) return;
    event.preventDefault();
    past.pop();
    undoing = true;
    settle(fromAddress(past.at(-1), what.knobs) ?? { settings: {}, frame: what.animated ? 1 : undefined });
  });
  const say = (element, words) => element.textContent !== words && (element.textContent = words);

  // ---- what the user does

  let moved = false; // the address stays as it came until something is set
  function after(words = '') {
    setBy = words;
    moved = wanted = true;
    state = demo.tells('State');
    schedule();
    if (words || !demo.does('IsDue', size.width, size.height)) tellAll();
  }
  // Before the knobs are set, what they name is there. (Nothing waits where there is nothing to fetch.)
  function withPictures(settings, set) {
    const ready = () => {
      provide(demo, what, settings);
      return set();
    };
    const waits = fetched(what, settings);
    return waits ? waits.then(ready) : ready();
  }
  const settle = ({ settings, changes, frame, compared, until, shaders: edited = {}, unknown: names }) => withPictures(settings, () => {
    steps.show(until);
    const words = setAll({ settings, changes });
    if (frame !== undefined && !words) goTo(frame);
    after(words || unknown(names));
    shaders.apply(edited);
    return compared || compare.on() ? compare.compare(compared) : undefined;
  });
  // Why that is refused, beside the knob; or "".
  const set = (knob, text) => withPictures({ [knob]: text }, () => {
    const words = demo.says('Set', knob, text);
    after();
    return withoutFlags(words);
  });
  // A file of the user's own. What is none of its kind is told, and the knob stays as it was.
  const choose = (knob, file) => take(file, file.name, what.widgets[knob].accept).then(() => {
    set(knob, file.name);
    demo.does('Touch'); // the same name may be another file
    after();
  }, (error) => after(`--${knob}: ${error.message}`));
  const asks = new URLSearchParams(location.search), isEmbedded = asks.has('embed');
  const knobs = knobRows(what, { only: asks.get('knobs')?.split(','), set, press: (knob, label) => after(demo.says('PressButton', knob, label)), choose });
  const takeFiles = what.knobs.filter((knob) => what.widgets[knob.name].kind === 'file');
  if (takeFiles.length) {
    view.addEventListener('dragover', (event) => event.preventDefault()); // or the browser would open it in the place of the page
    view.addEventListener('drop', (event) => {
      event.preventDefault();
      const [file] = event.dataTransfer.files;
      const fits = takeFiles.find((knob) => isNamedAs(file?.name ?? '', what.widgets[knob.name].accept));
      if (file) choose((fits ?? takeFiles[0]).name, file);
    });
  }
  const presets = presetButtons(what, (preset) => settle({ settings: preset.settings }));
  const readouts = readoutTable(what), matrices = matrixTables();
  matrices.element.addEventListener('toggle', () => tellAll());
  const compare = comparison(name, what, view, open, () => {
    comparing = true;
    after();
  }, () => shaders.changed());

  const hand = handIn(view, canvas, demo, what, after);

  const play = tag('button', { type: 'button', onclick: () => after(void demo.does('Toggle')) });
  const frame = tag('input', { type: 'number', step: 1, 'aria-label': word('frame'), min: 0, max: 999999999, onchange() {
    const asked = Math.round(Number(typedNumber(frame.value)));
    const good = asked >= 0 && asked <= Number(frame.max);
    if (good) goTo(asked);
    after(good ? '' : word('frameRefused', { most: frame.max, value: frame.value }));
  } });
  const speed = tag('input', { type: 'range', min: -10, max: 6, step: 1, value: 0, 'aria-label': word('speed'), oninput: () => after(void demo.does('SetSpeed', Number((10 ** (speed.value / 10)).toFixed(1)))) });
  const speedWords = tag('span', { class: 'unit' });
  const time = what.animated
    ? tag('div', { class: 'row time', role: 'group', 'aria-label': word('time') }, play,
        tag('button', { type: 'button', onclick: () => after(void demo.does('Step')) }, word('step')),
        tag('button', { type: 'button', onclick: () => after(void demo.does('Restart')) }, word('restart')), tag('label', {}, `${word('frame')} `, frame), tag('label', {}, `${word('speed')} `, speed), speedWords)
    : '';
  function tellTime() {
    play.textContent = word(state.playing ? 'pause' : 'play');
    if (document.activeElement !== frame) frame.value = state.frame;
    speedWords.textContent = word('times', { number: state.speed });
    travelling.hidden = goal === undefined;
    if (goal !== undefined) travelWords.textContent = word('travelling', { frame: state.frame, goal });
  }

  const travelWords = tag('span', { role: 'status' });
  const travelling = tag('p', { class: 'notes', hidden: true }, travelWords, ' ', tag('button', { type: 'button', onclick() {
    goal = undefined;
    after();
  } }, word('stop')));
  const coarse = tag('p', { class: 'coarse', hidden: true, role: 'status' }, word('coarse'));
  const progress = tag('progress', { 'aria-label': word('passes'), hidden: true });
  const command = box.closest('.stage').querySelector('.command code');
  const pictureRow = tag('div', { class: 'row' },
    tag('button', { type: 'button', onclick: () => settle({ settings: {}, frame: what.animated ? 1 : undefined }) }, word('reset')),
    document.fullscreenEnabled ? tag('button', { type: 'button', onclick: () => (document.fullscreenElement ? document.exitFullscreen() : box.requestFullscreen()) }, word('fullScreen')) : '',
    ...shareButtons({
      name, canvas, demo, compare, isWide, isEmbedded, frame: () => state.frame, density: () => size.density, redraw: () => after(void demo.does('Touch')),
      address: (search) => location.origin + location.pathname + search + addressNow(shaders.changed()),
    }));

  const steps = drawSteps({
    stop: (draws) => after(void demo.does('StopAfter', draws ?? -1)),
    buffer(i) {
      const { width, height } = demo.tells('Buffers')[i];
      if (!width || !height) return undefined;
      const pixels = demo.pixels(width * height, 'BufferPixels', i);
      for (let alpha = 3; alpha < pixels.length; alpha += 4) pixels[alpha] = 255; // shown is the colour
      return asCanvas(width, height, pixels);
    },
  });

  // ---- what is around

  // Thumbnails and the lesson's commands set the canvas.
  for (const link of document.querySelectorAll('.thumbs a')) {
    const given = fromCommand(link.dataset.command, name, what.knobs, what.presets);
    if (!given) continue;
    link.addEventListener('click', (event) => {
      if (event.ctrlKey || event.metaKey || event.shiftKey) return;
      event.preventDefault();
      event.stopImmediatePropagation();
      settle({ frame: what.animated ? 1 : undefined, ...given });
    }, { capture: true });
  }
  for (const block of document.querySelectorAll('article pre')) {
    const code = block.querySelector('code'), lines = code.textContent.trim().split('\n');
    const shows = lines.map((line) => fromCommand(line, name, what.knobs, what.presets));
    if (!shows.some(Boolean)) continue;
    // A button at the end of each line that makes a picture. (What is copied are the lines.)
    code.replaceChildren(...lines.flatMap((line, i) => [
      tag('span', { class: 'line' }, `${line}\n`),
      shows[i] ? tag('button', { type: 'button', class: 'above', 'aria-label': `${word('showAbove')}: ${line}`, onclick: () => {
        settle({ frame: what.animated ? 1 : undefined, ...shows[i] });
        box.scrollIntoView({ behavior: calm ? 'instant' : 'smooth' });
      } }, word('showAbove')) : '',
    ]));
  }
  // On paper stands what the canvas shows.
  const asOpened = Object.fromEntries(['src', 'width', 'height'].map((one) => [one, shown.getAttribute(one)]));
  addEventListener('beforeprint', () => {
    const { width, height } = canvas;
    Object.assign(shown, { src: asCanvas(width, height, demo.pixels(width * height)).toDataURL(), width, height });
  });
  addEventListener('afterprint', () => Object.assign(shown, asOpened));
  addEventListener('hashchange', async () => {
    const linked = await asked();
    if (linked) settle(linked);
  });
  new IntersectionObserver(([entry]) => {
    visible = entry.isIntersecting;
    last = performance.now();
    if (visible) schedule();
  }).observe(view);
  function fit() {
    // Where the controls stand below the picture, it stays in sight above them, and small enough to leave them room.
    box.classList.remove('is-stacked');
    box.classList.toggle('is-stacked', document.fullscreenElement !== box && panel.offsetTop > view.offsetTop);
    resized();
  }
  function resized() {
    measure();
    demo.does('Density', size.density);
    schedule();
  }
  new ResizeObserver(resized).observe(view);
  box.addEventListener('fullscreenchange', fit);
  addEventListener('resize', fit);
  canvas.addEventListener('webglcontextlost', (event) => {
    event.preventDefault();
    lost = true;
    say(refused, word('memoryLost'));
    forget();
    canvas.addEventListener('webglcontextrestored', () => location.reload(), { once: true });
  });

  document.addEventListener('mvgl-settings', ({ detail }) => settle({ settings: detail }));
  const sources = [...document.querySelectorAll('.sources details')].map((one) => ({ name: one.querySelector('summary').textContent, text: one.querySelector('pre').textContent }));
  shaders = shaderEditor(
    sources.filter((file) => file.name.startsWith('shaders/')).map(({ name: file, text }) => ({ name: file.slice('shaders/'.length), text })),
    (file, text) => {
      if (text.length > mostShader) return word('shaderLong', { most: mostShader, value: text.length });
      const loop = endless(text);
      if (loop) return word('shaderEndless', { file, line: loop });
      const mistakes = demo.says('WriteShader', file, text);
      compare.writeShader(file, text);
      compare.touch();
      comparing = true;
      after();
      keep();
      return mistakes;
    },
    () => demo.tells('ShadersInUse'),
  );
  // Edits outlive a reload of the page, until they are put back or the tab is closed.
  const place = `mvgl ${name}`;
  function keep() {
    try {
      sessionStorage.setItem(place, JSON.stringify(Object.fromEntries(shaders.changed())));
    } catch {} // a browser that keeps nothing
  }
  // Where the memory is lost again within a minute, what was edited is likely why: it is not drawn a third time.
  function forget() {
    try {
      if (Date.now() - Number(sessionStorage.getItem(`${place} lost`)) < 60_000) sessionStorage.removeItem(place);
      sessionStorage.setItem(`${place} lost`, Date.now());
    } catch {}
  }
  function kept() {
    try {
      return JSON.parse(sessionStorage.getItem(place)) ?? {};
    } catch {
      return {};
    }
  }

  // ---- the page as it is from now on

  const controls = tag('details', {}, tag('summary', {}, word('keys')), tag('table', {}, ...[
    ...what.controls,
    ...hand.keys,
    ...(what.animated ? [[word('keySpace'), word('keySpaceDoes')]] : []),
  ].map(([does, to]) => tag('tr', {}, tag('th', { scope: 'row' }, does), tag('td', {}, to)))), tag('p', {}, word('keysWhen')));
  panel.replaceChildren(presets.element, refused, notes, coarse, progress, knobs.element, time, travelling, readouts.element, pictureRow, compare.element, matrices.element, steps.element, shaders.element, controls);
  shaders.apply({ ...kept(), ...given?.shaders });
  if (given?.until !== undefined) steps.show(given.until);
  if (given?.compared) compare.compare(given.compared);
  tellAll();
  past.push(addressNow());
  moved = false;
  fit();
  schedule();
  box.classList.add('is-live');
  return { demo, settle, what, compare, withPictures, state: () => state, size: () => size };
}

// The page is read down to here: there are the picture's place and what the demo says. (The rest waits, so that it is drawn before.)
if (!begun.isFile) {
  const box = document.querySelector('.live');
  begun.live = live(box).then((made) => (box.live = made));
  begun.live.catch(() => undefined); // begin.js tells it, once the page is read
}
