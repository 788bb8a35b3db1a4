// node measure.mjs SOURCE MVGL BUILD: prints docs/browser.md: what a page loads, and when its first picture stands, each in a browser
// just started. The processor does what a GPU would: times are an upper bound, and compare pages with each other.
import fs from 'node:fs';
import path from 'node:path';
import zlib from 'node:zlib';
import { liveParts } from '../../web/pages.mjs';
import { browserOf, made, served } from './support.mjs';

const [source, program, build] = process.argv.slice(2).map((one) => path.resolve(one));
const rounds = 9, demos = ['cube-cull', 'shadow-map', 'springs', 'soft-shadows', 'ray-trace'];
const site = made(source, program, 'site', path.join(build, 'web'));
const address = await served(source, site);

const median = (values) => ((sorted) => (sorted.length % 2 ? sorted[(sorted.length - 1) / 2] : (sorted[sorted.length / 2 - 1] + sorted[sorted.length / 2]) / 2))([...values].sort((a, b) => a - b));
const spread = (values) => median(values.map((value) => Math.abs(value - median(values))));

const files = ['mvgl.wasm', 'mvgl.js', 'live.js', ...liveParts, 'words.js', 'site.js', 'curve.js', 'site.css'].map((file) => {
  const bytes = fs.readFileSync(path.join(site, file));
  return { file, bytes: bytes.length, brotli: zlib.brotliCompressSync(bytes).length };
});
const count = fs.readdirSync(path.join(site, 'demos')).filter((file) => file.endsWith('.html')).length;
const sum = files.reduce((total, { brotli }) => total + brotli, 0);

// Interleaved: each round has each page once, and the least page of a course beside them.
const pages = new Map([...demos.map((demo) => [demo, `${address}demos/${demo}.html`]), ['peer', `${await served(source, path.join(source, 'tests/site'))}peer.html`]]);
const times = Object.fromEntries([...pages.keys()].map((name) => [name, []]));
for (let round = 0; round < rounds; ++round) {
  for (const [name, where] of pages) {
    const browser = await browserOf(build);
    const page = await browser.newPage();
    await page.goto(where);
    await page.waitForSelector('.live.is-live, .is-drawn', { timeout: 60_000 });
    times[name].push(await page.evaluate(() => performance.getEntriesByName('first-picture')[0].startTime));
    await browser.close();
    console.error(`round ${round + 1} of ${rounds}: ${name}`);
  }
}
const ratios = times['cube-cull'].map((one, round) => one / times.peer[round]);
const processor = fs.readFileSync('/proc/cpuinfo', 'utf8').match(/model name\s*: (.*)/)?.[1];
console.log(`# The demos in a browser: sizes and times

<!-- Made by \`node tests/site/measure.mjs\`; a test refuses more than 18 KB a demo. -->

All ${count} demos are one module, which a browser loads once and keeps. In brotli what a page loads is ${Math.round(sum / 1024)} KB, ${(sum / 1024 / count).toFixed(1)} KB a
demo with the library, its font and all scripts.

| file | bytes | in brotli |
|---|---:|---:|
${files.map(({ file, bytes, brotli }) => `| ${file} | ${bytes} | ${brotli} |`).join('\n')}

The first picture of a page in a browser that was just started, after the address was given: median of ${rounds}, with the median
deviation. The processor draws (llvmpipe): ${processor}. Beside them the least page that draws cube-cull's picture: a script of its
own, no library, no control, nothing else to load. To it cube-cull's page has the ratio ${median(ratios).toFixed(2)} (deviation ${spread(ratios).toFixed(2)}).

| page | ms | deviation |
|---|---:|---:|
${demos.map((demo) => `| [${demo}](../demos/${demo}.md) | ${Math.round(median(times[demo]))} | ${Math.round(spread(times[demo]))} |`).join('\n')}
| the least page | ${Math.round(median(times.peer))} | ${Math.round(spread(times.peer))} |`);
process.exit(0);
