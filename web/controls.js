// Controls made of HTML, as the knobs of a demo describe them.
import { madeOf, number } from './matrix.js';
import { fromSlider, toSlider, typedNumber } from './settings.js';

export function tag(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith('on')) made.addEventListener(key.slice(2), value);
    else if (value !== false && value !== undefined) made.setAttribute(key, value === true ? '' : value);
  }
  made.append(...children);
  return made;
}

// A slider that moves by itself, there and back in eight seconds, while its button is pressed.
function player(slider, knob) {
  let from = 0, at = 0;
  const low = Number(slider.min), high = Number(slider.max), period = 8000;
  const button = tag('button', { type: 'button', class: 'play', 'aria-label': word('playKnob', { knob: knob.name }), 'aria-pressed': 'false', onclick: () => (from ? stop() : start()) }, '\u25b6');
  const say = () => {
    button.setAttribute('aria-pressed', from !== 0);
    button.textContent = from ? '\u2016' : '\u25b6';
  };
  function stop() {
    from = 0;
    say();
  }
  function start() {
    const now = performance.now();
    from = now - (period / 2) * ((Number(slider.value) - low) / (high - low));
    at = now;
    say();
    requestAnimationFrame(move);
  }
  function move(now) {
    if (!from) return;
    if (now - at > 250) from += now - at; // it was out of sight
    at = now;
    const part = ((now - from) / (period / 2)) % 2;
    slider.value = low + (high - low) * (part < 1 ? part : 2 - part);
    slider.dispatchEvent(new Event('input'));
    requestAnimationFrame(move);
  }
  slider.addEventListener('pointerdown', stop);
  return button;
}

// The widget of one knob: `element`, and `show(value)`, which sets it; `set(text)` is called for what is chosen. `help` is the id of what
// is said about it.
function widget(knob, kind, id, help, set, choose) {
  const described = { id, 'aria-describedby': help };
  if (kind.kind === 'switch') {
    const box = tag('input', { type: 'checkbox', ...described, onchange: () => set(box.checked ? 'on' : 'off') });
    return { element: box, show: (value) => (box.checked = value === 'on') };
  }
  if (kind.kind === 'choice') {
    const select = tag('select', { ...described, onchange: () => set(select.value) });
    for (const { word, meaning } of kind.options) select.append(tag('option', { value: word, title: meaning }, word));
    return { element: select, show: (value) => (select.value = value) };
  }
  // What is refused stays in the field, with its reason below it, until the field is left.
  let shown = '';
  const isNumber = kind.kind === 'number', keypad = isNumber && kind.low >= 0 ? 'decimal' : undefined; // a phone's has no minus
  const typed = tag('input', { type: 'text', ...described, inputmode: keypad, autocomplete: 'off', spellcheck: 'false', size: isNumber ? 7 : 24,
    onchange: () => set(isNumber ? typedNumber(typed.value) : typed.value), onblur: () => (typed.value = shown) });
  const showTyped = (value) => {
    shown = value;
    if (document.activeElement !== typed) typed.value = value;
  };
  if (kind.kind === 'file') {
    const chosen = tag('input', { type: 'file', accept: kind.accept, 'aria-label': word('chooseFile', { knob: knob.name }), onchange: () => chosen.files.length && choose(chosen.files[0]) });
    return { element: tag('span', { class: 'file' }, typed, chosen), show: showTyped };
  }
  if (!isNumber) return { element: typed, show: showTyped };
  // By whole numbers, where a knob has no others, and by whole degrees, where it turns far.
  const byOne = kind.whole || (knob.unit === 'deg' && !kind.logarithmic && Number.isInteger(kind.low) && kind.high - kind.low >= 60);
  const slider = tag('input', { type: 'range', min: byOne ? kind.low : 0, max: byOne ? kind.high : 1000, 'aria-label': knob.name, 'aria-describedby': help,
    oninput: () => set(byOne ? slider.value : fromSlider(Number(slider.value), kind)) });
  const show = (value) => {
    showTyped(value);
    slider.setAttribute('aria-valuetext', `${value} ${knob.unit}`.trim());
    // The slider that is held says itself where it is
    if (!slider.matches(':active')) slider.value = byOne ? Number(value) : toSlider(value, kind);
  };
  return { element: tag('span', { class: 'slider' }, slider, typed, knob.unit ? tag('span', { class: 'unit' }, knob.unit) : '', player(slider, knob)), show, typed };
}

// Three knobs of 0 .. 1 that make a colour, "to-red", "to-green" and "to-blue": the names of the two others, of the first one's.
function othersOfColor(name, widgets) {
  const all = ['red', 'green', 'blue'].map((one) => name.replace(/red$/, one));
  const isPart = (one) => widgets[one]?.kind === 'number' && widgets[one].low === 0 && widgets[one].high === 1;
  return /^(.*-)?red$/.test(name) && all.every(isPart) ? all : undefined;
}
// The browser's own choice of a colour, which sets all three.
function colorField(names, set) {
  const field = tag('input', { type: 'color', 'aria-label': word('chooseColor', { knobs: names.join(', ') }), title: word('chooseColor', { knobs: names.join(', ') }),
    oninput: () => names.forEach((name, i) => set(name, String(Number((parseInt(field.value.slice(1 + 2 * i, 3 + 2 * i), 16) / 255).toFixed(4))))) });
  return { field, show: (values) => (field.value = `#${names.map((name) => Math.round(255 * values[name]).toString(16).padStart(2, '0')).join('')}`) };
}

