// Makes the site: node web/make.mjs PROGRAM FOLDER [MODULE]. Each lesson becomes a page, with its pictures, curves and sources; a
// start page finds them. MODULE is the folder that has the demos as WebAssembly, a module for each chapter (web/CMakeLists.txt); with it
// they are alive in their pages. All links are relative, so that the folder works at any place of any host, and from a disk.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { folded } from './fold.mjs';
import { formulasIn } from './formula.mjs';
import { anchorOf, fold, imagesIn, linksIn, numbered, quotations, wide } from './lesson.mjs';
import { demoPage, inLanguage, page, scriptIn, startPage, wordsOf } from './pages.mjs';
import { wordsIn } from './prose.mjs';
import { language, languages, scriptOf, speak, word } from './words.mjs';

const root = path.dirname(path.dirname(fileURLToPath(import.meta.url)));
const [program, folder, module] = process.argv.slice(2);
if (!program || !folder) fail('make.mjs', 'must have a program and a folder', process.argv.slice(2).join(' '));

function fail(subject, rule, value = '') {
  console.error(`error: ${subject}: ${rule}${value && `, ${value}`}`);
  process.exit(1);
}
const run = (command, args, input) =>
  execFileSync(command, args, { input, encoding: 'utf8', maxBuffer: 1 << 28, stdio: ['pipe', 'pipe', 'inherit'] });
const text = (file) => fs.readFileSync(path.join(root, file), 'utf8');

// ---- what there is

// [{ chapter, demos: [{ name, sentence }] }], from --list: a chapter's name begins its line, a demo's stands below it.
function chapters() {
  const found = [];
  for (const line of run(program, ['--list']).split('\n').filter(Boolean)) {
    const demo = line.match(/^ {2}(\S+) +(.*)$/);
    if (demo) found.at(-1).demos.push({ name: demo[1], sentence: demo[2] });
    else found.push({ chapter: line, demos: [] });
  }
  return found;
}

// The pictures of each demo with the flags that make them, as the test of the pictures has them.
function pictures() {
  const of = {};
  for (const line of text('tests/goldens/cases.txt').split('\n')) {
    if (!line || line.startsWith('#')) continue;
    const [picture, demo, ...flags] = line.split('|')[0].trim().split(/\s+/);
    (of[demo] ??= []).push({ file: `tests/goldens/${picture}.png`, command: ['./run', demo, ...flags].join(' ') });
  }
  return of;
}

// The width and height in a PNG file's first chunk.
function sizeOf(file) {
  const bytes = fs.readFileSync(path.join(root, file));
  return { width: bytes.readUInt32BE(16), height: bytes.readUInt32BE(20) };
}

