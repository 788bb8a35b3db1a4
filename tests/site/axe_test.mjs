// node axe_test.mjs SOURCE MVGL BUILD [DEMO...]: nothing that axe-core knows of (WCAG 2.2 AA and good practice) stands between a page and
// a screen reader, a keyboard or weak eyes: each lesson with all of it unfolded, light and dark, two in another language, and the start page.
import fs from 'node:fs';
import path from 'node:path';
import { browserOf, counted, demosOf, expect, liveSite, opened, served, skipUnlessBuilt } from './support.mjs';

const [source, program, build, ...named] = process.argv.slice(2);
skipUnlessBuilt(build);
const axe = fs.readFileSync(path.join(build, 'npm/node_modules/axe-core/axe.min.js'), 'utf8');
const address = await served(source, liveSite(build));
const browser = await browserOf(build);

async function ask(page, where) {
  await page.evaluate(axe);
  const found = await page.evaluate(async () => (await globalThis.axe.run()).violations.map(({ id, nodes }) => `${id} in ${nodes.length}, ${nodes[0].html.slice(0, 160)}`));
  expect(!found.length, `${where}: ${found.join('; ')}`);
}
for (const scheme of ['light', 'dark']) {
  const start = await browser.newPage();
  await start.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: scheme }]);
  await start.goto(`${address}index.html`);
  await ask(start, `the start page, ${scheme}`);
  await start.close();
}
for (const demo of named.length ? named : [...demosOf(program), 'cube-cull.is', 'shadow.is']) {
  const page = await opened(browser, address, `${demo}.html`);
  await page.$$eval('details', (all) => all.forEach((one) => (one.open = true)));
  for (const scheme of ['light', 'dark']) {
    await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: scheme }]);
    await ask(page, `${demo}, ${scheme}`);
  }
  await page.close();
  console.log(demo);
}
await browser.close();
console.log(`${counted.checks} checks, ${counted.failures} failed`);
process.exit(counted.failures ? 1 : 0);
