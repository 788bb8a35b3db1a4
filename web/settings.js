// Settings as texts: of the address, of a command line, of a knob's slider.

// What the address says: #view=4&height=20&at=12,view=5&frame=30&compare=view,2&until=3&shader.lights.frag=TEXT. Knobs as `settings`, what is
// changed at a frame as `changes`, { frame, knob, value } each, the comparison as `compared`, the draws of a stopped frame as `until`,
// edited shaders by their names as `shaders`, and what is none of these as `unknown`. null: it says nothing of a picture.
export function fromAddress(hash, knobs) {
  const settings = {}, shaders = {}, unknown = [], changes = [];
  let frame, compared, until;
  for (const [name, value] of new URLSearchParams(hash.slice(1))) {
    const [, at, moved, to] = name === 'at' ? value.match(/^(\d{1,9}),([^=]*)=(.*)$/s) ?? [] : [];
    const isCount = /^\d{1,9}$/.test(value), [, knob, other] = name === 'compare' ? value.match(/^([^,]*),(.*)$/s) ?? [] : [];
    if (knobs.some((one) => one.name === name)) settings[name] = value;
    else if (name === 'frame' && isCount) frame = Number(value);
    else if (name === 'until' && isCount) until = Number(value);
    else if (knobs.some((one) => one.name === moved)) changes.push({ frame: Number(at), knob: moved, value: to });
    else if (knobs.some((one) => one.name === knob)) compared = { knob, other };
    else if (name.startsWith('shader.')) shaders[name.slice('shader.'.length)] = value;
    else if (value !== '') unknown.push(`${name}=${value}`); // without a value it is a heading of the lesson
  }
  const says = frame ?? compared ?? until ?? Object.keys({ ...settings, ...shaders })[0] ?? changes[0] ?? unknown[0];
  return says === undefined ? null : { settings, changes, frame, compared, until, shaders, unknown };
}

// The same address again: of the knobs those that are not at their initial values, and the frame of what moves.
export function toAddress(knobs, { changes = [], frame, compared, until, shaders = [] }) {
  const names = new URLSearchParams();
  for (const knob of knobs) if (knob.value !== knob.initial) names.set(knob.name, knob.value);
  for (const { frame: at, knob, value } of changes) names.append('at', `${at},${knob}=${value}`);
  if (frame !== undefined) names.set('frame', frame);
  if (compared?.knob) names.set('compare', `${compared.knob},${compared.other}`);
  if (until !== undefined) names.set('until', until);
  for (const [name, text] of shaders) names.set(`shader.${name}`, text);
  return `#${names.toString().replaceAll('%2C', ',').replaceAll('%2F', '/').replace(/(?<=(?:^|&)at=[^&]*)%3D/g, '=')}`;
}

// A number as it is typed in any country: blanks around it do not count, and the comma is a point.
export const typedNumber = (text) => text.trim().replace(',', '.').replace('\u2212', '-');

// The words of a command line, as a shell reads them.
function words(line) {
  return [...line.replace(/\s#.*$/, '').matchAll(/(?:'[^']*'|[^\s'])+/g)].map(([word]) => word.replace(/'/g, ''));
}

// What ./run DEMO --knob value ... sets: { settings, frame, compared: { knob, other }, until }. null where it is another demo's, or has a flag that is none of a picture.
export function fromCommand(line, demo, knobs, presets) {
  const [run, name, ...rest] = words(line);
  if (run !== './run' || name !== demo) return null;
  const settings = {};
  let frame, compared, until, start = {};
  while (rest.length) {
    let [flag, value] = rest.shift().split(/=(.*)/s);
    if (!flag.startsWith('--')) return null;
    flag = flag.slice(2);
    if (flag === 'headless' || flag === 'report') continue; // what it tells stands beside the picture
    value ??= rest.shift();
    if (flag === 'shot' || flag === 'size') continue; // where a picture is written to, and how large
    if (flag === 'preset') start = presets.find((one) => one.name === value)?.settings;
    else if (flag === 'frame') frame = Number(value);
    else if (flag === 'until') until = Number(value);
    else if (flag === 'compare') {
      const [, knob, one, other] = value.match(/^([^=]*)=([^,]*),([^,]*)$/) ?? [];
      if (!knobs.some((known) => known.name === knob)) return null;
      settings[knob] = one;
      compared = { knob, other };
    } else if (knobs.some((knob) => knob.name === flag)) settings[flag] = value;
    else return null;
    if (!start || value === undefined) return null;
  }
  return { settings: { ...start, ...settings }, frame, compared, until };
}

// A slider goes from 0 to 1000, of a logarithmic knob by equal factors; where 0 is allowed beside those, it is the first step.
const steps = 1000;
export function fromSlider(position, { low, high, whole, logarithmic, orZero }) {
  if (!logarithmic) {
    const value = low + ((high - low) * position) / steps;
    return whole ? String(Math.round(value)) : String(Number(value.toPrecision(4)));
  }
  if (orZero && position === 0) return '0';
  const part = orZero ? (position - 1) / (steps - 1) : position / steps;
  const value = part <= 0 ? low : part >= 1 ? high : Number((low * (high / low) ** part).toPrecision(3));
  return String(value);
}
export function toSlider(text, { low, high, logarithmic, orZero }) {
  const value = Number(text);
  if (!logarithmic) return Math.round((steps * (value - low)) / (high - low));
  if (orZero && value === 0) return 0;
  const part = Math.log(value / low) / Math.log(high / low);
  return Math.round(orZero ? 1 + part * (steps - 1) : part * steps);
}
