// A knob's value beside another one: a second canvas over the first, with a line between the two that is moved.
import { tag } from './controls.js';
import { fetched, provide } from './pictures.js';

// `what` describes the demo, `open(canvas)` makes a module for a second one, `changed()` asks for a picture, `view` holds the first, and
// `edits()` are the shaders that are edited, [name, text] each.
export function comparison(name, what, view, open, changed, edits) {
  const knob = tag('select', { 'aria-label': word('compareKnob'), onchange: () => choose() }, tag('option', { value: '' }, word('compareNothing')));
  for (const { name: one } of what.knobs) knob.append(tag('option', {}, one));
  const with_ = tag('span', { class: 'row' });
  const grip = tag('div', { class: 'grip', hidden: true, 'aria-hidden': 'true' });
  const line = tag('input', { type: 'range', class: 'divider', min: 0, max: 1000, value: 500, 'aria-label': word('compareLine'), oninput: divide, hidden: true });
  const labels = [tag('span', { class: 'label is-a', hidden: true }), tag('span', { class: 'label is-b', hidden: true })];
  view.append(grip, line, ...labels);
  grip.addEventListener('pointerdown', (event) => grip.setPointerCapture(event.pointerId));
  grip.addEventListener('pointermove', (event) => {
    if (!grip.hasPointerCapture(event.pointerId)) return;
    const { left, width } = view.getBoundingClientRect();
    line.value = (1000 * (event.clientX - left)) / width;
    divide();
  });
  let canvas, second, other = '', begun = '', placed = false;

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
      second.says('Open', name, {}, 1, true);
      for (const [file, text] of edits()) second.says('WriteShader', file, text);
    }
    if (canvas) canvas.hidden = !on;
    for (const part of [grip, line, ...labels]) part.hidden = !on;
    placed = false;
    begun = '';
    divide();
    changed();
  }
  function divide() {
    if (canvas) canvas.style.clipPath = `inset(0 0 0 ${line.value / 10}%)`;
    view.style.setProperty('--at', `${line.value / 10}%`);
  }

  // The line begins where the two pictures differ: half of what does is on either side.
  function place(first, size) {
    placed = true;
    const [one, two] = [first, second].map((demo) => demo.pixels(size.width * size.height)), columns = new Array(size.width).fill(0);
    for (let i = 0; i < one.length; i += 4) if (one[i] !== two[i] || one[i + 1] !== two[i + 1] || one[i + 2] !== two[i + 2]) ++columns[(i / 4) % size.width];
    const all = columns.reduce((sum, count) => sum + count, 0);
    let past = 0;
    const at = all ? columns.findIndex((count) => 2 * (past += count) >= all) + 0.5 : size.width / 2;
    line.value = (1000 * at) / size.width;
    divide();
  }

  return {
    element: tag('details', { class: 'compare' }, tag('summary', {}, word('compare')), tag('div', { class: 'row' }, knob, with_)),
    second: () => second,
    canvas: () => canvas,
    at: () => line.value / 1000,
    labels: () => labels.map((label) => label.textContent),
    writeShader: (file, text) => second?.says('WriteShader', file, text),
    touch: () => (begun = ''),
    on: () => knob.value !== '' && Boolean(second),
    compared: () => ({ knob: knob.value, other: knob.value ? other : '' }),
    // That knob with that value, as --compare has it; nothing: no comparison.
    async compare(wanted) {
      knob.value = wanted?.knob ?? '';
      if (wanted) knob.closest('details').open = true;
      await choose(wanted?.other);
    },
    // Draws the same settings with the other value. What is said where that makes no picture; else "".
    draw(values, frame, size, first) {
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
        second.does('Density', size.density);
        second.does('Draw', size.width, size.height, false);
        refused = second.tells('State').error;
        if (!refused && !placed) place(first, size);
      }
      labels[0].textContent = `${knob.value} ${values[knob.value]}`;
      labels[1].textContent = `${knob.value} ${other}`;
      return refused && word('compareRefused', { knob: knob.value, value: other, sentence: refused });
    },
    // Whether a picture made in passes has more to come.
    more: (size) => begun !== '' && second.does('IsDue', size.width, size.height) && second.does('Draw', size.width, size.height, false),
  };
}
