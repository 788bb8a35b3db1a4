// What pages say beside the lessons, by keys: web/words.json has the words in English, web/words.LANG.json in another language.
// `scriptOf(language)` gives a page's scripts the same function.
import fs from 'node:fs';

const here = new URL('.', import.meta.url);
const read = (file) => JSON.parse(fs.readFileSync(new URL(file, here), 'utf8'));
const all = { en: read('words.json') };
for (const file of fs.readdirSync(here)) {
  const [, language] = file.match(/^words\.(\w+)\.json$/) ?? [];
  if (language) all[language] = read(file);
}
// English first, then the others.
export const languages = Object.keys(all);
export const keysOf = (language) => Object.keys(all[language]);

// The words of that key, with {name} replaced by the value of that name.
const spoken = (words) => (key, values = {}) => words[key].replace(/\{(\w+)\}/g, (all, name) => values[name]);
let present = 'en';
export const speak = (language) => void (present = language);
export const language = () => present;
export const word = (key, values) => spoken(all[present])(key, values);

export const scriptOf = (language) => `// What this page says; made from web/words.json.\n'use strict';\nglobalThis.word = (${spoken})(${JSON.stringify(all[language])});\n`;