// The files of shaders/include that these shaders include, and those that they include.
function included(files) {
  const found = new Set();
  const read = (file) => {
    for (const [, name] of text(file).matchAll(/^\s*#\s*include\s+"([^"]+)"/gm)) {
      const path = `shaders/include/${name}`;
      if (found.has(path)) continue;
      found.add(path);
      read(path);
    }
  };
  files.forEach(read);
  return [...found].sort();
}

function sourcesOf(name) {
  const files = ownSources(name);
  return [...files, ...included(files.filter((file) => file.startsWith('shaders/')))];
}
function ownSources(name) {
  const filesOf = (folder) => (fs.existsSync(path.join(root, folder)) ? fs.readdirSync(path.join(root, folder)).sort().map((file) => `${folder}/${file}`) : []);
  const shaders = filesOf('shaders').filter((file) => path.basename(file).startsWith(`${name}.`));
  if (!fs.existsSync(path.join(root, 'demos', name))) return [`demos/${name}.cpp`, ...shaders];
  // A lesson's folder: the technique first.
  const rank = (file) => [`${name}.cpp`, `${name}.h`].indexOf(path.basename(file)) >>> 0;
  const code = filesOf(`demos/${name}`).filter((file) => !/\.(md|json)$/.test(file));
  return [...code.sort((a, b) => rank(a) - rank(b)), ...filesOf(`shaders/${name}`)];
}

// The fields of a line of CSV, in which a quoted one may hold commas.
const fields = (line) => [...line.matchAll(/("(?:[^"]|"")*"|[^,]*)(?:,|$)/g)].map((found) => found[1].replace(/^"|"$/g, '').replaceAll('""', '"'));

// The committed studies of a demo, a processor's first: the facts of the file's head, what each row sets, and the plot.
function studiesOf(name) {
  const files = ['processor', 'gpu'].map((drawer) => `docs/errors-and-times/${name}.${drawer}`);
  return files.filter((file) => fs.existsSync(path.join(root, `${file}.csv`))).map((file) => {
    const lines = text(`${file}.csv`).split('\n').filter(Boolean), facts = {};
    while (lines[0].startsWith('# ')) {
      const [, fact, value] = lines.shift().match(/^# (.*?): (.*)$/);
      facts[fact] = value;
    }
    const columns = fields(lines.shift());
    const settings = lines.map((line) => {
      const row = fields(line);
      return Object.fromEntries(columns.map((column, i) => [column, row[i]]).filter(([column, value]) => column.startsWith('--') && value).map(([column, value]) => [column.slice(2), value]));
    });
    const svg = text(`${file}.svg`);
    // Its title ends with whose times they are.
    return { facts, settings, svg, machine: svg.match(/<text [^>]*>[^<]*, on ([^<]*)<\/text>/)[1] };
  });
}

// The folder of a chapter's module.
const moduleOf = (chapter) => anchorOf(chapter);

// A script without what only people read; what it imports is in it, from web/ or `module`. (mvgl.js may ask where it lies itself. It need
// not: live.js says where the module is.)
function shorter(script) {
  const flags = ['--bundle', '--format=iife', '--log-override:empty-import-meta=silent', '--minify', '--charset=utf8', '--log-level=warning'];
  if (module) flags.push(`--alias:mvgl=${path.resolve(module, moduleOf(list[0].chapter), 'mvgl.js')}`);
  return execFileSync('esbuild', flags, { cwd: path.join(root, 'web'), input: script, encoding: 'utf8', stdio: ['pipe', 'pipe', 'inherit'] });
}

// ---- one page of Markdown

const written = new Set();
function write(file, content) {
  const target = path.join(folder, file);
  fs.mkdirSync(path.dirname(target), { recursive: true });
  fs.writeFileSync(target, content);
  written.add(file);
}
function copy(file) {
  if (!written.has(file)) write(file, fs.readFileSync(path.join(root, file)));
}

// Where the page of a file of Markdown is: demos/NAME/NAME.md has it as demos/NAME.html.
const placeOf = (file) => file.replace(/^demos\/([^/]+)\/\1(\.\w+)?\.md$/, 'demos/$1$2.md').replace(/\.md$/, '.html');

// Markdown that becomes a page of its own; a link to another one leads to what takes its place.
const isPage = (file) => /^(demos|docs)\/.*\.md$/.test(file);
const instead = { 'README.md': 'index.html' };

// A function of the demo's own code, from the comment above it to its end; <!-- code NAME --> in a lesson stands for it, so that text and
// code cannot part.
function quoted(file, name) {
  const folder = path.dirname(file), found = [];
  for (const source of fs.readdirSync(path.join(root, folder)).filter((one) => one.endsWith('.cpp')).sort()) {
    const lines = text(`${folder}/${source}`).split('\n');
    lines.forEach((line, i) => {
      if (!new RegExp(`^\\w.*\\b${name}\\(`).test(line) || /;\s*$/.test(line)) return;
      const end = /\}$/.test(line) ? i : lines.indexOf('}', i);
      let start = i;
      while (start > 0 && lines[start - 1].startsWith('// ')) --start;
      if (end >= i) found.push({ source, start, code: lines.slice(start, end + 1).join('\n') });
    });
  }
  // The technique's own, where a figure has one of the same name.
  const own = found.filter(({ source }) => source === `${path.basename(folder)}.cpp`);
  if (own.length === 1) found.splice(0, found.length, ...own);
  if (found.length !== 1) fail(file, `must quote a function that its folder has once, <!-- code ${name} -->`, `${found.length} found`);
  const [{ source, start, code }] = found, html = run('highlight', ['-O', 'html', '-f', '--syntax=c++'], code);
  return `<figure class="quoted"><figcaption><code>${source}</code>, ${word('fromLine', { line: start + 1 })}</figcaption>\n<pre class="code" tabindex="0"><code>${html}</code></pre></figure>`;
}

// A lesson's page is there in each language, a page of docs in English.
const pageOf = (place) => (/^[\w-]+\.html$/.test(place) ? inLanguage(place.replace(/\.html$/, '')) : place);

// What a demo says in English, in another language: demos/NAME/NAME.LANG.json, and web/phrases.LANG.json, which is common to all.
function saysOf(name) {
  if (language() === 'en') return {};
  const own = `demos/${name}/${name}.${language()}.json`, common = `web/phrases.${language()}.json`;
  return Object.assign({}, ...[common, own].filter((file) => fs.existsSync(path.join(root, file))).map((file) => JSON.parse(text(file))));
}

// The Markdown of a lesson. In a translation its tables of knobs, presets and readouts are those of the English one, word by word.
function tabled(file) {
  const [, name, which] = file.match(/^demos\/[^/]+\/([\w-]+)\.(\w+)\.md$/) ?? [];
  if (!which) return text(file);
  const says = saysOf(name), [tables] = text(`demos/${name}/${name}.md`).match(/(?<=<!-- knobs -->\n).*(?=<!-- \/knobs -->)/s);
  const said = (words) => says[words] ?? words;
  // A cell is a sentence, or lines of "`word`: what it means".
  const cell = (words) => words.replace(/^( *)(.*?)( *)$/, (all, before, inside, after) => before + inside.split('<br>').map((line) => {
    const [, option, meaning] = line.match(/^(`[^`]*`: )(.*)$/) ?? ['', '', line];
    return option + said(meaning);
  }).join('<br>') + after);
  const control = (words) => words.replace(/^(.*?): (.*?)(\.?)$/, (all, does, to, end) => {
    const [, knob, rest] = said(to.replaceAll('`', '')).match(/^(\S+)( .*)$/);
    return `${said(does)}: \`${knob}\`${rest}${end}`;
  });
  const translated = tables.split('\n').map((line) =>
    line.startsWith('|') ? line.split('|').map(cell).join('|') : line.replace(/^Controls: (.*)$/, (all, list) => `${said('Controls')}: ${list.split(' · ').map(control).join(' · ')}`));
  return text(file).replace(/(?<=<!-- knobs -->\n)/, translated.join('\n'));
}

// The lesson's HTML, with links and pictures as the site has them, and its title apart.
function lesson(file) {
  const here = path.dirname(file);
  const markdown = tabled(file);
  let html = formulasIn(run('cmark-gfm', ['--extension', 'table', '--unsafe'], markdown), markdown)
    .replace(/<!-- code (\w+) -->/g, (all, name) => quoted(file, name))
    .replace(/<!--.*?-->/gs, '');
  html = wordsIn(html);
  html = linksIn(html, (link) => {
    const [target, anchor] = link.split('#');
    const to = path.posix.join(here, target);
    if (!fs.existsSync(path.join(root, to))) fail(file, 'must have links that lead somewhere', link);
    if (to in instead) return path.posix.relative(here, instead[to]);
    if (isPage(to)) return pageOf(path.posix.relative(path.posix.dirname(placeOf(file)), placeOf(to))) + (anchor ? `#${anchor}` : '');
    copy(to);
    return path.posix.relative(path.posix.dirname(placeOf(file)), to) + (anchor ? `#${anchor}` : '');
  });
  html = imagesIn(html, (link) => {
    const image = path.posix.join(here, link);
    copy(image);
    return { ...(image.endsWith('.png') ? sizeOf(image) : {}), src: path.posix.relative(path.posix.dirname(placeOf(file)), image) };
  });
  const title = html.match(/<h1>(.*?)<\/h1>/)?.[1] ?? file;
  return { title, html: quotations(wide(fold(numbered(html.replace(/<h1>.*?<\/h1>\s*/s, ''))))) };
}

function pagesBelow(directory) {
  return fs.readdirSync(path.join(root, directory), { recursive: true })
    .map((file) => `${directory}/${file}`)
    .filter(isPage);
}

// ---- the site

const list = chapters();
const demos = list.flatMap(({ chapter, demos: of }) => of.map((demo) => Object.assign(demo, { chapter })));
const shown = pictures();
for (const [i, demo] of demos.entries()) {
  console.error(`lesson ${i + 1} of ${demos.length}: ${demo.name}`);
  demo.pictures = shown[demo.name].map((picture) => ({ ...picture, ...sizeOf(picture.file) }));
  demo.pictures.forEach((picture) => copy(picture.file));
  demo.presets = JSON.parse(run(program, [demo.name, '--knobs=json'])).presets;
  const inFolder = `demos/${demo.name}/${demo.name}.md`;
  demo.own = fs.existsSync(path.join(root, inFolder)) ? inFolder : `demos/${demo.name}.md`;
  demo.studies = studiesOf(demo.name);
  demo.sources = sourcesOf(demo.name).map((file) => ({
    file,
    html: run('highlight', ['-O', 'html', '-f', '--syntax=c++', path.join(root, file)]),
  }));
}
const beside = [];
for (const file of pagesBelow('docs').sort()) {
  const { title, html } = lesson(file), target = file.replace(/\.md$/, '.html'), depth = target.split('/').length - 1;
  write(target, page({ title, depth, main: html }));
  if (depth === 1) beside.push({ file: target, title }); // a study's page is its lesson's
}
// All of it in each language; a lesson that is not translated stands in English among that language's words.
const found = {}; // what each lesson is found by
for (const which of languages) {
  speak(which);
  for (const [i, demo] of demos.entries()) {
    const translation = demo.own.replace(/\.md$/, `.${which}.md`), isTranslated = which === 'en' || fs.existsSync(path.join(root, translation));
    demo.says = saysOf(demo.name);
    const spoken = { ...demo, isTranslated, ...lesson(which !== 'en' && isTranslated ? translation : demo.own) };
    write(`demos/${inLanguage(demo.name)}`, demoPage(spoken, demos[i - 1], demos[i + 1], module && `${moduleOf(demo.chapter)}.wasm`, list, process.env.MVGL_SITE));
    if (isTranslated) found[demo.name] = `${found[demo.name] ?? ''} ${wordsOf(spoken, demo.chapter, folded)}`.trim();
  }
  write(inLanguage('index'), startPage(list, beside, Boolean(module)));
}
speak('en');
write('site.css', text('web/site.css'));
write('icon.svg', text('web/icon.svg'));
// What the start page's search looks into is loaded when it is used.
const script = (file, ...parts) => write(file, shorter(parts.map((part) => `(() => {\n${part}\n})();\n`).join('')));
script('search.js', `globalThis.lessons = ${JSON.stringify(found)};\nglobalThis.folded = ${folded};`);
for (const which of languages) {
  speak(which);
  script(scriptIn(), scriptOf(which), text('web/site.js'), text('web/curve.js'));
}
if (module) {
  script('begin.js', text('web/begin.js'));
  write('live.js', shorter(text('web/live.js')));
  // What knobs that take a file may name, in lessons' commands, say
  for (const file of fs.readdirSync(path.join(root, 'assets'))) if (/\.(png|obj)$/.test(file)) copy(`assets/${file}`);
  const driving = list.map(({ chapter }) => fs.readFileSync(path.join(module, moduleOf(chapter), 'mvgl.js'), 'utf8'));
  if (new Set(driving).size > 1) fail(module, 'must have modules that one mvgl.js drives');
  for (const { chapter } of list) write(`${moduleOf(chapter)}.wasm`, fs.readFileSync(path.join(module, moduleOf(chapter), 'mvgl.wasm')));
}
console.log(`${path.join(folder, 'index.html')}: ${demos.length} lessons`);
