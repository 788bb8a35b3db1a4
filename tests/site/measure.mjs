// node measure.mjs SOURCE MVGL BUILD: prints docs/browser.md: what a page loads, when its picture stands and when its demo draws it, each in
// a browser of its own. The processor does what a GPU would: times are an upper bound, and compare pages with each other.
import fs from 'node:fs';
import path from 'node:path';
import { all, browserOf, loadedBy, made, mostLoaded, mostOf, scratch, served } from './support.mjs';

const [source, program, build] = process.argv.slice(2).map((one) => path.resolve(one));
const started = 1500; // milliseconds; for the first half second a browser makes its own window, and keeps two processors busy
const rounds = 9, comparedRounds = 27, demos = ['cube-cull', 'shadow-map', 'springs', 'soft-shadows', 'ray-trace'];
const site = made(source, program, 'site', path.join(build, 'web'));
const address = await served(source, site);

const median = (values) => ((sorted) => (sorted.length % 2 ? sorted[(sorted.length - 1) / 2] : (sorted[sorted.length / 2 - 1] + sorted[sorted.length / 2]) / 2))([...values].sort((a, b) => a - b));
const spread = (values) => median(values.map((value) => Math.abs(value - median(values))));

const files = loadedBy(site);
const count = fs.readdirSync(path.join(site, 'demos')).filter((file) => /^[^.]+\.html$/.test(file)).length;

// The page of a course that ours are measured beside, and the least form of it: the same in one file, begun as soon as it is read.
const course = path.join(scratch, 'course');
fs.cpSync(path.join(source, 'tests/site/course'), course, { recursive: true });
const whole = fs.readFileSync(path.join(course, 'cube-cull.html'), 'utf8');
const script = all(whole, /<script src="(.*?)">/g).map((file) => fs.readFileSync(path.join(course, file), 'utf8')).join('').replace(/window\.onload = \(\) => (\{.*\});/s, '$1');
fs.writeFileSync(path.join(course, 'least.html'), `${whole.replace(/<script src=.*\n/g, '')}<script>\n${script}</script>\n`);
const beside = await served(source, course);

// Interleaved: each round has each page once. The course's page draws no figure, and so our demo is also asked for its picture alone.
const alone = 'cube-cull#apart=off';
const pages = new Map([...demos.map((demo) => [demo, `${address}demos/${demo}.html`]), [alone, `${address}demos/${alone.replace('#', '.html#')}`], ['course', `${beside}cube-cull.html`], ['least', `${beside}least.html`]]);
const times = Object.fromEntries([...pages.keys()].map((name) => [name, { stands: [], drawn: [] }]));

// A picture is drawn when one of its pixels can be read: what was only asked for is not there yet.
function timed() {
  const contexts = new Set(), get = HTMLCanvasElement.prototype.getContext, mark = performance.mark.bind(performance);
  HTMLCanvasElement.prototype.getContext = function (...wanted) {
    const context = get.apply(this, wanted);
    contexts.add(context);
    return context;
  };
  // The picture's time is asked for as soon as it is there.
  new MutationObserver((none, itself) => {
    const picture = document.querySelector('.shown');
    if (!picture) return;
    picture.setAttribute('elementtiming', 'picture');
    itself.disconnect();
  }).observe(document, { childList: true, subtree: true });
  performance.mark = (name) => {
    for (const gl of contexts) gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    return mark(name);
  };
}
// When the page has painted the picture in the canvas's place, or the canvas where that came first or there is none.
const painted = async () => {
  const first = (kind, found) => new Promise((resolve) => {
    new PerformanceObserver((list) => list.getEntries().filter(found).forEach((entry) => resolve(entry.startTime))).observe({ type: kind, buffered: true });
  });
  const picture = await Promise.race([first('element', () => true), new Promise((resolve) => setTimeout(resolve, 300))]);
  return picture ?? Math.max(await first('paint', (entry) => entry.name === 'first-contentful-paint'), performance.getEntriesByName('first-picture')[0].startTime);
};
const compared = ['cube-cull', alone, 'course', 'least'];
for (let round = 0; round < comparedRounds; ++round) {
  for (const [name, where] of pages) {
    if (round >= rounds && !compared.includes(name)) continue;
    const browser = await browserOf(build);
    const page = await browser.newPage();
    await page.evaluateOnNewDocument(timed);
    await new Promise((resolve) => setTimeout(resolve, started));
    await page.goto(where);
    await page.waitForSelector('.live.is-live, .is-drawn', { timeout: 60_000 });
    times[name].drawn.push(await page.evaluate(() => performance.getEntriesByName('first-picture')[0].startTime));
    times[name].stands.push(await page.evaluate(painted));
    await browser.close();
    console.error(`round ${round + 1} of ${comparedRounds}: ${name}`);
  }
}
const ratio = (kind, to) => {
  const each = times[kind === 'drawn' ? alone : 'cube-cull'][kind].map((one, round) => one / times[to][kind][round]);
  return `${median(each).toFixed(2)} | ${spread(each).toFixed(2)} | ${each.filter((one) => one <= 1).length}`;
};
const row = (name) => ['stands', 'drawn'].map((kind) => `${Math.round(median(times[name][kind]))} | ${Math.round(spread(times[name][kind]))}`).join(' | ');
const processor = fs.readFileSync('/proc/cpuinfo', 'utf8').match(/model name\s*: (.*)/)?.[1];
console.log(`# The demos in a browser: sizes and times

<!-- Made by \`node tests/site/measure.mjs\`; a test refuses more than ${mostLoaded / 1000} kB in brotli, which are 2 s of slow 4G. -->

The ${count} demos are ${files.filter(({ file }) => file.endsWith('.wasm')).length} modules, one for each chapter, which a browser loads once and keeps. In brotli a page loads ${Math.round(mostOf(files) / 1024)} KB at most, with the
library, its font and all scripts.

| file | bytes | in brotli |
|---|---:|---:|
${files.map(({ file, bytes, brotli }) => `| ${file} | ${bytes} | ${brotli} |`).join('\n')}

Milliseconds in a browser that was started ${started / 1000} s before and has loaded nothing yet, after the address was given: until the first picture stands, as a file that comes
with the page (a test compares it with what the demo draws, byte for byte, but for what moves and for stages that a browser lacks),
or in the canvas where that is sooner; and until the demo has drawn it, so that a pixel can be read. Median of ${rounds}, with the median deviation. The
processor draws (llvmpipe): ${processor}. Beside them cube-cull's picture by a page as a course has it (\`tests/site/course\`): four
scripts, the calls of such a page, no library, no control, no lesson; and the least form of it, the same in one file, begun
as soon as it is read. It has no figure over the picture, and what is drawn is compared with ours without, by \`${alone}\`. Times of these are of ${comparedRounds} rounds, and differ much from round to round; the ratio is taken in each round.

| cube-cull's page to | picture | ratio | deviation | rounds of ${comparedRounds} in which it is no later |
|---|---|---:|---:|---:|
| a page of a course | stands | ${ratio('stands', 'course')} |
| a page of a course | drawn | ${ratio('drawn', 'course')} |
| the least page | stands | ${ratio('stands', 'least')} |
| the least page | drawn | ${ratio('drawn', 'least')} |

| page | stands | deviation | drawn | deviation |
|---|---:|---:|---:|---:|
${demos.map((demo) => `| [${demo}](../demos/${demo}/${demo}.md) | ${row(demo)} |`).join('\n')}
| ${alone} | ${row(alone)} |
| a page of a course | ${row('course')} |
| the least page | ${row('least')} |`);
process.exit(0);
