// The formulas of a lesson as MathML: in the source they are indented lines of plain text, "v_r = v - 2 n (n.v)". A block is converted as
// a whole or not at all: one that is code, or has anything that this does not know, stays as it is written.
//
// Two spaces or more part a line into columns, each of which is a formula or words. a/b is a fraction, a^b a power, x_min and p0 have
// a lower index, p' a prime; a x b is a cross product between two names, <a, b> and n . v are inner products; |..| bounds a length.
// Lines of as many columns, none with a relation, are the rows of a matrix; so is what stands between bars that lie below each other.

export const greek = { alpha: 'α', beta: 'β', delta: 'δ', eta: 'η', gamma: 'γ', lambda: 'λ', phi: 'φ', Phi: 'Φ', pi: 'π', rho: 'ρ', theta: 'θ' };
const withIndex = new RegExp(`^(\\p{L}|${Object.keys(greek).join('|')})_(\\w+)$`, 'u');
const written = { '->': '→', '*': '·', '<=': '≤', '>=': '≥', '-+': '∓', '-': '−', '..': '..', ' . ': '·' };
const relations = ['=', '<', '>', ':']; // and labels: no entry of a matrix has one
const closing = { '(': ')', '|(': '|', '<(': '>' };
// A column that has one of these is words, and so is one with a name of a person.
const prose = /\b(?:and|as|both|by|divided|drawn|for|from|is|of|that|the|this|to|what|where|wherever|with)\b(?! *[=^/*+)])|\b[A-Z][a-z]{2,}\b(?!From)/;
const escaped = (words) => words.replace(/&/g, '&amp;').replace(/</g, '&lt;').replace(/>/g, '&gt;');
const plain = (html) => html.replace(/&lt;/g, '<').replace(/&gt;/g, '>').replace(/&quot;/g, '"').replace(/&amp;/g, '&');

class NoFormula extends Error {}

// [{ kind: 'name' | 'number' | 'operator' | 'open' | 'close', text, spaced }], where `spaced` says that a space stood before it. `names`
// are those that have a hyphen: "z-dist".
function tokensOf(text, names) {
  const tokens = [], bounds = [];
  const hyphened = [...names].sort((a, b) => b.length - a.length);
  for (let at = 0; at < text.length;) {
    const rest = text.slice(at), [space] = rest.match(/^ */);
    if (space && !rest.startsWith(' . ')) {
      at += space.length;
      if (at < text.length) tokens.pendingSpace = true;
      continue;
    }
    const before = tokens.at(-1), spaced = Boolean(tokens.pendingSpace), next = rest[1] ?? ' ';
    tokens.pendingSpace = false;
    const add = (kind, found, as = found) => {
      tokens.push({ kind, text: as, spaced });
      at += found.length;
    };
    const begins = !before || before.kind === 'operator' || before.kind === 'open';
    const name = hyphened.find((one) => rest.startsWith(one) && !/^[\w-]/.test(rest.slice(one.length))) ?? rest.match(/^\p{L}\w*'?/u)?.[0];
    const number = rest.match(/^\d+(?:\.\d+)?(?:e-?\d+)?°?/)?.[0], operator = rest.match(/^(?: \. |<=|>=|->|-\+|--+|\.\.\.?|[-=+*/^,;·.×]|[:<>](?= |$))/)?.[0];
    if (name) add('name', name);
    else if (number) add('number', number);
    else if (rest[0] === '(') bounds.push('('), add('open', '(');
    else if (rest[0] === ')' && bounds.pop() === '(') add('close', ')');
    else if (rest[0] === '|' && (begins || (spaced && next !== ' '))) bounds.push('|('), add('open', '|', '|(');
    else if (rest[0] === '|' && bounds.pop() === '|(') add('close', '|');
    else if (rest[0] === '<' && /[\w]/.test(next)) bounds.push('<('), add('open', '<', '<(');
    else if (rest[0] === '>' && !spaced && bounds.at(-1) === '<(') bounds.pop(), add('close', '>');
    else if (operator && !operator.startsWith('--')) add('operator', operator);
    else throw new NoFormula(`'${rest[0]}'`);
  }
  if (bounds.length) throw new NoFormula(`'${bounds.at(-1)}' has no end`);
  return tokens;
}

