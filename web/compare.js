// A knob's value beside another one: a second canvas over the first, with a line between the two that is moved.
import { tag } from './controls.js';

// `what` describes the demo, `open(canvas)` makes a module for a second one, `changed()` asks for a picture, `view` holds the first.
export function comparison(name, what, view, open, changed) {
  const knob = tag('select', { 'aria-label': 'knob to compare', onchange: choose }, tag('option', { value: '' }, 'nothing'));
  for (const { name: one } of what.knobs) knob.append(tag('option', {}, one));
  const with_ = tag('span', { class: 'row' });
  const line = tag('input', { type: 'range', class: 'divider', min: 0, max: 1000, value: 500, 'aria-label': 'line between the two pictures', oninput: divide, hidden: true });
  const labels = [tag('span', { class: 'label is-a', hidden: true }), tag('span', { class: 'label is-b', hidden: true })];
  view.append(line, ...labels);
  let canvas, second, other = '', begun = '';

  async function choose() {
    const kind = what.widgets[knob.value];
    with_.replaceChildren();
    if (kind) {
      const set = (event) => choseOther(event.target.value);
      const known = what.knobs.find((one) => one.name === knob.value);
      const field = kind.kind === 'choice' || kind.kind === 'switch'
        ? tag('select', { 'aria-label': 'its other value', onchange: set }, ...(kind.options?.map(({ word }) => word) ?? ['on', 'off']).map((word) => tag('option', {}, word)))
        : tag('input', { type: 'text', 'aria-label': 'its other value', size: 8, onchange: set, value: kind.kind === 'number' ? kind.high : known.initial });
      with_.append('with ', field);
      other = field.value;
    }
    await show();
  }
  async function choseOther(text) {
    other = text;
    await show();
  }
  async function show() {
    const on = knob.value !== '';
    if (on && !second) {
      canvas = tag('canvas', { class: 'second', 'aria-hidden': 'true' });
      view.insertBefore(canvas, line);
      second = await open(canvas);
    }
    if (canvas) canvas.hidden = !on;
    for (const part of [line, ...labels]) part.hidden = !on;
    begun = '';
    divide();
    changed();
  }
  function divide() {
    if (canvas) canvas.style.clipPath = `inset(0 0 0 ${line.value / 10}%)`;
    view.style.setProperty('--at', `${line.value / 10}%`);
  }

  return {
    element: tag('details', { class: 'compare' }, tag('summary', {}, 'Compare'), tag('div', { class: 'row' }, knob, with_)),
    on: () => knob.value !== '' && Boolean(second),
    compared: () => ({ knob: knob.value, other: knob.value ? other : '' }),
    async compare(wanted) {
      knob.value = wanted?.knob ?? '';
      await choose();
      if (!wanted) return;
      other = wanted.other;
      const field = with_.querySelector('select, input');
      if (field) field.value = other;
      field?.closest('details').setAttribute('open', '');
      await show();
    },
    // Draws the same settings with the other value; what is said of that.
    draw(values, frame, size) {
      const settings = { ...values, [knob.value]: other }, key = JSON.stringify(settings);
      // Where a frame follows from the one before, it is as if the value had been that one all the time.
      if (!begun || (what.remembers && key !== begun)) {
        const refused = second.says('Open', name, key, frame, true);
        if (refused) return (begun = ''), refused;
      } else {
        const refused = key === begun ? '' : second.says('SetAll', key);
        if (refused) return refused;
        second.does('GoTo', frame);
      }
      begun = key;
      second.does('Draw', size.width, size.height, false);
      labels[0].textContent = `${knob.value} ${values[knob.value]}`;
      labels[1].textContent = `${knob.value} ${other}`;
      return second.tells('State').error;
    },
    // Whether a picture made in passes has more to come.
    more: (size) => second.does('IsDue', size.width, size.height) && second.does('Draw', size.width, size.height, false),
  };
}
