// The hand in a demo's picture: drags, what is dragged by its handle, the wheel, two fingers and keys.
import { tag } from './controls.js';

const reach = { touch: 24 }, fine = 12; // CSS pixels: so near to a handle a finger takes it, and a mouse
const notch = 100; // CSS pixels of a wheel that turns by one
const notches = 4; // of the wheel, for two fingers that move twice as far apart

// `after()` is called when something may have moved. What comes back: `show()` for the rings round the handles, and what its keys do.
export function handIn(view, canvas, demo, what, after) {
  const rings = tag('div', { class: 'rings', 'aria-hidden': 'true' });
  view.append(rings);
  // Whole pixels of the page: a knob that goes by so much a pixel keeps its few digits, however dense the screen is.
  const at = (event) => {
    const place = canvas.getBoundingClientRect();
    return [event.clientX - place.left, event.clientY - place.top].map(Math.round);
  };
  const reachOf = (event) => reach[event.pointerType] ?? fine;
  function show() {
    if (!what.handles) return;
    rings.replaceChildren(...demo.tells('Handles').map(({ name, x, y, active }) => {
      const ring = tag('span', { class: active ? 'is-active' : '', title: name });
      ring.style.left = `${(100 * x) / canvas.width}%`;
      ring.style.top = `${(100 * y) / canvas.height}%`;
      return ring;
    }));
  }

  // The wheel is the original's; two fingers that spread come nearer in any demo: they make the eye's distance smaller, and z-dist, where
  // the eye stands on the z axis, nearer to 0.
  const [[wheeled, amount] = []] = Object.entries(what.wheels);
  const away = () => ({ distance: 1, 'z-dist': Number(demo.tells('Knobs')['z-dist']) })[wheeled] ?? 0;
  const nearer = () => (away() * amount > 0 ? -1 : 1);

  const fingers = new Map(); // by their pointers, where they are
  const spread = () => {
    const [one, other] = fingers.values();
    return Math.hypot(one[0] - other[0], one[1] - other[1]);
  };
  canvas.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    fingers.set(event.pointerId, at(event));
    canvas.setPointerCapture(event.pointerId);
    if (fingers.size === 1) demo.does('PointerDown', ...at(event), reachOf(event));
    else demo.does('PointerUp'); // a second finger: a pinch
  });
  canvas.addEventListener('pointermove', (event) => {
    if (!fingers.has(event.pointerId)) {
      demo.does('Hover', ...at(event), reachOf(event));
      return show();
    }
    const before = fingers.size === 2 ? spread() : 0;
    fingers.set(event.pointerId, at(event));
    if (fingers.size === 1) demo.does('PointerMove', ...at(event));
    if (before > 0) demo.does('Wheel', nearer() * notches * Math.log2(spread() / before));
    after();
  });
  for (const kind of ['pointerup', 'pointercancel']) {
    canvas.addEventListener(kind, (event) => {
      fingers.delete(event.pointerId);
      demo.does('PointerUp');
      show();
    });
  }
  canvas.addEventListener('pointerleave', () => {
    demo.does('Hover', 0, 0, -1);
    show();
  });
  // The wheel scrolls the page until the picture has been clicked.
  // A mouse gives a notch at once, a trackpad a hundred small ways that make one.
  let turned = 0;
  canvas.addEventListener('wheel', (event) => {
    if (!wheeled || document.activeElement !== canvas) return;
    event.preventDefault();
    turned -= event.deltaY / [notch, notch / 40, 1][event.deltaMode];
    const whole = Math.trunc(turned);
    if (!whole) return;
    turned -= whole;
    demo.does('Wheel', whole);
    after();
  }, { passive: false });
  if (what.drags || what.handles) canvas.style.touchAction = 'none';

  canvas.addEventListener('keydown', (event) => {
    if (event.altKey || event.metaKey || event.ctrlKey) return;
    const name = event.key.length === 1 ? event.key.toUpperCase() : event.key.replace('Arrow', '');
    // What is picked moves by the arrows before the demo's own keys do; H is the demo's where it has one. (Tab leaves the picture.)
    const own = name === 'H' ? ['Press', 'HandKey'] : ['HandKey', 'Press'];
    const isTaken = own.some((key) => (key === 'Press' ? demo.does('Press', name) : demo.does('HandKey', name, event.shiftKey)));
    if (!isTaken && name === ' ' && what.animated) demo.does('Toggle');
    else if (!isTaken) return;
    event.preventDefault();
    after();
    show();
  });

  return { show, keys: what.handles ? [[word('keyPick'), word('keyPickDoes')], [word('keyMore'), word('keyMoreDoes')]] : [] };
}
