// Asks for the demo of a page before the page itself is read: for the script that drives it, and for its module, which the browser compiles while
// it comes. Where it does not come, the page says so. (A script of the old kind: a page in a frame without an origin of its own gets no
// modules.)
'use strict';

(() => {
  const up = new URL('..', location.href.split(/[?#]/)[0]).href, moduleAt = up + document.currentScript.dataset.module;
  const isFile = location.protocol === 'file:'; // from a disk browsers open no modules
  document.documentElement.classList.toggle('is-embedded', new URLSearchParams(location.search).has('embed'));
  const isRead = new Promise((read) => document.addEventListener('DOMContentLoaded', read, { once: true }));
  globalThis.begun = { isRead, moduleAt };
  const live = isFile ? isRead : import(`${up}live.js`);
  live.catch(() => undefined); // is told below, where there is a place for it
  // Where the browser may not compile it, live.js is told why.
  if (!isFile) begun.compiled = WebAssembly.compileStreaming?.(fetch(moduleAt)).catch(() => undefined);
  isRead.then(() => {
    const box = document.querySelector('.live'), coming = document.createElement('p');
    const still = (sentence) => {
      coming.className = 'refused';
      coming.setAttribute('role', 'alert');
      coming.textContent = word('still', { sentence });
      box.classList.add('is-still');
    };
    box.addEventListener('mvgl-still', ({ detail }) => still(detail));
    live.catch((error) => still(error.message));
    coming.className = 'loading';
    coming.setAttribute('role', 'status');
    coming.innerHTML = isFile ? `${word('fromDisk')} <code>./run --site --serve</code>` : word('coming');
    box.querySelector('.panel').append(coming);
    if (!isFile) setTimeout(() => coming.className === 'loading' && (coming.innerHTML = word('comingSlowly')), 10_000);
  });
})();
