// Settings as texts: of the address, of a command line, of a knob's slider.

// The knobs that the address names, and the frame: #view=4&height=20&frame=30. null: it names none.
export function fromAddress(hash, knobs) {
  const settings = {};
  let frame;
  for (const [name, value] of new URLSearchParams(hash.slice(1))) {
    if (name === 'frame' && /^\d+$/.test(value)) frame = Number(value);
    else if (knobs.some((knob) => knob.name === name)) settings[name] = value;
  }
  return frame === undefined && !Object.keys(settings).length ? null : { settings, frame };
}

// Of the knobs those that are not at their initial values, and the frame of what moves.
export function toAddress(knobs, frame) {
  const names = new URLSearchParams();
  for (const knob of knobs) if (knob.value !== knob.initial) names.set(knob.name, knob.value);
  if (frame !== undefined) names.set('frame', frame);
  return `#${names.toString().replaceAll('%2C', ',').replaceAll('%2F', '/')}`;
}

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
    if (flag === 'headless') continue;
    value ??= rest.shift();
    if (flag === 'shot') continue; // where a picture is written to
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
