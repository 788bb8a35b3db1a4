// The committed study of a lesson as a curve to ask: error against run time, both logarithmic, a line for each method. The
// mouse over a point, or Tab, tells its numbers; a click, or Enter, the line that draws with its settings.
'use strict';

const box = document.querySelector('.curve');
const study = JSON.parse(box.querySelector('script').textContent);
const colors = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#8c6d00', '#3b9dd8', '#7f3fbf', '#777777'];
const numbers = { rms: word('studyRms'), max: word('studyMax'), fraction: word('studyFraction') };
const valueOf = (row, number) => row[number] * (number === 'fraction' ? 100 : 1);
const short = (value) => (value === 0 ? '0' : Number(value.toPrecision(3)).toString());

const svgTag = (name, attributes, words) => {
  const tag = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [key, value] of Object.entries(attributes)) tag.setAttribute(key, value);
  if (words !== undefined) tag.textContent = words;
  return tag;
};

// From values above 0 to a length along an axis, from whole powers of ten to whole powers of ten.
function logarithmic(values, from, to) {
  const above = values.filter((value) => value > 0);
  const low = Math.floor(Math.log10(Math.min(...above, 1e300))), high = Math.ceil(Math.log10(Math.max(...above, 1e-300)));
  const [first, last] = above.length ? [low, Math.max(high, low + 1)] : [-1, 0];
  const step = Math.max(1, Math.ceil((last - first) / 8));
  const ticks = [];
  for (let power = first; power <= last; power += step) ticks.push(power);
  return { at: (value) => from + ((Math.log10(value) - first) / (last - first)) * (to - from), ticks };
}

function draw(scene, number) {
  const width = 720, height = 420, left = 70, right = 16, top = 14, bottom = 46, zero = 26;
  const rows = study.rows.filter((row) => row.scene === scene);
  const svg = svgTag('svg', { viewBox: `0 0 ${width} ${height}`, role: 'group', 'aria-label': word('studyPicture', { scene, number: numbers[number] }) });
  const errors = rows.map((row) => valueOf(row, number));
  const hasZero = errors.some((value) => value === 0);
  const floor = height - bottom - (hasZero ? zero : 0);
  const across = logarithmic(rows.map((row) => row.ms), left, width - right), up = logarithmic(errors, floor, top);
  const y = (value) => (value === 0 ? height - bottom - 8 : up.at(value));
  const power = (exponent) => short(10 ** exponent).replace(/e\+?/, 'e');
  for (const tick of across.ticks) {
    const x = across.at(10 ** tick);
    svg.append(svgTag('line', { x1: x, x2: x, y1: top, y2: height - bottom, class: 'grid' }));
    svg.append(svgTag('text', { x, y: height - bottom + 18, 'text-anchor': 'middle' }, power(tick)));
  }
  for (const tick of up.ticks) {
    const at = up.at(10 ** tick);
    svg.append(svgTag('line', { x1: left, x2: width - right, y1: at, y2: at, class: 'grid' }));
    svg.append(svgTag('text', { x: left - 8, y: at + 4, 'text-anchor': 'end' }, power(tick)));
  }
  if (hasZero) svg.append(svgTag('text', { x: left - 8, y: y(0) + 4, 'text-anchor': 'end' }, '0'));
  svg.append(svgTag('text', { x: (left + width) / 2, y: height - 8, 'text-anchor': 'middle' }, word('studyTime')));
  svg.append(svgTag('text', { x: 14, y: (top + floor) / 2, 'text-anchor': 'middle', transform: `rotate(-90 14 ${(top + floor) / 2})` }, numbers[number]));

  const methods = [...new Set(rows.map((row) => row.method))];
  methods.forEach((method, i) => {
    const line = rows.filter((row) => row.method === method), color = colors[i % colors.length];
    const points = line.map((row) => `${across.at(row.ms)},${y(valueOf(row, number))}`).join(' ');
    svg.append(svgTag('polyline', { points, fill: 'none', stroke: color, 'stroke-width': 2, 'stroke-dasharray': i < colors.length ? '' : '6 4' }));
  });
  // Above all lines, so that each can be pointed at
  for (const row of rows) {
    const color = colors[methods.indexOf(row.method) % colors.length];
    const line = `${row.method}${row.parameter ? `, ${row.parameter}` : ''}`;
    const words = word('studyPoint', { line, number: numbers[number], value: short(valueOf(row, number)), ms: short(row.ms), deviation: short(row.mad) });
    const point = svgTag('circle', { cx: across.at(row.ms), cy: y(valueOf(row, number)), r: row.best ? 6 : 4.5, fill: color, tabindex: 0, role: 'button', 'aria-label': words });
    point.append(svgTag('title', {}, words));
    const tell = () => (box.querySelector('.told').textContent = words);
    const set = () => {
      box.querySelector('.command code').textContent = ['./run', study.demo, ...Object.entries(row.settings).flatMap(([knob, value]) => [`--${knob}`, /^[\w.,:/+-]+$/.test(value) ? value : `'${value}'`])].join(' ');
      document.dispatchEvent(new CustomEvent('mvgl-settings', { detail: row.settings }));
    };
    point.addEventListener('mouseenter', tell);
    point.addEventListener('focus', tell);
    point.addEventListener('click', set);
    point.addEventListener('keydown', (event) => {
      if (event.key !== 'Enter' && event.key !== ' ') return;
      event.preventDefault();
      set();
    });
    svg.append(point);
  }
  box.querySelector('.drawn').replaceChildren(svg);
  box.querySelector('.legend').replaceChildren(...methods.map((method, i) => {
    const item = document.createElement('li');
    item.textContent = method;
    item.style.setProperty('--color', colors[i % colors.length]);
    return item;
  }));
}

function choice(label, options, chosen, changed) {
  const all = document.createElement('label'), select = document.createElement('select');
  all.append(`${label} `, select);
  for (const [value, words] of options) select.append(new Option(words, value, false, value === chosen));
  select.addEventListener('change', () => changed(select.value));
  return all;
}

let scene = study.rows[0].scene, number = study.axis;
const redraw = () => draw(scene, number);
const scenes = [...new Set(study.rows.map((row) => row.scene))];
const choices = box.querySelector('.choices');
if (scenes.length > 1) choices.append(choice(word('studyScene'), scenes.map((one) => [one, one]), scene, (value) => { scene = value; redraw(); }));
choices.append(choice(word('studyError'), Object.entries(numbers), number, (value) => { number = value; redraw(); }));
redraw();
