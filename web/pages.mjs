// The pages around the lessons.
import path from 'node:path';
import { language, languages, speak, word } from './words.mjs';

const escaped = (words) => words.replace(/&/g, '&amp;').replace(/</g, '&lt;').replace(/>/g, '&gt;').replace(/"/g, '&quot;');
const plain = (html) => html.replace(/<[^>]*>/g, '');

// Where a page of that language is: NAME.html in English, NAME.is.html.
export const inLanguage = (name, which = language()) => `${name}${which === 'en' ? '' : `.${which}`}.html`;
// What every page runs.
export const scriptIn = () => (language() === 'en' ? 'site.js' : `site.${language()}.js`);
// That function's answer in another language.
export function spokenIn(which, say) {
  const before = language();
  speak(which);
  const said = say();
  speak(before);
  return said;
}

// A whole page, `depth` folders below the start page. `main` is HTML, `title` may hold HTML. `name`: it is there by that name in each
// language.
export function page({ title, depth, main, name, heading = title, nav = '', head = '', side = '', foot = '', module = '' }) {
  const up = '../'.repeat(depth), others = name ? languages.filter((one) => one !== language()) : [];
  const own = language() === 'en' ? '' : ` (${word('languageName')})`;
  const links = others.map((one) => `<a class="language" hreflang="${one}" lang="${one}" href="${inLanguage(name, one)}">${spokenIn(one, () => word('languageName'))}</a>`).join('');
  return `<!doctype html>
<html lang="${word('language')}">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>${plain(title)}${own}</title>
${module && `<link rel="preload" href="${up}${module}" as="fetch" crossorigin>\n<script src="${up}begin.js" data-module="${up}${module}"></script>\n`}<link rel="stylesheet" href="${up}site.css">
<link rel="icon" href="${up}icon.svg" type="image/svg+xml">
${others.map((one) => `<link rel="alternate" hreflang="${one}" href="${inLanguage(name, one)}">\n`).join('')}<script src="${up}${scriptIn()}" defer></script>
${head}</head>
<body>
<a class="skip" href="#content">${word('toContent')}</a>
<header><nav aria-label="${word('lessons')}"><a href="${up}${inLanguage('index')}">${word('allLessons')}</a>${nav}${links}</nav></header>
<main id="content">
<h1>${heading}</h1>
${main}</main>
${foot}${side}</body>
</html>
`;
}

// ---- a lesson

// What a demo says in English, in this page's language.
export const said = (demo, words) => demo.says[words] ?? words;

// The first picture large, and below it all of them: a click shows one with the line that makes it. Where demos are alive, the
// picture stands until the demo draws its own in its place.
function pictures(demo, alive) {
  const here = (picture) => path.posix.relative('demos', picture.file);
  const [first] = demo.pictures;
  const lookFor = (picture) => {
    const name = picture.command.match(/--preset (\S+)/)?.[1];
    const flags = picture.command.split(' ').length;
    const preset = name ? demo.presets.find((one) => one.name === name) : flags === 2 ? demo.presets[0] : undefined;
    return said(demo, preset?.lookFor ?? '');
  };
  const small = demo.pictures.map(
    (picture, i) => `<li><a href="${here(picture)}"${i === 0 ? ' aria-current="true"' : ''} data-name="${path.posix.basename(picture.file, '.png')}" data-command="${escaped(picture.command)}" data-look="${escaped(lookFor(picture))}"
><img src="${here(picture)}" width="${picture.width}" height="${picture.height}" loading="lazy" alt="${escaped(picture.command)}"></a></li>`,
  );
  const shown = `<img class="shown" src="${here(first)}" width="${first.width}" height="${first.height}" alt="${escaped(said(demo, demo.sentence))}">`;
  const look = `<p class="look" aria-live="polite">${escaped(lookFor(first))}</p>`;
  // What the demo says in English is said by the page in its language.
  const says = Object.keys(demo.says).length ? `<script type="application/json" class="says">${JSON.stringify(demo.says).replace(/</g, '\\u003c')}</script>\n` : '';
  const view = alive
    ? `<div class="live${first.width > 640 ? ' is-wide' : ''}" data-demo="${demo.name}">
<div class="view">${shown}</div>
<div class="panel">${look}<noscript><p>${word('needsScripts')}</p></noscript></div>
</div>
${says}`
    : `${shown}\n${look}`;
  return `<section class="stage" aria-label="${word('pictures')}">
${view}
<pre class="command"><code>${escaped(first.command)}</code></pre>
${alive ? '<script src="../live.js"></script>\n' : ''}<ul class="thumbs">
${small.join('\n')}
</ul>
</section>
`;
}

// The committed studies: the SVG of each machine, which a script makes a curve to ask.
function curve(demo) {
  if (demo.studies.length === 0) return '';
  const { compared, reference } = demo.studies[0].facts;
  const data = JSON.stringify({ demo: demo.name, settings: demo.studies.map((study) => study.settings) }).replace(/</g, '\\u003c');
  const figures = demo.studies.map(({ machine, svg }) => `<figure class="drawn"${language() === 'en' ? '' : ' lang="en"'} data-machine="${machine}">\n${svg}</figure>`);
  return `<section class="curve">
<h2 id="error-against-run-time">${word('study')}</h2>
<p>${word('studyWhat', { quantity: escaped(compared), reference: escaped(reference), table: `../docs/errors-and-times/${demo.name}.html` })}</p>
<p class="choices"></p>
${figures.join('\n')}
<p class="told" role="status"></p>
<pre class="command"><code>./run ${demo.name} --study out</code></pre>
<script type="application/json">${data}</script>
</section>
`;
}

const sources = (demo) => `<section class="sources">
<h2 id="the-code">${word('code')}</h2>
${demo.sources
  .map(({ file, html }) => `<details><summary><code>${file}</code></summary>\n<pre class="code" tabindex="0"><code>${html}</code></pre>\n</details>`)
  .join('\n')}
</section>
`;

// All lessons, beside the page where the window is wide enough.
const sideList = (chapters, here) => `<nav class="side" aria-label="${word('allLessons')}">
${chapters.map(({ chapter, demos }) => `<h2${english()}>${escaped(chapter)}</h2>
<ul>
${demos.map(({ name }) => `<li><a href="${inLanguage(name)}"${name === here ? ' aria-current="page"' : ''}>${name}</a></li>`).join('\n')}
</ul>`).join('\n')}
</nav>
`;

// The lesson's sections.
function contents(html) {
  const headings = [...html.matchAll(/<h2 id="([^"]*)">(.*?)<\/h2>/g)].map(([, id, words]) => `<li><a href="#${id}">${plain(words)}</a></li>`);
  return headings.length < 2 ? '' : `<nav class="contents" aria-label="${word('contents')}"><ul>\n${headings.join('\n')}\n</ul></nav>\n`;
}

// Each as an element, which the browser lays out when it comes near (site.css).
const inSections = (html) => html.split(/(?=<h2 )/).map((part) => (part.startsWith('<h2 ') ? `<section>\n${part}</section>\n` : part)).join('');

// What stands in English on a page of another language says so.
const english = () => (language() === 'en' ? '' : ' lang="en"');

// `module`: the file of the one that the demo is alive by; '' or undefined: it is not. `address`: where the site will be, 'https://.../', or ''.
export function demoPage(demo, before, after, module = '', chapters, address = '') {
  const sentence = said(demo, demo.sentence);
  const to = (other, key, rel) => (other ? `<a rel="${rel}" href="${inLanguage(other.name)}">${word(key, { demo: other.name })}</a>` : '');
  const opening = demo.pictures[0].file;
  // The lesson's own first picture is the one above it.
  const lesson = demo.html.replace(new RegExp(`<p><img src="\\.\\./${opening}"[^>]*></p>\\s*`), '');
  return page({
    title: demo.title,
    name: demo.name,
    depth: 1,
    module,
    nav: to(before, 'before', 'prev') + to(after, 'next', 'next'),
    // A link in a letter or a course's page shows what it leads to.
    head: `<meta name="description" content="${escaped(sentence)}">
<meta property="og:title" content="${escaped(plain(demo.title))}">
<meta property="og:description" content="${escaped(sentence)}">
<meta property="og:image" content="${address || '../'}${opening}">
${address && `<meta property="og:url" content="${address}demos/${inLanguage(demo.name)}">\n`}`,
    side: sideList(chapters, demo.name),
    foot: `<footer><nav aria-label="${word('onwards')}">${to(before, 'before', 'prev')}${to(after, 'next', 'next')}</nav></footer>\n`,
    main: `<p class="sentence"${sentence === demo.sentence ? english() : ''}>${escaped(sentence)}</p>\n${pictures(demo, Boolean(module))}${contents(lesson)}${demo.isTranslated ? '' : `<p class="notes">${word('untranslated')}</p>\n`}<article${demo.isTranslated ? '' : english()}>\n${inSections(lesson)}</article>\n${curve(demo)}${sources(demo)}`,
  });
}

// ---- the start page

// What a lesson is found by: each word of its own, once, as folded() of fold.mjs writes it.
export const wordsOf = (demo, chapter, folded) => {
  const presets = demo.presets.map((preset) => `${preset.name} ${preset.lookFor}`).join(' ');
  const text = folded(`${demo.name} ${demo.sentence} ${chapter} ${plain(demo.title)} ${presets} ${plain(demo.html)}`);
  return [...new Set(text.split(/[^\p{L}\d-]+/u).filter((word) => word.length > 2))].sort().join(' ');
};

function card(demo) {
  const [picture] = demo.pictures;
  return `<li class="card" data-name="${demo.name}">
<a href="demos/${inLanguage(demo.name)}"><img src="${picture.file}" width="${picture.width}" height="${picture.height}" loading="lazy" alt="">
<strong>${demo.name}</strong></a>
<p${said(demo, demo.sentence) === demo.sentence ? english() : ''}>${escaped(said(demo, demo.sentence))}</p></li>`;
}

// `measured`: the pages that stand beside the lessons, { file, title }. `alive`: demos run in their pages.
export function startPage(chapters, measured, alive) {
  const count = chapters.reduce((sum, { demos }) => sum + demos.length, 0);
  const sections = chapters.map(
    ({ chapter, demos }) => `<section class="chapter">
<h2${english()}>${escaped(chapter)}</h2>
<ul class="cards">
${demos.map(card).join('\n')}
</ul>
</section>`,
  );
  return page({
    title: word('title'),
    heading: word('heading'),
    name: 'index',
    depth: 0,
    main: `<p>${word('opening', { count })} ${alive ? word('openingAlive') : `${word('openingStill')} <code>./run cube-cull</code>`}</p>
<p class="search" hidden><label for="search">${word('find')}</label> <input id="search" type="search" autocomplete="off" placeholder="${word('findExamples')}">
<span role="status" id="found"></span></p>
${sections.join('\n')}
<section><h2>${word('beside')}</h2>
<ul>
${measured.map(({ file, title }) => `<li><a href="${file}"${english()}>${title}</a></li>`).join('\n')}
</ul></section>
`,
  });
}