const foldedFrom = 3; // so many knobs that do nothing now are folded away

// All knobs, or those of the names in `only`: rows of label, widget, unit and buttons. `update(knobs)` shows their values and why one does
// nothing; those that do nothing stand folded below the others. `set` returns why a value is refused, or "", or a promise of that.
export function knobRows(description, { set, press, choose, only }) {
  const used = tag('div', { class: 'knobs' }), unused = tag('div', { class: 'knobs' }), count = tag('summary');
  const folded = tag('details', { class: 'unused', hidden: true }, count, unused);
  const rows = description.knobs.filter(({ name }) => !only || only.includes(name)).map((knob) => {
    const kind = description.widgets[knob.name], id = `knob-${knob.name}`;
    const wrong = tag('small', { class: 'wrong', role: 'alert' }), idle = tag('small', { class: 'idle' });
    const range = kind.kind === 'number' ? ` (${kind.low} .. ${kind.high}${knob.unit && ` ${knob.unit}`})` : '';
    const help = tag('span', { class: 'help', id: `help-${knob.name}` }, `${knob.help}${range}`);
    const tried = async (text) => {
      const why = await set(knob.name, text);
      wrong.textContent = why ?? '';
      typed?.setAttribute('aria-invalid', Boolean(why));
    };
    const { element, show, typed } = widget(knob, kind, id, help.id, tried, (file) => choose(knob.name, file));
    const buttons = (kind.buttons ?? []).map(({ label }) => tag('button', { type: 'button', 'aria-label': `${knob.name} ${label}`, onclick: () => press(knob.name, label) }, label));
    const names = othersOfColor(knob.name, description.widgets), color = names && colorField(names, set);
    const row = tag('div', { class: 'knob', title: help.textContent }, tag('label', { for: id }, knob.name), element, color?.field ?? '', ...buttons, idle, wrong, help);
    used.append(row);
    return { name: knob.name, row, show, color, idle, buttons };
  });
  // A row goes to where it belongs, in the order of all, but not while it is used.
  function put(index, box) {
    const { row } = rows[index];
    if (row.parentElement === box || row.contains(document.activeElement)) return;
    box.insertBefore(row, rows.slice(index + 1).find((later) => later.row.parentElement === box)?.row ?? null);
  }
  return {
    element: tag('div', {}, used, folded),
    haveButtons: rows.some(({ buttons }) => buttons.length),
    enable(widgets) {
      for (const { name, buttons } of rows) buttons.forEach((button, i) => (button.disabled = !widgets[name].buttons[i].enabled));
    },
    update(values, idleReasons) {
      const folds = rows.filter(({ name }) => idleReasons[name]).length >= foldedFrom;
      rows.forEach(({ name, row, show, color, idle }, i) => {
        show(values[name]);
        color?.show(values);
        const reason = idleReasons[name] ?? '';
        row.classList.toggle('is-idle', reason !== '');
        if (idle.textContent !== reason) idle.textContent = reason;
        put(i, folds && reason ? unused : used);
      });
      folded.hidden = !unused.childElementCount;
      count.textContent = word('unused', { count: unused.childElementCount });
    },
  };
}

// Buttons of the presets; the one that the knobs are at is pressed.
export function presetButtons(description, apply) {
  const buttons = description.presets.map((preset) => tag('button', { type: 'button', title: preset.lookFor, onclick: () => apply(preset) }, preset.name));
  const look = tag('p', { class: 'look', 'aria-live': 'polite' });
  return {
    element: tag('div', { class: 'presets' }, tag('div', { class: 'row', role: 'group', 'aria-label': word('presets') }, ...buttons), look),
    update(values) {
      const at = description.presets.findIndex((preset) => description.knobs.every((knob) => values[knob.name] === (preset.settings[knob.name] ?? knob.initial)));
      buttons.forEach((button, i) => button.setAttribute('aria-pressed', i === at));
      const words = at < 0 ? '' : description.presets[at].lookFor;
      if (look.textContent !== words) look.textContent = words;
    },
  };
}

export function readoutTable(description) {
  const rows = Object.entries(description.readouts ?? {}).map(([name, help]) => {
    const value = tag('td', { class: 'value' });
    return { name, value, row: tag('tr', { title: help }, tag('th', { scope: 'row' }, name), value) };
  });
  return {
    element: rows.length ? tag('table', { class: 'readouts' }, ...rows.map(({ row }) => row)) : '',
    update(readouts) {
      for (const { name, value } of rows) {
        const { value: measured, unit } = readouts[name];
        const words = measured === null ? '-' : `${number(measured)} ${unit}`.trim();
        if (value.textContent !== words) value.textContent = words;
      }
    },
  };
}

export function matrixTables() {
  const element = tag('details', { class: 'matrices' }, tag('summary', {}, word('matrices'))), box = tag('div');
  element.append(box);
  return {
    element,
    update(matrices) {
      element.hidden = !Object.keys(matrices).length;
      if (!element.open) return;
      box.replaceChildren(...Object.entries(matrices).map(([name, rows]) => {
        const { product, takes, entry } = madeOf(name, matrices);
        return tag('table', { tabindex: 0 }, tag('caption', { title: takes }, product || name),
          ...rows.map((row, i) => tag('tr', {}, ...row.map((value, j) => tag('td', { title: entry(i, j) }, number(value))))));
      }));
    },
  };
}
