// What a page does beyond showing itself. Without scripts all is there, too: pictures are links, answers are folded.
'use strict';

// ---- the start page: lessons whose words hold all that is typed

const search = document.querySelector('#search');
if (search) {
  const cards = [...document.querySelectorAll('.card')];
  // The words of all lessons come when somebody searches. (As a script: from a disk browsers fetch nothing.)
  let loading;
  const load = () => (loading ??= new Promise((loaded) => document.head.append(Object.assign(document.createElement('script'), { src: 'search.js', onload: loaded }))));
  const find = async () => {
    await load();
    // What lessons call by another name, as one or more words
    const synonyms = new Map(word('synonyms').split('; ').map((line) => line.split(' = ').map(folded)));
    const asked = folded(search.value).trim();
    const wanted = (synonyms.get(asked) ?? asked).split(/\s+/).filter(Boolean).map((one) => [one, synonyms.get(one)].filter(Boolean));
    let count = 0;
    for (const card of cards) {
      card.hidden = !wanted.every((names) => names.some((one) => lessons[card.dataset.name].includes(one)));
      count += card.hidden ? 0 : 1;
    }
    for (const chapter of document.querySelectorAll('.chapter')) chapter.hidden = !chapter.querySelector('.card:not([hidden])');
    document.querySelector('#found').textContent = !wanted.length ? '' : count ? word('found', { count, all: cards.length }) : word('foundNone');
    history.replaceState(null, '', wanted.length ? `#find=${encodeURIComponent(search.value)}` : location.pathname + location.search);
  };
  search.closest('p').hidden = false;
  search.addEventListener('focus', load);
  search.addEventListener('input', find);
  const linked = location.hash.match(/^#find=(.*)/);
  if (linked) {
    search.value = new URLSearchParams(location.hash.slice(1)).get('find'); // a link that was cut may end in %
    find();
  }
}

// ---- a lesson: its pictures, of which the address names the one that is shown

function show(link) {
  const stage = link.closest('.stage'), shown = stage.querySelector('.shown'), small = link.querySelector('img');
  shown.src = link.href;
  shown.setAttribute('width', small.getAttribute('width'));
  shown.setAttribute('height', small.getAttribute('height'));
  shown.alt = word('pictureOf', { command: link.dataset.command });
  const look = stage.querySelector('.look');
  if (look) look.textContent = link.dataset.look;
  stage.querySelector('.command code').textContent = link.dataset.command;
  for (const other of stage.querySelectorAll('[aria-current]')) other.removeAttribute('aria-current');
  link.setAttribute('aria-current', 'true');
}
const pictures = [...document.querySelectorAll('.thumbs a')];
function showLinked() {
  const name = location.hash.match(/^#picture=(.*)/)?.[1];
  const link = pictures.find((one) => one.dataset.name === name);
  if (link) show(link);
}
for (const link of pictures) {
  link.addEventListener('click', (event) => {
    if (event.ctrlKey || event.metaKey || event.shiftKey) return; // a tab of its own, as of any link
    event.preventDefault();
    history.replaceState(null, '', `#picture=${link.dataset.name}`);
    show(link);
  });
}
addEventListener('hashchange', showLinked);
showLinked();

// ---- another language shows the same

for (const link of document.querySelectorAll('a.language')) link.addEventListener('click', () => (link.hash = location.hash));

// ---- commands to copy

for (const block of document.querySelectorAll('pre:not(.code)')) {
  if (!block.textContent.includes('./run') || !navigator.clipboard) continue;
  const button = document.createElement('button');
  button.type = 'button';
  button.textContent = word('copy');
  button.addEventListener('click', async () => {
    try {
      const lines = [...block.querySelectorAll('.line')].map((line) => line.textContent).join('') || block.querySelector('code').textContent;
      await navigator.clipboard.writeText(lines.trim());
      button.textContent = word('copied');
    } catch {
      button.textContent = word('copyForbidden');
    }
    setTimeout(() => (button.textContent = word('copy')), 2000);
  });
  block.append(button);
}

// ---- on paper answers are open

let closed = [];
addEventListener('beforeprint', () => {
  closed = [...document.querySelectorAll('article details:not([open])')];
  for (const answer of closed) answer.open = true;
});
addEventListener('afterprint', () => {
  for (const answer of closed) answer.open = false;
});
