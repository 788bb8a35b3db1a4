// What the tests of the pages share: checks that are counted, the site made and served, a browser that draws through Mesa.
import { execFileSync, spawn, spawnSync } from 'node:child_process';
import fs from 'node:fs';
import { createRequire } from 'node:module';
import os from 'node:os';
import path from 'node:path';
import zlib from 'node:zlib';

export const counted = { checks: 0, failures: 0 };
export function expect(holds, says) {
  ++counted.checks;
  if (holds) return;
  ++counted.failures;
  console.log(`FAILED: ${says}`);
}
export const equal = (found, expected, what) => expect(found === expected, `${what}: expected '${expected}', found '${found}'`);
export const all = (text, pattern) => [...text.matchAll(pattern)].map((match) => match[1]);

// A folder of its own, and what stops with the process.
export const scratch = fs.mkdtempSync(path.join(os.tmpdir(), 'site-'));
const servers = [];
process.on('exit', () => {
  for (const server of servers) server.kill();
  fs.rmSync(scratch, { recursive: true, force: true });
});

// The site in that folder (below scratch, unless it is an absolute one), with the module of `module` where one is given; and where it is served.
export function made(source, program, folder, module) {
  const site = path.resolve(scratch, folder);
  fs.rmSync(site, { recursive: true, force: true });
  execFileSync('node', [path.join(source, 'web/make.mjs'), program, site, ...(module ? [module] : [])], { stdio: ['ignore', 'ignore', 'pipe'] });
  return site;
}
export async function served(source, site) {
  const server = spawn('node', [path.join(source, 'web/serve.mjs'), site, '0'], { stdio: ['ignore', 'pipe', 'inherit'] });
  servers.push(server);
  return (await new Promise((resolve) => server.stdout.once('data', resolve))).toString().split(' ')[0];
}
// The one with its demos alive, which made.mjs has made.
export const liveSite = (build) => path.join(build, 'tests/site');
export const demosOf = (program) => all(execFileSync(program, ['--list'], { encoding: 'utf8' }), /^ {2}(\S+)/gm);

// The modules of a site, one for each chapter.
export const modulesOf = (site) => fs.readdirSync(site).filter((file) => file.endsWith('.wasm'));
// What pages of demos load, each with one of the modules: [{ file, bytes, brotli }]; the most that one loads, in brotli; and the most that it
// may: on slow 4G (1.6 Mb/s) a demo is to be movable in 3.5 s, of which its page and its start take 1.5.
export const loadedBy = (site) =>
  [...modulesOf(site), 'begin.js', 'live.js', 'site.js', 'site.css'].map((file) => {
    const bytes = fs.readFileSync(path.join(site, file));
    return { file, bytes: bytes.length, brotli: zlib.brotliCompressSync(bytes).length };
  });
export const mostOf = (files) => {
  const modules = files.filter(({ file }) => file.endsWith('.wasm')).map(({ brotli }) => brotli);
  return files.reduce((sum, { brotli }) => sum + brotli, 0) - modules.reduce((sum, one) => sum + one, 0) + Math.max(...modules);
};
export const mostLoaded = 2 * 1.6e6 / 8;

// The bytes of the largest function of a WebAssembly module: a browser compiles a function when it is first called, and the one that
// is called first of all has what is made before anybody asks for it.
export function largestFunction(bytes) {
  let at = 8;
  const number = () => {
    for (let value = 0, factor = 1; ; factor *= 128) {
      const byte = bytes[at++];
      value += (byte & 127) * factor;
      if (byte < 128) return value;
    }
  };
  while (at < bytes.length) {
    const section = bytes[at++], size = number(), end = at + size;
    if (section !== 10) {
      at = end;
      continue;
    }
    let largest = 0;
    for (let left = number(); left > 0; --left) {
      const body = number();
      largest = Math.max(largest, body);
      at += body;
    }
    return largest;
  }
  throw new Error('a module without code');
}
export const largestAllowed = 64_000; // all lessons, made at once, were 257 KB

// Chromium's name here, or undefined.
export const chromium = ['chromium', 'chromium-browser', 'google-chrome'].find((name) => !spawnSync(name, ['--version']).error);

// Ends the test as skipped, with the reason, where there is nothing to test live pages with.
export function skipUnlessBuilt(build) {
  const skip = (why) => {
    console.log(`skipped: ${why}`);
    process.exit(77);
  };
  if (!chromium) skip('there is no Chromium');
  if (!fs.existsSync(path.join(build, 'web/motion/mvgl.wasm'))) skip('the demos are not built for browsers (./test --full does, with emscripten)');
  if (!fs.existsSync(path.join(build, 'npm/node_modules/puppeteer-core'))) skip('puppeteer-core is not installed (./test --full does, with npm)');
}

// What puppeteer-core, of BUILD/npm, starts: a browser that draws through the Mesa of the native program, or with other flags.
export const throughMesa = ['--use-gl=angle', '--use-angle=gl-egl', '--ignore-gpu-blocklist'];
export function browserOf(build, flags = throughMesa) {
  const puppeteer = createRequire(path.join(build, 'npm/package.json'))('puppeteer-core');
  const own = process.getuid() === 0 ? ['--no-sandbox'] : [];
  return puppeteer.launch({
    executablePath: execFileSync('which', [chromium], { encoding: 'utf8' }).trim(),
    protocolTimeout: 120_000,
    // A container's shared memory can be too small for two browsers, and on a busy machine a driver that computes looks as if it hung.
    args: [...own, '--disable-background-networking', '--disable-dev-shm-usage', '--disable-gpu-watchdog', ...flags],
  });
}

// The page of a demo, once it is alive; what the console says fails the test. page.asked() is page.evaluate(), and fails when the page
// crashes. (In a window as large as this each demo has its canvas' own size.)
export async function opened(browser, address, where, { width = 1700, height = 900, deviceScaleFactor = 1 } = {}) {
  const page = await browser.newPage();
  page.on('console', (message) => expect(false, `${where}: the console says ${message.text()}`));
  page.on('pageerror', (error) => expect(false, `${where}: ${error.message}`));
  // What a page is asked that has crashed would wait for its time limit.
  const crash = new Promise((never, reject) => page.once('error', reject));
  crash.catch(() => {});
  page.asked = (...question) => Promise.race([page.evaluate(...question), crash]);
  await page.setViewport({ width, height, deviceScaleFactor });
  await page.goto(`${address}demos/${where}`);
  await page.waitForSelector('.live.is-live, .live.is-still', { timeout: 120_000 });
  equal(await page.$eval('.panel', (panel) => panel.closest('.is-still')?.textContent ?? ''), '', `${where}: why it is not alive`);
  return page;
}
