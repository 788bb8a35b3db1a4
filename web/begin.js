// Begins the demo of a page before the page itself is read. The browser compiles its module while that comes (the page asks for it in its first
// lines) and makes the context that it draws into. live.js, below the picture, draws as soon as it is there. What does not come, the page tells.
'use strict';

(() => {
  const moduleAt = new URL(document.currentScript.dataset.module, document.baseURI).href;
  const isFile = location.protocol === 'file:'; // from a disk browsers load no modules
  document.documentElement.classList.toggle('is-embedded', new URLSearchParams(location.search).has('embed'));
  const isRead = new Promise((read) => document.addEventListener('DOMContentLoaded', read, { once: true }));
  // The context of a canvas is the one that is asked for first, by the page: the module's own wishes are ignored.
  const makeContext = (canvas) => void canvas.getContext('webgl2', { alpha: false, depth: false, stencil: false, antialias: false });
  globalThis.begun = { isRead, isFile, moduleAt, makeContext, canvas: document.createElement('canvas') };
  if (!isFile) {
    // Where the browser may not compile it, live.js is told why.
    begun.compiled = WebAssembly.compileStreaming?.(fetch(moduleAt)).catch(() => undefined);
    makeContext(begun.canvas);
  }
  isRead.then(() => {
    const box = document.querySelector('.live'), coming = document.createElement('p');
    const still = (sentence) => {
      coming.className = 'refused';
      coming.setAttribute('role', 'alert');
      coming.textContent = word('still', { sentence });
      box.classList.add('is-still');
    };
    coming.className = 'loading';
    coming.setAttribute('role', 'status');
    coming.innerHTML = isFile ? `${word('fromDisk')} <code>./run --site --serve</code>` : word('coming');
    box.querySelector('.panel').append(coming);
    if (isFile) return;
    if (begun.live) begun.live.catch((error) => still(error.message));
    else still(word('noScript'));
    setTimeout(() => coming.className === 'loading' && (coming.innerHTML = word('comingSlowly')), 10_000);
  });
})();
