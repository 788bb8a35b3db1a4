// Controls made of HTML, as the knobs of a demo describe them.
import { fromSlider, toSlider } from './settings.js';

export function tag(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith('on')) made.addEventListener(key.slice(2), value);
    else if (value !== false && value !== undefined) made.setAttribute(key, value === true ? '' : value);
  }
  made.append(...children);
  return made;
}

// The widget of one knob: `element`, and `show(value)`, which sets it; `set(text)` is called for what is chosen.
function widget(knob, kind, id, set, choose) {
  if (kind.kind === 'switch') {
    const box = tag('input', { type: 'checkbox', id, onchange: () => set(box.checked ? 'on' : 'off') });
    return { element: box, show: (value) => (box.checked = value === 'on') };
  }
  if (kind.kind === 'choice') {
    const select = tag('select', { id, onchange: () => set(select.value) });
    for (const { word, meaning } of kind.options) select.append(tag('option', { value: word, title: meaning }, word));
    return { element: select, show: (value) => (select.value = value) };
  }
  const typed = tag('input', { type: 'text', id, inputmode: kind.kind === 'number' ? 'decimal' : undefined, autocomplete: 'off', spellcheck: 'false', size: kind.kind === 'number' ? 7 : 24, onchange: () => set(typed.value) });
  if (kind.kind === 'file') {
    const chosen = tag('input', { type: 'file', accept: kind.accept, 'aria-label': word('chooseFile', { knob: knob.name }), onchange: () => chosen.files.length && choose(chosen.files[0]) });
    return { element: tag('span', { class: 'file' }, typed, chosen), show: (value) => document.activeElement !== typed && (typed.value = value) };
  }
  if (kind.kind !== 'number') return { element: typed, show: (value) => document.activeElement !== typed && (typed.value = value) };
  const slider = tag('input', { type: 'range', min: 0, max: kind.whole ? kind.high - kind.low : 1000, 'aria-label': word('slider', { knob: knob.name }), oninput: () => set(kind.whole ? String(kind.low + Number(slider.value)) : fromSlider(Number(slider.value), kind)) });
  const show = (value) => {
    if (document.activeElement !== typed) typed.value = value;
    // The slider that is held says itself where it is
    if (!slider.matches(':active')) slider.value = kind.whole ? Number(value) - kind.low : toSlider(value, kind);
  };
  return { element: tag('span', { class: 'slider' }, slider, typed, tag('span', { class: 'unit' }, knob.unit)), show };
}

// All knobs: rows of label, widget, unit and buttons; `update(knobs)` shows their values and why one does nothing.
export function knobRows(description, { set, press, choose }) {
  const rows = description.knobs.map((knob) => {
    const kind = description.widgets[knob.name], id = `knob-${knob.name}`;
    const { element, show } = widget(knob, kind, id, (text) => set(knob.name, text), (file) => choose(knob.name, file));
    const idle = tag('small', { class: 'idle' });
    const buttons = (kind.buttons ?? []).map(({ label }) => tag('button', { type: 'button', 'aria-label': `${knob.name} ${label}`, onclick: () => press(knob.name, label) }, label));
    const row = tag('div', { class: 'knob', title: knob.help }, tag('label', { for: id }, knob.name), element, ...buttons, idle);
    return { name: knob.name, row, show, idle, buttons };
  });
  return {
    element: tag('div', { class: 'knobs' }, ...rows.map(({ row }) => row)),
    haveButtons: rows.some(({ buttons }) => buttons.length),
    enable(widgets) {
      for (const { name, buttons } of rows) buttons.forEach((button, i) => (button.disabled = !widgets[name].buttons[i].enabled));
    },
    update(values, idleReasons) {
      for (const { name, row, show, idle } of rows) {
        show(values[name]);
        const reason = idleReasons[name] ?? '';
        row.classList.toggle('is-idle', reason !== '');
        if (idle.textContent !== reason) idle.textContent = reason;
      }
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

const number = (value) => (value === null ? '-' : String(Number(value.toPrecision(6))));

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
      box.replaceChildren(...Object.entries(matrices).map(([name, rows]) =>
        tag('table', {}, tag('caption', {}, name), ...rows.map((row) => tag('tr', {}, ...row.map((value) => tag('td', {}, number(value))))))));
    },
  };
}
