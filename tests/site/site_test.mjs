// node site_test.mjs SOURCE MVGL: makes the site and reads it as a browser would: every link and picture is there, every
// lesson is found, and what scripts do is done, in Chromium where there is one.
import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { endless } from '../../web/edit.js';
import { formula } from '../../web/formula.mjs';
import { anchorOf, fold } from '../../web/lesson.mjs';
import { formulasOf, wordsIn } from '../../web/prose.mjs';
import { keysOf, languages, speak, word } from '../../web/words.mjs';
import { all, chromium, counted, demosOf, equal, expect, made, scratch, served } from './support.mjs';

const [source, program] = process.argv.slice(2);
process.env.MVGL_SITE = 'https://example.org/a/course/';
const site = made(source, program, 'a folder/site');
const files = fs.readdirSync(site, { recursive: true }).filter((file) => fs.statSync(path.join(site, file)).isFile());
const pages = new Map(files.filter((file) => file.endsWith('.html')).map((file) => [file, fs.readFileSync(path.join(site, file), 'utf8')]));

// ---- every page

const titles = new Set();
for (const [file, html] of pages) {
  expect(html.startsWith(`<!doctype html>\n<html lang="${file.match(/\.(\w\w)\.html$/)?.[1] ?? 'en'}">`), `${file}: no language`);
  equal(all(html, /<(h1)>/g).length, 1, `${file}: headings of the first level`);
  const [title] = all(html, /<title>(.*?)<\/title>/g);
  // A link that is sent shows a picture, which is there
  const [picture] = all(html, /<meta property="og:image" content="https:\/\/example\.org\/a\/course\/(.*?)">/g);
  expect(!/^demos\//.test(file) || (picture && files.includes(picture)), `${file}: a picture for links to it, '${picture}'`);
  expect(title && !titles.has(title), `${file}: a title of its own, '${title}'`);
  titles.add(title);
  expect(!html.includes(source), `${file}: a path of the machine that made it`);
  expect(!/\]\(\S+\)/.test(html.replace(/<pre.*?<\/pre>/gs, '')), `${file}: Markdown is left`);
  expect(!/<!--|"undefined|undefined"|>undefined<|\[object/.test(html.replace(/<pre.*?<\/pre>/gs, '').replace(/<code>.*?<\/code>/gs, '')), `${file}: what is no text of a page`);
  const ids = all(html, / id="([^"]*)"/g);
  equal(new Set(ids).size, ids.length, `${file}: anchors of one name`);
  for (const image of all(html, /(<img [^>]*>)/g)) {
    expect(/ alt="/.test(image), `${file}: a picture without words, ${image}`);
    expect(/\.svg"/.test(image) || / width="\d+" height="\d+"/.test(image), `${file}: a picture without a size, ${image}`);
  }
  for (const link of all(html, / (?:href|src)="([^"]*)"/g)) {
    if (/^(https?|data):/.test(link)) continue;
    const [target, anchor] = link.split('#');
    const to = target ? path.posix.join(path.posix.dirname(file), target) : file;
    expect(files.includes(to), `${file}: leads nowhere, ${link}`);
    if (anchor && pages.has(to)) expect(pages.get(to).includes(` id="${anchor}"`), `${file}: no such anchor, ${link}`);
  }
  // Nothing is loaded from elsewhere.
  expect(!/<(?:script|link|img)[^>]*(?:src|href)="https?:/.test(html), `${file}: loads something from elsewhere`);
}

// ---- every lesson

const demos = demosOf(program);
const start = pages.get('index.html');
equal(all(start, /<a href="demos\/([^"]+)\.html"/g).join(' '), demos.join(' '), 'lessons of the start page, in order');
for (const file of pages.keys()) expect(!/^docs\/[^/]*$/.test(file) || start.includes(`href="${file}"`), `the start page does not lead to ${file}`);
const cases = fs.readFileSync(path.join(source, 'tests/goldens/cases.txt'), 'utf8').split('\n').map((line) => line.split('|')[0].trim().split(/\s+/));
for (const demo of demos) {
  const html = pages.get(`demos/${demo}.html`) ?? '';
  const shown = all(html, /data-name="([^"]+)"/g), expected = cases.filter((words) => words[1] === demo).map(([name]) => name);
  equal(shown.join(' '), expected.join(' '), `${demo}: its pictures`);
  const inFolder = fs.existsSync(path.join(source, `demos/${demo}/${demo}.md`)) ? `${demo}/${demo}` : demo;
  expect(html.includes(`<summary><code>demos/${inFolder}.cpp</code></summary>`), `${demo}: its code`);
  const after = demos[demos.indexOf(demo) + 1];
  expect(!after || html.includes(`<a rel="next" href="${after}.html">`), `${demo}: leads on to ${after}`);
  // What the lesson says stands there, to its last words
  const words = (text) => text.replace(/<[^>]*>/g, ' ').replace(/&\w+;|[^\w]+/g, ' ');
  const [last] = fs.readFileSync(path.join(source, `demos/${inFolder}.md`), 'utf8').split('<!-- knobs -->')[0].trim().split('\n').slice(-1);
  expect(/^#/.test(last) ? html.includes(last.replace(/^#+ /, '')) : words(html).includes(words(last.replace(/[`*]|\]\([^)]*\)/g, ' ')).trim().slice(-20)), `${demo}: '${last}'`);
}

// ---- parts

equal(anchorOf('The worst that a <code>search</code> finds, &amp; more'), 'the-worst-that-a-search-finds--more', 'anchor');
const folded = fold('<h2 id="q">Questions</h2>\n<p><strong>Why?</strong> So.</p>\n<pre>1</pre>\n<p><em>And?</em></p>\n<p>No.</p>\n<h2>Else</h2>\n<p><strong>Not</strong> folded.</p>');
equal(all(folded, /<summary>(.*?)<\/summary>/g).join(' '), 'Why? And?', 'questions that are folded');
expect(folded.includes('<p>So.</p>\n<pre>1</pre>\n</details>') && folded.includes('<p>No.</p>\n</details>'), `answers below them: ${folded}`);

// Formulas: a whole block or none of it
const shape = (block, names) => formula(block, names)?.replace(/<annotation.*?<\/annotation>/gs, '').replace(/<mspace[^>]*><\/mspace>| (?:lspace|rspace|stretchy|displaystyle|display)="[^"]*"|<\/?(?:mrow|semantics|math)(?: [^>]*)?>/g, '');
const line = (inside) => `<mtable class="lines"><mtr><mtd>${inside}</mtd></mtr></mtable>`;
equal(shape('a + b/2'), line('<mi>a</mi><mo>+</mo><mfrac><mi>b</mi><mn>2</mn></mfrac>'), 'a fraction');
equal(shape('t = (a - b) c / (n.v)'), line('<mi>t</mi><mo>=</mo><mfrac><mo>(</mo><mi>a</mi><mo>−</mo><mi>b</mi><mo>)</mo><mi>c</mi><mi>n</mi><mo>·</mo><mi>v</mi></mfrac>'), 'above the line all of a product');
equal(shape("p' = sqrt(x_min^2 + theta1)"), line('<mi>p</mi><mo>′</mo><mo>=</mo><msqrt><msup><msub><mi>x</mi><mi>min</mi></msub><mn>2</mn></msup><mo>+</mo><msub><mi>θ</mi><mn>1</mn></msub></msqrt>'), 'indices, a prime, a power and a root');
equal(shape('n = u x v, A x + B'), line('<mi>n</mi><mo>=</mo><mi>u</mi><mo>×</mo><mi>v</mi><mo>,</mo><mi>A</mi><mi>x</mi><mo>+</mo><mi>B</mi>'), 'a cross product, and a coordinate');
equal(shape('|a - b| <= <v, w>     z: to the eye'), '<mtable class="lines"><mtr><mtd><mo>|</mo><mi>a</mi><mo>−</mo><mi>b</mi><mo>|</mo><mo>≤</mo><mo>⟨</mo><mi>v</mi><mo>,</mo><mi>w</mi><mo>⟩</mo></mtd><mtd><mtext>z: to the eye</mtext></mtd></mtr></mtable>', 'a length, an inner product, and words');
equal(shape('a/b  0\n0    1'), '<mo>[</mo><mtable class="matrix"><mtr><mtd><mfrac><mi>a</mi><mi>b</mi></mfrac></mtd><mtd><mn>0</mn></mtd></mtr><mtr><mtd><mn>0</mn></mtd><mtd><mn>1</mn></mtd></mtr></mtable><mo>]</mo>', 'a matrix');
expect(!shape('square: 1   2\nshadow: 3   4').includes('matrix'), 'two lines with labels are no matrix');
expect(/<mi>M<\/mi><mo>=<\/mo><mo>\[<\/mo><mtable class="matrix">.*<mo>\]<\/mo>$/.test(shape('    | 1  0 |\nM = | 0  c |')), 'a matrix between bars');
equal(shape('f(-z-dist)', ['z-dist']), line('<mi>f</mi><mo>(</mo><mo>−</mo><mi>z-dist</mi><mo>)</mo>'), "a knob's name");
for (const none of ['glEnable(GL_CULL_FACE);', 'a = (b', 'a ? b', 'a )', '/ b', 'a ^', 'montage -size 512x512 xc:black', 'the same of the light', 'while (a >= b) { a }'])
  equal(formula(none), undefined, `no formula: ${none}`);
expect(formula('a < b').includes('<annotation encoding="text/plain">a &lt; b</annotation>'), 'the text is kept beside it');
const shownAsMath = [...pages.values()].reduce((count, html) => count + all(html, /(<math )/g).length, 0);
expect(shownAsMath > 80, `formulas of all lessons: ${shownAsMath}`);
expect(/<pre tabindex="0"><code>glEnable\(GL_CULL_FACE\)/.test(pages.get('demos/cube-cull.html')), 'code stays code');

// In running words: a run of names, numbers and signs with a relation, a power, an index or a function in it, all of it or nothing
const found = (text) => formulasOf(text).map(({ from, to }) => text.slice(from, to)).join(' | ');
for (const [words, expected] of [
  ['goes from z = -near to z = -far, with w = 1 (a point).', 'z = -near | z = -far | w = 1'],
  ['A point is at d^2/(n 2^24): near = 1.6, in\nthe picture', 'd^2/(n 2^24) | near = 1.6'],
  ['(a matrix with w = 1) and a (the x axis)', 'w = 1'],
  ["the lecture's v_r = v - 2 n (n.v) is the same for", 'v_r = v - 2 n (n.v)'],
  ['what have <n, q - q0> = 0, or |p - c|^2 = r^2, and |x| < 1', '<n, q - q0> = 0 | |p - c|^2 = r^2 | |x| < 1'],
  ['culled = 12 - 2 * facing. What lies', 'culled = 12 - 2 * facing'],
  ['a third at d = 4 m, or 3 m/s^2', 'd = 4 | 3 m/s^2'],
  ['as max(1, n / 2) or sin a = eta has it', 'max(1, n / 2) | sin a = eta'],
  ['x = a point, A > 0 að, and y = E + sum of all, W = 2 tan(25 deg) c', 'A > 0'], // what goes on in words is none
  ['The near plane - or the far one - is left/right, 4x4 or B-spline, 3 * n and 12.5 % of C++', ''],
]) equal(found(words), expected, `formulas in: ${words}`);
equal(wordsIn('<p>At z = 2e-4 <code>w = 1</code>, <a href="x">x &lt; y²</a> &amp; so.</p>'), '<p>At <math><mrow><mi>z</mi><mo>=</mo><mn>2e-4</mn></mrow></math> <code>w = 1</code>, <a href="x"><math><mrow><mi>x</mi><mo>&lt;</mo><msup><mi>y</mi><mn>2</mn></msup></mrow></math></a> &amp; so.</p>', 'among tags, and not in code');
equal(wordsIn('<p>x/(2 y) = 1</p><th>w = 1</th>'), '<p><math><mrow><mi>x</mi><mo>/</mo><mrow><mo stretchy="false">(</mo><mn>2</mn><mspace width="0.2em"></mspace><mi>y</mi><mo stretchy="false">)</mo></mrow><mo>=</mo><mn>1</mn></mrow></math></p><th>w = 1</th>', 'a fraction in a line, and a heading of a column');
equal(wordsIn('<h2>w = 1</h2><pre><code>a = 1</code></pre>&quot;so&quot;'), '<h2>w = 1</h2><pre><code>a = 1</code></pre>&quot;so&quot;', 'what stays');
const inText = [...pages].filter(([file]) => file.startsWith('demos/')).flatMap(([, html]) => all(html, /<math>(.*?)<\/math>/gs));
expect(inText.length > 300, `formulas in the words of all lessons: ${inText.length}`);
const names = new Set(inText.flatMap((one) => all(one, /<mi>(.*?)<\/mi>/g)));
for (const word of ['the', 'is', 'has', 'of', 'and', 'a point', 'with', 'for', 'it']) expect(!names.has(word), `'${word}' is no name of a formula`);

// Loops that surely have no end, and those that may have one; of the lessons' shaders none has such
for (const [shader, line] of [['while (true) x += 1.0;', 1], ['\nfor (;;) { f(); }', 2], ['for (int i = 0; i < 4;) a[i] = 1.0;', 1], ['while (x < 3.0) { y += 1.0; }', 1], ['for (int i = 0; i < 4;) { ++i; }'], ['for (int i = 0; i < 4;) { g(i); }'],
  ['while (true) { if (x > 1.0) break; }'], ['do { x += 1.0; } while (x < 3.0);'], ['while (p.x < 3.0) p.x += 1.0;'], ['// while (true) x;'], ['while (f() < 3.0) y += 1.0;']]) equal(endless(shader), line, `a loop without an end in ${shader}`);
for (const file of fs.readdirSync(path.join(source, 'shaders'), { recursive: true }).filter((one) => path.extname(one))) equal(endless(fs.readFileSync(path.join(source, 'shaders', file), 'utf8')), undefined, `${file}: a loop without an end`);

// What a matrix is made of
globalThis.word = word;
const { madeOf } = await import('../../web/matrix.js');
const turn = [[0, -1, 0, 2], [1, 0, 0, 3], [0, 0, 1, -5], [0, 0, 0, 1]], lens = [[1.5, 0, 0, 0], [0, 2, 0, 0], [0, 0, -3, -4], [0, 0, -1, 0]];
const whole = lens.map((row) => turn[0].map((none, j) => row.reduce((sum, value, k) => sum + value * turn[k][j], 0)));
const matrices = { clipFromView: lens, viewFromModel: turn, clipFromModel: whole, clipFromWorld: whole };
equal(madeOf('clipFromModel', matrices).product, 'clipFromModel = clipFromView * viewFromModel', 'a product');
equal(madeOf('clipFromWorld', matrices).product, '', 'no product without names that fit');
equal(madeOf('clipFromModel', { ...matrices, clipFromModel: turn }).product, '', 'nor without numbers that do');
equal(madeOf('clipFromModel', matrices).entry(0, 3), "Adds 3 to clip's x, wherever the point is.\nRow 1 of clipFromView times column 4 of viewFromModel: 1.5 * 2 + 0 * 3 + 0 * -5 + 0 * 1 = 3.", 'an entry of it');
equal(madeOf('viewFromModel', matrices).entry(1, 0), "1: the y, in view coordinates, of model's x axis.", 'an axis');
equal(madeOf('viewFromModel', matrices).entry(2, 3), "-5: the z, in view coordinates, of model's origin.", 'the origin');
equal(madeOf('clipFromView', matrices).entry(1, 1).split('\n')[1], 'At distance 1 the view goes from y = -0.5 to 0.5: 53.1301 degrees.', 'an angle');
equal(madeOf('clipFromView', matrices).entry(2, 2).split('\n')[1], 'Depth is -1 at distance 1 and 1 at distance 2.', 'the range of depths');
const box = [[0.5, 0, 0, 1], [0, 1, 0, 0], [0, 0, -1, -2], [0, 0, 0, 1]];
equal(madeOf('clipFromView', { clipFromView: box }).entry(0, 0).split('\n')[1], 'The view goes from x = -4 to 0.', 'a box');
equal(madeOf('clipFromView', { clipFromView: box }).entry(2, 3).split('\n')[1], 'Depth is -1 at distance 1 and 1 at distance 3.', 'its depths');

// All that pages say beside the lessons has its words, and no words are left over.
const scripts = fs.readdirSync(path.join(source, 'web')).filter((file) => /\.m?js$/.test(file)).map((file) => fs.readFileSync(path.join(source, 'web', file), 'utf8')).join('\n');
const keys = keysOf('en');
for (const key of all(scripts, /\bword\('(\w+)'/g)) expect(keys.includes(key), `web/words.json: no '${key}'`);
for (const key of keys) expect(scripts.includes(`'${key}'`), `web/words.json: nobody says '${key}'`);

// ---- other languages

const values = (key) => all(word(key, new Proxy({}, { get: (none, name) => `{${String(name)}}` })), /\{(\w+)\}/g).sort().join();
const blanks = Object.fromEntries(keys.map((key) => [key, values(key)]));
expect(languages.includes('is'), `languages: ${languages}`);
for (const which of languages.slice(1)) {
  equal(keysOf(which).join(), keys.join(), `web/words.${which}.json: keys`);
  speak(which);
  for (const key of keys) equal(values(key), blanks[key], `web/words.${which}.json: what '${key}' names`);
  speak('en');
  equal(all(pages.get(`index.${which}.html`), /<a href="demos\/([^"]+)\.\w+\.html"/g).join(), demos.join(), `lessons of the start page in ${which}`);
  for (const demo of demos) {
    const html = pages.get(`demos/${demo}.${which}.html`), own = path.join(source, 'demos', demo, demo);
    expect(html.includes(`<a class="language" hreflang="en" lang="en" href="${demo}.html">`), `${demo} in ${which} leads to English`);
    expect(pages.get(`demos/${demo}.html`).includes(`<a class="language" hreflang="${which}" lang="${which}" href="${demo}.${which}.html">`), `${demo} leads to ${which}`);
    equal(all(html, /<a rel="(?:next|prev)" href="[\w-]+\.(\w+)\.html">/g).every((one) => one === which), true, `${demo} in ${which} leads on in it`);
    const isTranslated = fs.existsSync(`${own}.${which}.md`);
    equal(html.includes('<article lang="en">'), !isTranslated, `${demo} in ${which}: an English lesson says so`);
    speak(which);
    equal(html.includes(word('untranslated')), !isTranslated, `${demo} in ${which}: a line says that it is not translated`);
    speak('en');
    if (!isTranslated) continue;
    // A translation has the commands and measured numbers of the English lesson, and no words of the program that it does not say
    const english = fs.readFileSync(`${own}.md`, 'utf8'), translation = fs.readFileSync(`${own}.${which}.md`, 'utf8');
    const same = [/^\.\/run .*$/gm, /<!--= .*? -->.*?<!--\/-->/g, /^<!-- code \w+ -->$/gm, /\]\(([^)]*)\)/g];
    for (const pattern of same) equal((translation.match(pattern) ?? []).join('\n'), (english.match(pattern) ?? []).join('\n'), `${demo}.${which}.md: ${pattern}`);
    const code = fs.readdirSync(path.dirname(own)).filter((file) => file.endsWith('.cpp')).map((file) => fs.readFileSync(path.join(path.dirname(own), file), 'utf8')).join('').replace(/"\n *"/g, '') + english.replaceAll('`', '');
    const says = JSON.parse(fs.readFileSync(`${own}.${which}.json`, 'utf8'));
    const tables = html.slice(html.lastIndexOf('<h2', html.indexOf('--preset')));
    for (const [words, theirs] of Object.entries(says)) {
      expect(code.includes(words), `${demo}.${which}.json: the program says no '${words}'`);
      expect(!tables.slice(0, tables.indexOf('</article>')).includes(`<td>${words}</td>`), `${demo} in ${which}: '${words}' is left in a table`);
      expect(theirs !== words && theirs !== '', `${demo}.${which}.json: '${words}' is not translated`);
    }
  }
}
expect(pages.get('demos/cube-cull.html').includes('&quot;<span lang="is">Losnum við um helming allra þríhyrninga</span>&quot;'), 'a quotation in Icelandic');
const translated = pages.get('demos/cube-cull.is.html');
for (const words of ['<title>cube-cull: það sem snýr frá sést aldrei (Íslenska)</title>', '<td>hvaða hliðum á að eyða</td>', '<code>ccw</code>: rangsælis á skjánum', 'draga til hægri: <code>spin-y</code> -1 á pixil', '<p class="sentence">Bakhliðareyðing'])
  expect(translated.includes(words), `cube-cull in Icelandic: ${words}`);

// ---- refusals

for (const args of [[], [program]]) {
  const run = spawnSync('node', [path.join(source, 'web/make.mjs'), ...args], { encoding: 'utf8' });
  equal(run.status, 1, `status with ${args.length} arguments`);
  expect(run.stderr.startsWith('error: make.mjs: must have a program and a folder'), run.stderr);
}

// ---- the server

const address = await served(source, site);
equal(await (await fetch(address)).text(), start, 'the start page, served');
for (const [asked, status] of [['demos/shadow.html', 200], ['demos/nothing.html', 404], ['..%2f..%2fetc/passwd', 404], ['%', 400], ['demos', 404]])
  equal((await fetch(address + asked)).status, status, asked);
const known = (await fetch(`${address}site.css`)).headers.get('etag');
equal((await fetch(`${address}site.css`, { headers: { 'if-none-match': known } })).status, 304, 'what the browser has already');
equal((await fetch(`${address}site.css`, { headers: { 'if-none-match': '"else"' } })).status, 200, 'what it has of old');

// ---- in a browser

if (!chromium) console.log('note: there is no Chromium; what scripts do is not tested');
// The page after its scripts have run, and what the console says.
function opened(address) {
  const flags = ['--headless', '--disable-gpu', '--enable-logging=stderr', `--user-data-dir=${scratch}/profile`, '--virtual-time-budget=3000'];
  if (process.getuid() === 0) flags.push('--no-sandbox');
  const run = spawnSync(chromium, [...flags, '--dump-dom', address], { encoding: 'utf8', maxBuffer: 1 << 28 });
  const said = run.stderr.split('\n').filter((line) => /CONSOLE/.test(line));
  equal(said.join('\n'), '', `${address}: the console`);
  return run.stdout;
}
if (chromium) {
  const found = opened(`${address}#find=${encodeURIComponent('soft lamp')}`);
  const hidden = all(found, /<li class="card" data-name="[^"]*" (hidden)/g).length;
  expect(hidden > 0 && hidden < demos.length, `a search leaves some lessons, hides ${hidden}`);
  equal(all(found, /id="found">([^<]*)</g)[0], `${demos.length - hidden} of ${demos.length}`, 'how many it says');
  // By what lessons are about, whatever it is called
  const finds = (asked) => all(opened(`${address}#find=${encodeURIComponent(asked)}`), /<li class="card" data-name="([^"]*)">/g);
  for (const [asked, lesson] of [['Fresnel', 'environment'], ['Bézier', 'keyframes'], ['frustum', 'cube-persp'], ['Cohen', 'clipping'], ['z-fighting', 'z-buffer'], ['anaglyph', 'stereocube']])
    expect(finds(asked).includes(lesson), `${asked} finds ${lesson}`);
  equal(finds('colour').join(), finds('color').join(), 'both spellings');
  equal(all(opened(`${address}#find=xyzzy`), /id="found">([^<]*)</g)[0], 'no lesson has these words', 'a search for nothing');
  // From a disk, too
  for (const where of [address, `${pathToFileURL(site)}/`]) {
    const page = opened(`${where}demos/ray-cast.html#picture=ray-cast-full`);
    expect(/<img class="shown" src="[^"]*ray-cast-full\.png"/.test(page), `${where}: a linked picture is shown`);
    expect(page.includes('./run ray-cast --preset full</code>'), `${where}: with its line`);
    equal(all(page, /(aria-current="true")/g).length, 1, `${where}: pictures that are marked`);
  }
  const studied = opened(`${address}demos/ray-trace.html`);
  const rows = (name) => fs.readFileSync(path.join(source, `docs/errors-and-times/${name}.csv`), 'utf8').split('\n').filter((line) => line.includes(',ok,')).length;
  equal(all(studied, /(<g data-row="\d+" tabindex="0" role="button" aria-label="[^"]+")/g).length, rows('ray-trace.processor'), 'points of the curve, each to be asked');
  expect(!studied.includes('<select'), 'one machine is no choice');
  const both = opened(`${address}demos/shadow-map.html`);
  equal(all(both, /<figure class="drawn" data-machine="([^"]*)"/g).join('; '), 'a processor (llvmpipe); this GPU (NVIDIA H100 80GB HBM3)', 'machines');
  equal(all(both, /(<figure [^>]*hidden)/g).length, 1, 'machines that are not shown at first');
  equal(all(both, /(<g data-row="\d+" tabindex)/g).length, rows('shadow-map.processor') + rows('shadow-map.gpu'), 'points of both');
  for (const file of ['docs/library.html', 'demos/clipping.html']) opened(address + file);
}
console.log(`${pages.size} pages, ${counted.checks} checks, ${counted.failures} failed${chromium ? '' : ', without a browser'}`);
process.exit(counted.failures ? 1 : 0);
