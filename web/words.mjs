// What pages say beside the lessons, by keys: web/words.json has the words, all in one language. `script` gives a page's scripts the
// same function.
import fs from 'node:fs';

const words = JSON.parse(fs.readFileSync(new URL('words.json', import.meta.url), 'utf8'));

// The words of that key, with {name} replaced by the value of that name.
const spoken = (words) => (key, values = {}) => words[key].replace(/\{(\w+)\}/g, (all, name) => values[name]);
export const word = spoken(words);
export const keys = Object.keys(words);

export const script = `// What this page says; made from web/words.json.\n'use strict';\nglobalThis.word = (${spoken})(${JSON.stringify(words)});\n`;
