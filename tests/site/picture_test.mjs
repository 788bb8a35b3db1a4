// node picture_test.mjs SOURCE MVGL BUILD: pictures of the user's own in live pages, by the file field, a drop, an address and a lesson's
// line: what is shown, what is told of files that are none, and that the last good picture stays.
import fs from 'node:fs';
import path from 'node:path';
import { browserOf, counted, equal, expect, liveSite, opened as openedIn, scratch, served, skipUnlessBuilt } from './support.mjs';

const [source, program, build] = process.argv.slice(2);
skipUnlessBuilt(build);
const address = await served(source, liveSite(build));
const browser = await browserOf(build);
const opened = (where) => openedIn(browser, address, where);

const sumOf = (page, which = 'first') => page.evaluate(async (which) => {
  document.querySelector('.view').scrollIntoView({ behavior: 'instant' });
  const { demo, what, compare, state } = document.querySelector('.live').live;
  do await new Promise(requestAnimationFrame); while (demo.does('IsDue', what.width, what.height) && !state().playing);
  const pixels = (which === 'first' ? demo : compare.second()).pixels(what.width * what.height);
  return pixels.reduce((sum, byte) => Math.imul(sum ^ byte, 16777619), 2166136261) >>> 0;
}, which);
const told = (page) => page.$eval('.refused', (element) => element.textContent);
const valueIs = (page, value) => page.waitForFunction((value) => document.querySelector('#knob-picture').value === value, {}, value);
const tells = (page, words) => page.waitForFunction((words) => document.querySelector('.refused').textContent.includes(words), {}, words);

// Files as a student has them
const file = (name, bytes) => {
  const target = path.join(scratch, name);
  fs.writeFileSync(target, bytes);
  return target;
};
const asset = (name) => fs.readFileSync(path.join(source, 'assets', name));
const mine = file('my picture, 1.png', asset('postcard.png'));
const chosen = async (page, name) => (await page.$('.file input[type=file]')).uploadFile(name);

// By an address, a lesson's line, the file field and a drop it is the same picture
let page = await opened('texture-map.html');
const plain = await sumOf(page);
await page.evaluate(() => (location.hash = '#picture=assets%2Fpostcard.png'));
await valueIs(page, 'assets/postcard.png');
const postcard = await sumOf(page);
expect(postcard !== plain, 'a picture of the site is shown');
equal(await told(page), '', 'what is said of it');
await page.evaluate(() => document.querySelector('.live').live.settle({ settings: {} }));
await valueIs(page, 'none');
equal(await sumOf(page), plain, 'the picture with none set');
await chosen(page, mine);
await valueIs(page, 'my picture, 1.png');
equal(await sumOf(page), postcard, 'the same file, chosen');
equal(await page.$eval('.command code', (code) => code.textContent), "./run texture-map --picture 'my picture, 1.png'", 'the command line');
const drop = (page, name, bytes) => page.evaluate((name, bytes) => {
  const dropped = new DataTransfer();
  dropped.items.add(new File([new Uint8Array(bytes)], name));
  const event = (kind) => new DragEvent(kind, { dataTransfer: dropped, bubbles: true, cancelable: true });
  const view = document.querySelector('.view');
  return [!view.dispatchEvent(event('dragover')), !view.dispatchEvent(event('drop'))].join();
}, name, [...bytes]);
equal(await drop(page, 'tiles.png', asset('tiles.png')), 'true,true', 'the page takes a drop for itself');
await valueIs(page, 'tiles.png');
const tiles = await sumOf(page);
expect(tiles !== postcard && tiles !== plain, 'a dropped picture is shown');
// Another file of the same name is another picture
await drop(page, 'tiles.png', asset('postcard.png'));
let replaced = await sumOf(page);
// The page reads a file in its own time, and the knob's value stays the same here: wait for the pixels
for (const end = Date.now() + 60_000; replaced === tiles && Date.now() < end; ) replaced = await sumOf(page);
equal(replaced, postcard, 'another file of the same name');

// What is no picture is told, and changes nothing
const large = Buffer.from(asset('tiles.png'));
for (const [name, bytes, words] of [
  ['notes.png', Buffer.from('no picture'), 'notes.png: must be a PNG or JPEG file'],
  ['empty.jpg', Buffer.alloc(0), 'empty.jpg: must be a PNG or JPEG file'],
  ['cut.png', large.subarray(0, 60), 'cut.png: must be an undamaged PNG or JPEG file'],
  ['film.gif', Buffer.from('GIF89a'), 'film.gif: must be a PNG or JPEG file'],
]) {
  await chosen(page, file(name, bytes));
  await tells(page, `picture: ${words}`);
  equal(await page.$eval('#knob-picture', (field) => field.value), 'tiles.png', `${name}: the knob`);
  equal(await sumOf(page), postcard, `${name}: the last good picture`);
}
// What the page does not have, too: the knob has the name then, as on a command line
await page.evaluate(() => document.querySelector('.live').live.settle({ settings: { picture: 'elsewhere.png' } }));
await tells(page, 'picture: elsewhere.png: must be chosen in this page');
expect(await page.$('.view.is-refused'), 'the last good picture is dimmed');
await chosen(page, mine);
await valueIs(page, 'my picture, 1.png');
equal(await sumOf(page), postcard, 'a picture that is one again');
equal(await told(page), '', 'what is said then');

// Compared with none, and with another one
await page.evaluate(() => document.querySelector('.live').live.settle({ settings: { picture: 'my picture, 1.png' }, compared: { knob: 'picture', other: 'none' } }));
await page.waitForFunction(() => document.querySelector('.label.is-b').textContent === 'picture none');
equal(await sumOf(page), postcard, 'the one picture');
equal(await sumOf(page, 'second'), plain, 'the other one, without');
await page.evaluate(() => document.querySelector('.live').live.settle({ settings: {}, compared: { knob: 'picture', other: 'assets/postcard.png' } }));
await page.waitForFunction(() => document.querySelector('.label.is-b').textContent === 'picture assets/postcard.png');
equal(await sumOf(page, 'second'), postcard, 'the other one, of the site');
await page.close();

// An address that is opened, one of the page's own pictures, and one that nobody has
page = await opened('texture-map.html#picture=assets%2Fpostcard.png');
equal(await sumOf(page), postcard, 'a link to a picture');
await page.close();
page = await opened('texture-map.html#picture=texture-map-postcard');
equal(await sumOf(page), postcard, "a link to one of the page's small pictures, which has a picture");
await page.close();
page = await opened('texture-map.html#picture=texture-map');
equal(await sumOf(page), plain, "a link to one of the page's small pictures");
await page.close();
page = await opened('texture-map.html#picture=gone.jpg');
await tells(page, 'picture: gone.jpg: must be chosen in this page');
await page.close();

// A demo that takes no file leaves a drop to the browser
page = await opened('cube-cull.html');
equal(await drop(page, 'tiles.png', asset('tiles.png')), 'false,false', 'a page whose demo takes no file');
await page.close();

await browser.close();
console.log(`${counted.checks} checks, ${counted.failures} failed`);
process.exit(counted.failures ? 1 : 0);
