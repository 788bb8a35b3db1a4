// A frame draw by draw: the picture stops after one of them, and beside it stands what that draw is made of and what it has drawn into.
import { tag } from './controls.js';

// `stop(draws)` stops the picture after so many draws, null: never; `buffer(index)` is a canvas with that buffer's picture.
export function drawSteps({ stop, buffer }) {
  const slider = tag('input', { type: 'range', min: 0, 'aria-label': word('drawsSlider'), oninput: () => stop(Number(slider.value)) });
  const by = (label, name, step) => tag('button', { type: 'button', 'aria-label': name, onclick: () => stop(Math.max(0, Math.min(Number(slider.max), Number(slider.value) + step))) }, label);
  const told = tag('p', { 'aria-live': 'polite' }), state = tag('ul', { class: 'state' }), buffers = tag('div', { class: 'buffers' });
  let first = 1; // where it is opened
  const element = tag('details', { class: 'steps', ontoggle: () => stop(element.open ? first : null) }, tag('summary', {}, word('draws')),
    tag('div', { class: 'row' }, by('<', word('drawLess'), -1), slider, by('>', word('drawMore'), 1)), told, state, buffers);
  let shown = '';
  return {
    element,
    until: () => (element.open ? Number(slider.value) : undefined),
    // Opens it at so many draws, or closes it: the picture is whole again.
    show(draws) {
      first = draws ?? 1;
      if (element.open && draws !== undefined) stop(draws);
      element.open = draws !== undefined;
    },
    update({ draws, until, shown: target }, pictures) {
      if (!element.open || !draws) return;
      slider.max = draws.length;
      slider.value = until;
      const draw = draws[until - 1], into = ({ target: name, target_width: width, target_height: height }) => (name === 'the picture' ? word('thePicture') : `${name}, ${width} x ${height}`);
      told.textContent = draw
        ? word('draw', { ...draw, number: until, all: draws.length, count: word(draw.indexed ? 'indices' : 'vertices', draw), target: into(draw) })
        : word('drawFirst', { all: draws.length });
      state.replaceChildren(...(draw?.state ?? []).map((call) => tag('li', {}, tag('code', {}, call))));
      if (shown === pictures) return;
      shown = pictures;
      const named = Object.entries(target).filter(([name]) => !name.startsWith('target'));
      buffers.replaceChildren(...named.map(([name, range], i) => tag('figure', {}, tag('figcaption', {}, word('buffer', { name, target: into(target), range })), buffer(i) ?? '')));
    },
  };
}
