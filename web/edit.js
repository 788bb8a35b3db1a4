// The shaders of a demo, edited beside its picture: compiled as they are typed. A mistake is marked at its line, and the last good
// program stays.
import { tag } from './controls.js';

const quiet = 300; // milliseconds without a key before what is typed is compiled

// The line of a loop that surely has no end, or undefined: such a shader would hold all the browser's pictures.
export function endless(text) {
  const plain = text.replace(/\/\*[^]*?\*\/|\/\/.*/g, (one) => one.replace(/[^\n]/g, ' '));
  const end = (from, open, close) => {
    let depth = 0, at = from;
    do depth += (plain[at] === open) - (plain[at] === close); while (depth && ++at < plain.length);
    return at;
  };
  for (const { 0: head, 1: kind, index } of plain.matchAll(/\b(for|while)\s*\(/g)) {
    if (kind === 'while' && /\}\s*$/.test(plain.slice(0, index)) && /^\s*;/.test(plain.slice(end(index + head.length - 1, '(', ')') + 1))) continue; // the end of a do
    const from = index + head.length, to = end(from - 1, '(', ')'), inside = plain.slice(from, to);
    const [start] = plain.slice(to + 1).match(/^\s*/), at = to + 1 + start.length;
    const body = plain.slice(at, plain[at] === '{' ? end(at, '{', '}') : plain.indexOf(';', at) + 1);
    if (/\b(?:break|return|discard)\b/.test(body)) continue;
    const [, goesOn = '', step = ''] = kind === 'for' ? inside.split(';') : ['', inside];
    const names = [...goesOn.matchAll(/[A-Za-z_]\w*/g)].map(([name]) => name).filter((name) => name !== 'true');
    const isMoved = (name) => new RegExp(`\\b${name}\\b\\s*(?:\\.\\w+\\s*)?(?:\\+\\+|--|[-+*/%&|^]?=(?!=)|<<=|>>=)|(?:\\+\\+|--)\\s*${name}\\b|\\w\\s*\\([^;]*\\b${name}\\b`).test(`${goesOn};${step};${body}`);
    if (!names.some(isMoved) && !/\w\s*\(/.test(goesOn)) return plain.slice(0, index).split('\n').length;
  }
  return undefined;
}

// `files`: [{ name, text }], `write(name, text)` returns the mistakes, a line each: "shaders/x.frag:7: message"; `inUse()` are the names
// of the files that the picture is drawn with. What comes back: `element`; `changed()`, the files that are edited, [name, text] each; and
// `apply({ name: text })`, which edits them.
export function shaderEditor(files, write, inUse) {
  if (!files.length) return { element: '', changed: () => [], apply() {} };
  const now = new Map(files.map(({ name, text }) => [name, text]));
  const choice = tag('select', { 'aria-label': word('shaderFile'), onchange: choose });
  for (const { name } of files) choice.append(tag('option', {}, name));
  const numbers = tag('pre', { class: 'numbers', 'aria-hidden': 'true' });
  const text = tag('textarea', { 'aria-label': word('shaderText'), spellcheck: 'false', autocapitalize: 'off', wrap: 'off', rows: 8, oninput: typed, onscroll: () => (numbers.scrollTop = text.scrollTop) });
  const unused = tag('p', { class: 'notes' });
  const mistakes = tag('ul', { class: 'mistakes' });
  const back = tag('button', { type: 'button', onclick: putBack }, word('putBack'));
  let waiting = 0, typedInto = '', told = '';

  // The file that colours the picture is the first to be seen, and one that is not used says so.
  function open() {
    const used = inUse();
    choice.value = files.map(({ name }) => name).filter((name) => used.includes(name)).find((name) => name.endsWith('.frag')) ?? files[0].name;
    show();
  }
  function show() {
    text.value = now.get(choice.value);
    text.rows = Math.min(24, text.value.split('\n').length + 1);
    tell();
  }
  // What was typed is compiled before another file is shown.
  function choose() {
    if (waiting) compile();
    show();
  }
  function typed() {
    typedInto = choice.value;
    now.set(typedInto, text.value);
    number();
    clearTimeout(waiting);
    waiting = setTimeout(compile, quiet);
  }
  const changed = () => files.filter(({ name, text: first }) => now.get(name) !== first).map(({ name }) => [name, now.get(name)]);
  function rest() {
    clearTimeout(waiting);
    waiting = 0;
  }
  function compile() {
    rest();
    told = write(typedInto, now.get(typedInto));
    tell();
  }
  function putBack() {
    rest();
    for (const { name, text: first } of files) {
      if (now.get(name) === first) continue;
      now.set(name, first);
      told = write(name, first);
    }
    show();
  }
  function number(wrong = new Set()) {
    const lines = text.value.split('\n').length;
    numbers.replaceChildren(...Array.from({ length: lines }, (none, i) => tag('span', { class: wrong.has(i + 1) ? 'is-wrong' : '' }, `${i + 1}\n`)));
    numbers.scrollTop = text.scrollTop;
  }
  // What the compiler says, each mistake a button that leads to its line.
  function tell() {
    const lines = told.split('\n').filter(Boolean), wrong = new Set();
    mistakes.replaceChildren(...lines.map((line) => {
      const [, file, at] = line.match(/(?:shaders\/)?([\w./-]+):(\d+):/) ?? [];
      if (file !== choice.value) return tag('li', {}, line);
      wrong.add(Number(at));
      return tag('li', {}, tag('button', { type: 'button', onclick: () => goTo(Number(at)) }, line));
    }));
    number(wrong);
    back.disabled = !changed().length;
    unused.textContent = inUse().includes(choice.value) ? '' : word('shaderUnused');
  }
  function goTo(line) {
    const start = text.value.split('\n').slice(0, line - 1).join('\n').length + (line > 1 ? 1 : 0);
    text.focus();
    text.setSelectionRange(start, text.value.indexOf('\n', start) < 0 ? text.value.length : text.value.indexOf('\n', start));
  }
  const element = tag('details', { class: 'shaders' }, tag('summary', {}, word('shaders')), tag('div', { class: 'row' }, choice, back), unused, tag('div', { class: 'editor' }, numbers, text), tag('div', { role: 'status' }, mistakes));
  element.addEventListener('toggle', () => element.open && back.disabled && open());
  return {
    element,
    changed,
    apply(edits) {
      for (const [name, edited] of Object.entries(edits)) {
        if (!now.has(name)) continue;
        now.set(name, edited);
        told = write(name, edited);
      }
      show();
    },
  };
}