// A name: in a Greek letter, with its lower index and its prime.
function nameOf(text) {
  const [, whole, prime] = text.match(/^(.*?)('?)$/), letter = (one) => greek[one] ?? one;
  const [, base, index] = whole.match(withIndex) ?? whole.match(/^(\p{L}+?)(\d+)$/u) ?? [];
  const mi = (one) => `<mi>${letter(one)}</mi>`, lower = index && (/^\d+$/.test(index) ? `<mn>${index}</mn>` : mi(index));
  const made = index ? `<msub>${mi(base)}${lower}</msub>` : mi(whole);
  return prime ? `<mrow>${made}<mo lspace="0" rspace="0">′</mo></mrow>` : made;
}
const operatorOf = (text) => `<mo>${escaped(written[text] ?? text)}</mo>`;
const isTall = /<mfrac>|<msqrt>/; // bounds grow with these
const thin = '<mspace width="0.2em"></mspace>';
const gap = '<mspace width="1.5em"></mspace>';
const row = (parts) => (parts.length === 1 ? parts[0] : `<mrow>${parts.join('')}</mrow>`);

// The MathML of tokens from `from` on, to the end or to what closes it: { parts, at }.
function sequence(tokens, from, end) {
  const parts = [], unbounded = new Map(); // what is in parentheses, by itself
  let factors = 0; // of the present product, since its last fraction: so many parts at the end
  let at = from;
  // One factor with its power, without the bounds of what stands above or below a line.
  function factor(isBounded) {
    const token = tokens[at];
    if (!token) throw new NoFormula('something is missing at the end');
    let made;
    if (token.kind === 'name' && token.text === 'sqrt' && tokens[at + 1]?.text === '(') {
      const inner = sequence(tokens, at + 2, ')');
      at = inner.at + 1;
      made = `<msqrt>${inner.parts.join('')}</msqrt>`;
    } else if (token.kind === 'name' || token.kind === 'number') {
      ++at;
      made = token.kind === 'name' ? nameOf(token.text) : `<mn>${token.text}</mn>`;
      // A component, v.x, or an inner product, n.v
      while (tokens[at]?.text === '.' && tokens[at + 1]?.kind === 'name' && !tokens[at].spaced) {
        const part = tokens[at + 1].text;
        made = `<mrow>${made}<mo lspace="0" rspace="0">${/^[xyzw]+$/.test(part) ? '.' : '·'}</mo>${nameOf(part)}</mrow>`;
        at += 2;
      }
    } else if (token.kind === 'open') {
      const inner = sequence(tokens, at + 1, closing[token.text]);
      at = inner.at + 1;
      const [open, close] = { '(': '()', '|(': '||', '<(': '⟨⟩' }[token.text];
      const fence = (one) => `<mo${isTall.test(inner.parts.join('')) ? '' : ' stretchy="false"'}>${one}</mo>`;
      const alone = row(inner.parts), isPair = parens(inner.parts);
      made = !isBounded && token.text === '(' && !isPair ? alone : `<mrow>${fence(open)}${inner.parts.join('')}${fence(close)}</mrow>`;
      if (token.text === '(' && !isPair) unbounded.set(made, alone);
    } else {
      throw new NoFormula(`'${token.text}' where a number or a name is to stand`);
    }
    if (tokens[at]?.text === '^') {
      const isNegative = tokens[++at]?.text === '-';
      if (isNegative) ++at;
      const power = factor(false);
      made = `<msup>${made}${isNegative ? `<mrow>${operatorOf('-')}${power}</mrow>` : power}</msup>`;
    }
    return made;
  }
  // A pair, "(x, y)", keeps its bounds.
  function parens(inner) {
    return inner.some((part) => part === '<mo>,</mo>');
  }
  while (at < tokens.length && !(tokens[at].kind === 'close' && tokens[at].text === end)) {
    const token = tokens[at];
    const isCross = token.text === 'x' && at > from && ['name', 'close'].includes(tokens[at - 1].kind) && ['name', 'open'].includes(tokens[at + 1]?.kind) && tokens[at + 1].spaced;
    if (isCross) {
      parts.push('<mo>×</mo>');
      ++factors;
      ++at;
    } else if (token.text === '/' && !token.isInWords) {
      if (!factors) throw new NoFormula('a fraction without what stands above');
      ++at;
      const above = parts.splice(parts.length - factors), below = factor(false);
      parts.push(`<mfrac>${above.length === 1 ? unbounded.get(above[0]) ?? above[0] : row(above)}${below}</mfrac>`);
      factors = 0;
    } else if (token.kind === 'operator') {
      parts.push(operatorOf(token.text));
      factors = 0;
      ++at;
    } else {
      if (token.kind === 'close') throw new NoFormula(`'${token.text}' closes nothing`);
      const isApart = token.spaced && parts.length > 0 && !tokens[at - 1]?.kind.startsWith('op') && parts.at(-1) !== '<mo>×</mo>';
      const made = factor(true);
      if (isApart) {
        parts.push(thin);
        if (factors) ++factors;
      }
      parts.push(made);
      ++factors;
    }
  }
  if (end && at >= tokens.length) throw new NoFormula(`no '${end}'`);
  return { parts, at };
}

const words = (text) => `<mtext>${escaped(text)}</mtext>`;

// A column: a formula, or words, or words that name what a formula is, "HSL: l = ...".
function cell(text, names) {
  const [, label, rest] = text.match(/^(\w+:) +(.*)$/) ?? [];
  if (rest && !prose.test(text)) return words(label) + thin + thin + row(sequence(tokensOf(rest, names), 0).parts);
  if (prose.test(text)) {
    const [, left, right] = text.match(/^(\w+) = (.*)$/) ?? [];
    return left ? `${nameOf(left)}<mo>=</mo>${words(right)}` : words(text);
  }
  // Names alone are words: "implicit midpoint"
  const tokens = tokensOf(text, names);
  if (tokens.length > 1 && tokens.every(({ kind, text: one }) => kind === 'name' && one.length > 2)) return words(text);
  return row(sequence(tokens, 0).parts);
}

// A line's columns: what is open, or begins or ends with an operator, goes on after the spaces.
function columnsOf(line) {
  const columns = [];
  for (const part of line.trim().split(/ {2,}/)) {
    const last = columns.at(-1) ?? '', open = last.split('(').length > last.split(')').length;
    if (columns.length && (open || /^(?:[=*+/]|<=|>=|->|- )/.test(part) || /(?:[=*+/-]|->)$/.test(last))) columns[columns.length - 1] += ` ${part}`;
    else columns.push(part);
  }
  return columns;
}

const table = (rows, kind) => `<mtable class="${kind}" displaystyle="true">${rows.map((cells) => `<mtr>${cells.map((one) => `<mtd>${one}</mtd>`).join('')}</mtr>`).join('')}</mtable>`;
const matrix = (rows) => `<mrow><mo>[</mo>${table(rows, 'matrix')}<mo>]</mo></mrow>`;

// Lines with bars at the same places: what is between two of them is a matrix.
function barred(lines, names) {
  const bars = [...lines[0].matchAll(/\|/g)].map((one) => one.index);
  if (lines.length < 2 || bars.length < 2 || bars.length % 2) return undefined;
  if (lines.some((line) => [...line.matchAll(/\|/g)].map((one) => one.index).join() !== bars.join())) return undefined;
  const parts = [];
  for (let i = 0; i <= bars.length; ++i) {
    const between = lines.map((line) => line.slice(i ? bars[i - 1] + 1 : 0, bars[i]).trim());
    const said = between.filter(Boolean);
    if (i % 2) {
      const rows = between.map((line) => line.split(/ {2,}/));
      if (rows.some((one) => one.length !== rows[0].length)) throw new NoFormula('rows of a matrix with other numbers of columns');
      parts.push(matrix(rows.map((one) => one.map((entry) => cell(entry, names)))));
    } else if (said.length > 1) {
      parts.push(gap, table(said.map((one) => [cell(one, names)]), 'lines'));
    } else if (said.length) {
      const [outside] = said;
      parts.push(...columnsOf(outside).map((one, column) => (column || (i > 0 && (i === bars.length || one.includes('=')) && /^[\w(]/.test(one)) ? gap : '') + cell(one, names) + (prose.test(one) ? gap : '')));
    }
  }
  return row(parts);
}

// The same of lines without an empty one between them; undefined: all of it is words.
function partOf(lines, names) {
  const apart = barred(lines, names);
  if (apart) return apart;
  const columns = lines.map(columnsOf), count = columns[0].length;
  const isMatrix = lines.length > 1 && count === lines.length && columns.flat().every((one) => !relations.some((sign) => one.includes(sign)) && !prose.test(one)) && columns.every((line) => line.length === count);
  const cells = columns.map((line) => line.map((one) => cell(one, names)));
  if (isMatrix) return matrix(cells);
  if (!cells.flat().some((one) => /<m(?:o|n|frac|su[bp]|sqrt)\b/.test(one))) return undefined;
  // Columns lie below each other where each line has as many, or begins with words.
  if (cells.every((line) => line.length === count)) return table(cells, 'lines');
  const beginWithWords = cells.every((line) => line.length > 1 && /^<mtext>[^<]*<\/mtext>$/.test(line[0]));
  return table(cells.map((line) => (beginWithWords ? [line[0], line.slice(1).join(gap)] : [line.join(gap)])), 'lines');
}

// The MathML of a block of plain lines, or undefined where it is none.
export function formula(block, names = []) {
  const lines = block.split('\n').filter((line) => line.trim()), paragraphs = block.trimEnd().split(/\n\s*\n/);
  if (lines.some((line) => /;\s*(\/\/|$)|[{}]|\/\/|\.\/run|\bgl[A-Z]/.test(line))) return undefined; // code, or a command
  try {
    const made = paragraphs.map((paragraph) => partOf(paragraph.split('\n'), names));
    if (made.every((one) => !one)) return undefined;
    return made.map((one, i) => `<math display="block"><semantics><mrow>${one ?? words(paragraphs[i])}</mrow><annotation encoding="text/plain">${escaped(paragraphs[i])}</annotation></semantics></math>`).join('\n');
  } catch (error) {
    if (error instanceof NoFormula) return undefined;
    throw error;
  }
}

const longest = 24; // letters of a formula among words that stays in one line

// The MathML of a formula among words, or undefined where it is none. A fraction is no higher than a line there, and a long formula may go
// on in the next line after a sign or between factors.
export function inWords(text) {
  try {
    const tokens = tokensOf(text, []);
    for (const token of tokens) token.isInWords = true;
    const { parts } = sequence(tokens, 0), lines = [[]];
    for (const part of parts) {
      lines.at(-1).push(part);
      if (text.length > longest && part !== parts.at(-1) && (part === thin || part.startsWith('<mo>')) && lines.at(-1).length > 1) lines.push([]);
    }
    const made = lines.map(row);
    if (made.some((line) => plain(line.replace(/<[^>]*>/g, '')).length > longest)) return undefined; // wider than a phone
    return made.map((line) => `<math>${line}</math>`).join('<wbr>');
  } catch (error) {
    if (error instanceof NoFormula) return undefined;
    throw error;
  }
}

// A lesson's HTML with its formulas so. `markdown` is its source, whose knobs may have hyphens.
export function formulasIn(html, markdown) {
  const names = new Set([...markdown.matchAll(/--([a-z]+(?:-[a-z]+)+)/g)].map(([, name]) => name));
  return html.replace(/<pre><code>(.*?)<\/code><\/pre>/gs, (all, block) => {
    const made = formula(plain(block), names);
    return made ? `<div class="formula" tabindex="0">${made}</div>` : all;
  });
}
