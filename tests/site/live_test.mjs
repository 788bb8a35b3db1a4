// node live_test.mjs SOURCE MVGL NATIVE BUILD [--software] [--all-ends] [--half 1|2] [DEMO...]: the demos alive in their pages, in headless Chromium
// that draws through the same Mesa: pictures, readouts, matrices and sentences are the native program's, of each demo at its presets
// (all but the first a quarter as large), and with --all-ends at each end of each knob (./test --long does). With --software Chromium
// draws by its own SwiftShader, and pictures may differ a little: each demo as it opens, and with --all-ends at its presets. With --half
// each second demo alone: of two that run side by side one works while the other waits.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { browserOf, counted, demosOf, equal, expect, liveSite, opened, scratch, served, skipUnlessBuilt, throughMesa } from './support.mjs';

const [source, program, native, build, ...rest] = process.argv.slice(2);
const software = rest.includes('--software'), allEnds = rest.includes('--all-ends') || Boolean(process.env.MVGL_LONG);
const half = rest.includes('--half') ? Number(rest.splice(rest.indexOf('--half'), 2)[1]) : 0;
if (![0, 1, 2].includes(half)) throw new Error(`--half: must be 1 or 2, ${half}`);
const named = rest.filter((word) => !word.startsWith('--'));
skipUnlessBuilt(build);

// ---- what may differ, by name and with its reason

// In a page the last digit of a sine or a power is another library's than the native program's. Where that decides about pixels:
// a share of them that may differ, of the settings named.
const share = ({ demo, settings }) => {
  // An edge of the walker's foot goes through the middles of pixels.
  if (demo === 'robot-arm' && settings.scene === 'walker') return 0.001;
  // Of eight thousand steps one ends on the other side of a pixel's edge.
  if (demo === 'path' && settings.steps === '8000') return 0.001;
  // An edge of a paper, whose corners are placed by sines, goes through the middles of pixels: no more than are along one edge.
  if (demo === 'shadow-polygons' && (settings.polygons || settings['paper-size'])) return 0.001;
  return 0;
};
// SwiftShader: where more than a half percent of the pixels differ by more than 3 levels of 255.
const softly = ({ demo, settings }) => {
  // A view made so small that the planes of a float matrix are noise.
  if (demo === 'view-volume' && settings.planes === 'float-matrix') return { levels: 10, share: 0.02 };
  // It rounds each time that a letter's edge is laid over a line or another picture, and draws no line with a corner behind the eye.
  if (['view-volume', 'path', 'clipping', 'keyframes', 'frame-rate'].includes(demo)) return { levels: 10, share: 0.005 };
  // What is cut at the edge of its guard band has texture coordinates that are less exact: floors that reach behind the eye.
  if (demo === 'texture-filter' || demo === 'texture-map' || (demo === 'procedural' && settings.view === 'floor')) return { levels: 3, share: 0.4 };
  // The pixels that OpenGL sets, beside those of the lesson: lines are each renderer's own, as with the golden pictures.
  if (demo === 'rasterizer') return { levels: 3, share: 0.03 };
  // Two planes that the depth buffer cannot tell apart.
  if (demo === 'z-buffer' && settings.separation) return { levels: 3, share: 0.4 };
  // A shadow map without a bias: the last digits decide.
  if (demo === 'shadow-map' && settings.bias === '0') return { levels: 3, share: 0.05 };
  if (demo === 'shadow-methods' && settings.receiver === 'on') return { levels: 3, share: 0.01 };
  return { levels: 3, share: 0.005 };
};
const allowed = (one) => (software ? softly(one) : { levels: 0, share: share(one) });

// To the six digits that are shown; below a billionth is what two libraries of mathematics round differently. What is measured in
// units of a double's last place is so by a long double, which has 11 binary digits more here and 60 in a page.
function isAlike(found, expected, unit = '') {
  if (typeof expected === 'number') return Math.abs(found - expected) <= Math.max(unit === 'ulp' ? 2 ** -11 : 1e-9, 1e-6 * Math.abs(expected));
  if (expected === null || typeof expected !== 'object') return found === expected;
  const keys = Object.keys(expected);
  return Object.keys(found).join() === keys.join() && keys.every((key) => isAlike(found[key], expected[key], expected.unit));
}

// ---- each picture as the native program shows it

