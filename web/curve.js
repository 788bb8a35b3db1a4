// The committed studies of a lesson as curves to ask: a figure for each machine, each an SVG that the library drew. The mouse over
// a point, or Tab, tells its numbers; a click, or Enter, the line that draws with its settings.
'use strict';

const box = document.querySelector('.curve'); // where the lesson has one
const study = box && JSON.parse(box.querySelector('script').textContent);
const figures = [...document.querySelectorAll('.curve figure')];

figures.forEach((figure, machine) => {
  for (const point of figure.querySelectorAll('[data-row]')) {
    const words = point.querySelector('title').textContent, settings = study.settings[machine][point.dataset.row];
    point.setAttribute('tabindex', 0);
    point.setAttribute('role', 'button');
    point.setAttribute('aria-label', words);
    const tell = () => (box.querySelector('.told').textContent = words);
    const set = () => {
      box.querySelector('.command code').textContent = ['./run', study.demo, ...Object.entries(settings).flatMap(([knob, value]) => [`--${knob}`, /^[\w.,:/+-]+$/.test(value) ? value : `'${value}'`])].join(' ');
      document.dispatchEvent(new CustomEvent('mvgl-settings', { detail: settings }));
      document.querySelector('.live .view')?.scrollIntoView({ block: 'nearest' });
    };
    point.addEventListener('mouseenter', tell);
    point.addEventListener('focus', tell);
    point.addEventListener('click', set);
    point.addEventListener('keydown', (event) => {
      if (event.key !== 'Enter' && event.key !== ' ') return;
      event.preventDefault();
      set();
    });
  }
});

// One machine at a time, or all of them below each other.
if (figures.length > 1) {
  const label = document.createElement('label'), select = document.createElement('select');
  label.append(`${word('studyMachine')} `, select);
  figures.forEach((figure, i) => select.append(new Option(figure.dataset.machine, i)));
  select.append(new Option(word('studyBoth'), 'both'));
  const show = () => figures.forEach((figure, i) => (figure.hidden = select.value !== 'both' && select.value !== String(i)));
  select.addEventListener('change', show);
  box.querySelector('.choices').append(label);
  show();
}
