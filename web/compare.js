// A knob's value beside another one: a second canvas over the first, with a line between the two that is moved.
import { tag } from './controls.js';
import { fetched, provide } from './pictures.js';

// `what` describes the demo, `open(canvas)` makes a module for a second one, `changed()` asks for a picture, `view` holds the first.
export function comparison(name, what, view, open, changed) {
  const knob = tag('select', { 'aria-label': word('compareKnob'), onchange: () => choose() }, tag('option', { value: '' }, word('compareNothing')));
  for (const { name: one } of what.knobs) knob.append(tag('option', {}, one));
  const with_ = tag('span', { class: 'row' });
  const line = tag('input', { type: 'range', class: 'divider', min: 0, max: 1000, value: 500, 'aria-label': word('compareLine'), oninput: divide, hidden: true });
  const labels = [tag('span', { class: 'label is-a', hidden: true }), tag('span', { class: 'label is-b', hidden: true })];
  view.append(line, ...labels);
  let canvas, second, other = '', begun = '';

  // The knob is chosen: a field for its other value, which begins with `given`, else with the far end or the first choice.
  async function choose(given) {
    const kind = what.widgets[knob.value];
    with_.replaceChildren();
    other = '';
    if (kind) {
      const words = kind.options?.map(({ word }) => word) ?? (kind.kind === 'switch' ? ['on', 'off'] : undefined);
      const attributes = { 'aria-label': word('compareOther'), onchange: () => ((other = field.value), ready()) };
      const field = words ? tag('select', attributes, ...words.map((word) => tag('option', {}, word))) : tag('input', { type: 'text', size: 8, ...attributes });
      field.value = given ?? words?.[0] ?? kind.high ?? what.knobs.find((one) => one.name === knob.value).initial;
      other = field.value;
      with_.append(`${word('compareWith')} `, field);
    }
    await ready();
  }
  async function ready() {
    await fetched(what, { [knob.value]: other });
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
    element: tag('details', { class: 'compare' }, tag('summary', {}, word('compare')), tag('div', { class: 'row' }, knob, with_)),
    second: () => second,
    on: () => knob.value !== '' && Boolean(second),
    compared: () => ({ knob: knob.value, other: knob.value ? other : '' }),
    // That knob with that value, as --compare has it; nothing: no comparison.
    async compare(wanted) {
      knob.value = wanted?.knob ?? '';
      if (wanted) knob.closest('details').open = true;
      await choose(wanted?.other);
    },
    // Draws the same settings with the other value. What is said where that makes no picture; else "".
    draw(values, frame, size) {
      const settings = { ...values, [knob.value]: other }, key = JSON.stringify(settings);
      // Where a frame follows from the one before, it is as if the value had been that one all the time.
      const anew = !begun || (what.remembers && key !== begun);
      let refused = '';
      provide(second, what, settings);
      if (anew) refused = second.says('Open', name, settings, frame, true);
      else if (key !== begun) refused = second.says('SetAll', settings);
      begun = refused ? '' : key;
      if (!refused) {
        if (!anew) second.does('GoTo', frame);
        second.does('Draw', size.width, size.height, false);
        refused = second.tells('State').error;
      }
      labels[0].textContent = `${knob.value} ${values[knob.value]}`;
      labels[1].textContent = `${knob.value} ${other}`;
      return refused && word('compareRefused', { knob: knob.value, value: other, sentence: refused });
    },
    // Whether a picture made in passes has more to come.
    more: (size) => second.does('IsDue', size.width, size.height) && second.does('Draw', size.width, size.height, false),
  };
}
