// The shaders of a demo, edited beside its picture: compiled as they are typed. A mistake is marked at its line, and the last good
// program stays.
import { tag } from './controls.js';

const quiet = 300; // milliseconds without a key before what is typed is compiled

// `files`: [{ name, text }], `write(name, text)` returns the mistakes, a line each: "shaders/x.frag:7: message".
export function shaderEditor(files, write) {
  if (!files.length) return '';
  const now = new Map(files.map(({ name, text }) => [name, text]));
  const choice = tag('select', { 'aria-label': word('shaderFile'), onchange: choose });
  for (const { name } of files) choice.append(tag('option', {}, name));
  const numbers = tag('pre', { class: 'numbers', 'aria-hidden': 'true' });
  const text = tag('textarea', { 'aria-label': word('shaderText'), spellcheck: 'false', autocapitalize: 'off', wrap: 'off', rows: 8, oninput: typed, onscroll: () => (numbers.scrollTop = text.scrollTop) });
  const mistakes = tag('ul', { class: 'mistakes', role: 'status' });
  const back = tag('button', { type: 'button', onclick: putBack }, word('putBack'));
  let waiting = 0, typedInto = '', told = '';

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
    back.disabled = files.every(({ name, text: first }) => now.get(name) === first);
  }
  function goTo(line) {
    const start = text.value.split('\n').slice(0, line - 1).join('\n').length + (line > 1 ? 1 : 0);
    text.focus();
    text.setSelectionRange(start, text.value.indexOf('\n', start) < 0 ? text.value.length : text.value.indexOf('\n', start));
  }
  show();
  return tag('details', { class: 'shaders' }, tag('summary', {}, word('shaders')), tag('div', { class: 'row' }, choice, back), tag('div', { class: 'editor' }, numbers, text), mistakes);
}
