// Cuts a font to the letters that the sources have, and writes it as C++: node web/font.mjs FONT OUTPUT.cpp FOLDER... With
// hb-subset, of HarfBuzz; outlines, widths and kerning stay.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';

const [font, output, ...folders] = process.argv.slice(2);
const letters = new Set([0xfffd]); // which stands for what is no letter
for (let ascii = 0x20; ascii < 0x7f; ++ascii) letters.add(ascii);
for (const folder of folders) {
  for (const file of fs.readdirSync(folder, { recursive: true })) {
    if (!/\.(cpp|h)$/.test(file)) continue;
    for (const letter of fs.readFileSync(path.join(folder, file), 'utf8')) if (letter > '~') letters.add(letter.codePointAt(0));
  }
}
const unicodes = [...letters].map((letter) => letter.toString(16)).join(',');
const cut = `${output}.ttf`;
execFileSync('hb-subset', [`--font-file=${font}`, `--output-file=${cut}`, '--no-hinting', '--notdef-outline', '--drop-tables=GSUB,GDEF,name', `--unicodes=${unicodes}`], {
  stdio: 'inherit',
});
fs.writeFileSync(
  output,
  `// Generated; do not edit.
#include <cstddef>

#include "mv/gl/font.h"

static const unsigned char bytes[] = {${fs.readFileSync(cut).join(',')}};

std::span<const std::byte> mv::fontFile() { return {reinterpret_cast<const std::byte*>(bytes), sizeof bytes}; }
`,
);