const address = await served(source, liveSite(build));
const started = () => browserOf(build, software ? ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'] : throughMesa);
let browser = await started();
const demos = demosOf(program).filter((name, i) => (!named.length || named.includes(name)) && (!half || i % 2 === half - 1));
let pictures = 0, same = 0, standing = 0, worst = ['none', 0];

// What the page shows at those settings. The native picture comes as base64, and is compared there.
const shown = async (name, { settings, frame, width, height }, expected, tolerated) => {
  const { demo, withPictures } = document.querySelector('.live').live;
  await withPictures(settings, () => undefined);
  const opening = demo.says('Open', name, settings, frame, true);
  if (opening) return { error: opening };
  while (demo.does('Draw', width, height, true));
  const { error } = demo.tells('State');
  if (error || !expected) return { error };
  const pixels = demo.pixels(width * height), wanted = Uint8Array.from(atob(expected), (one) => one.charCodeAt(0));
  let different = 0;
  for (let i = 0; i < pixels.length; i += 4) {
    let most = 0;
    for (let k = 0; k < 4; ++k) most = Math.max(most, Math.abs(pixels[i + k] - wanted[i + k]));
    different += most > tolerated;
  }
  return { ...demo.tells('Report'), error, different, of: wanted.length / 4, found: pixels.length / 4 };
};

// Pixels of the canvas that differ from the picture which stands in its place until the demo is there; null: that is another frame.
const replaced = async (width, height) => {
  if (document.querySelector('.thumbs a').dataset.command.includes('--frame')) return null;
  const picture = document.querySelector('.shown'), copy = new OffscreenCanvas(width, height).getContext('2d');
  await picture.decode();
  copy.drawImage(picture, 0, 0);
  const { data } = copy.getImageData(0, 0, width, height), pixels = document.querySelector('.live').live.demo.pixels(width * height);
  let different = 0;
  for (let i = 0; i < data.length; i += 4) different += [0, 1, 2].some((k) => data[i + k] !== pixels[i + k]);
  return different;
};
// The picture is the core profile's, which has stages that ES 3.0 lacks, and does not filter across the edges of a cube map.
const standsForAnother = ['displacement', 'gpu-stages', 'environment'];

async function meet(demo) {
  const cases = allEnds ? (software ? [] : ['--ends']) : [software ? '--opening' : '--smaller'];
  const start = Date.now();
  const folder = fs.mkdtempSync(path.join(scratch, 'native-'));
  const all = JSON.parse(execFileSync(native, [folder, demo, ...cases], { cwd: source, encoding: 'utf8', maxBuffer: 1 << 28 }));
  const page = await opened(browser, address, `${demo}.html`);
  for (const expected of all) {
    const { settings, frame, width, height } = expected, what = `${demo} ${JSON.stringify(settings)} at frame ${frame}`;
    const picture = expected.picture && fs.readFileSync(path.join(folder, expected.picture)).toString('base64');
    const may = allowed({ demo, settings }), one = await page.asked(shown, demo, { settings, frame, width, height }, picture, may.levels);
    equal(one.error, expected.error, `${what}: its sentence`);
    if (expected.error || one.error) continue;
    ++pictures;
    same += one.different === 0;
    equal(one.found, one.of, `${what}: pixels`);
    if (!software && frame === 1 && !Object.keys(settings).length) {
      const others = await page.asked(replaced, width, height);
      standing += others === 0;
      if (others !== null && !standsForAnother.includes(demo))
        equal(others, 0, `${what}: pixels that differ from the picture that stands until the demo is there`);
    }
    const part = one.different / one.of;
    if (part > worst[1]) worst = [what, part];
    expect(part <= may.share, `${what}: ${one.different} pixels of ${one.of} differ by more than ${may.levels} levels from the native program's`);
    equal(JSON.stringify(one.messages), JSON.stringify(expected.messages), `${what}: messages`);
    if (one.idle.threads === 'a page in a browser has one thread') delete one.idle.threads;
    equal(JSON.stringify([one.knobs, one.idle]), JSON.stringify([expected.knobs, expected.idle]), `${what}: knobs`);
    // What a driver counts is its own.
    if (software) continue;
    for (const words of ['readouts', 'matrices'])
      expect(isAlike(one[words], expected[words]), `${what}: ${words}: expected ${JSON.stringify(expected[words])}, found ${JSON.stringify(one[words])}`);
  }
  await page.close();
  fs.rmSync(folder, { recursive: true });
  console.log(`${demo}: ${all.length} setting${all.length > 1 ? 's' : ''}, ${((Date.now() - start) / 1000).toFixed(1)} s`);
}

for (const demo of demos) {
  const before = { ...counted }, sums = [pictures, same, standing, worst];
  try {
    await meet(demo);
  } catch (error) {
    // A browser can run out of memory, or be stopped by the system. A page that is at fault fails again, and other errors are its own.
    if (!/crashed|timed out|closed/i.test(error.message)) throw error;
    console.log(`note: ${demo}: ${error.message}; once more, in a new browser`);
    await browser.close().catch(() => browser.process()?.kill('SIGKILL'));
    browser = await started();
    Object.assign(counted, before);
    [pictures, same, standing, worst] = sums;
    await meet(demo);
  }
}
await browser.close();

console.log(`${demos.length} demos, ${pictures} pictures, ${same} ${software ? 'alike everywhere' : 'byte for byte the native ones'}, the worst ${worst[0]} with ${(100 * worst[1]).toFixed(3)} % others;${software ? '' : ` on ${standing} pages the picture that stands first is the one that is drawn;`} ${counted.checks} checks, ${counted.failures} failed`);
process.exit(counted.failures ? 1 : 0);
