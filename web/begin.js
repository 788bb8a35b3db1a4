// Asks for the demo of a page once the picture in its place is there, which all its files would make later, and then for all of them at
// once, instead of each by the one before; and begins it when the picture is on the screen. Where it does not come, the page says so. (A script of the old kind: a page in a
// frame without an origin of its own gets no modules.)
'use strict';

(async () => {
  const box = document.querySelector('.live'), { parts } = document.currentScript.dataset;
  const up = new URL('..', location.href.split(/[?#]/)[0]).href;
  document.documentElement.classList.toggle('is-embedded', new URLSearchParams(location.search).has('embed'));
  const coming = document.createElement('p');
  coming.className = 'loading';
  coming.setAttribute('role', 'status');
  box.querySelector('.panel').append(coming);
  const say = (words) => (coming.innerHTML = words);
  const still = (sentence) => {
    coming.className = 'refused';
    coming.setAttribute('role', 'alert');
    coming.textContent = word('still', { sentence });
    box.classList.add('is-still');
  };
  if (location.protocol === 'file:') return say(`${word('fromDisk')} <code>./run --site --serve</code>`); // from a disk browsers open no modules
  say(word('coming'));
  setTimeout(() => coming.isConnected && coming.className === 'loading' && say(word('comingSlowly')), 10_000);
  box.addEventListener('mvgl-still', ({ detail }) => still(detail));
  const shown = box.querySelector('.shown');
  if (!shown.complete) await new Promise((come) => ['load', 'error'].forEach((event) => shown.addEventListener(event, come, { once: true })));
  const early = (given) => document.head.append(Object.assign(document.createElement('link'), given));
  for (const file of ['live.js', ...parts.split(' ')]) early({ rel: 'modulepreload', href: up + file });
  // The browser compiles the module while it comes, beside all else. Where it may not, live.js is told why.
  globalThis.compiled = WebAssembly.compileStreaming?.(fetch(`${up}mvgl.wasm`)).catch(() => undefined);
  await shown.decode().catch(() => {});
  await new Promise((painted) => requestAnimationFrame(() => setTimeout(painted)));
  import(`${up}live.js`).catch((error) => still(error.message));
})();
