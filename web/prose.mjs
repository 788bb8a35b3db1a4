// The formulas in a lesson's running words as MathML. In the source they are words like others, "with w = 1 it is d^2/(n 2^b)": a run of
// numbers, names and signs that has a relation, a power, a lower index or a function in it is one. What formula.mjs does not know stays
// as it is written.
//
// A word is a name where it has one letter, an index, or is a Greek letter's or a function's name, and where a sign touches it, as in
// 1/near, or it stands alone beside a relation, as in "near = 1.6".
import { greek, inWords } from './formula.mjs';

const functions = /^(?:abs|acos|asin|atan|cos|cross|det|diag|dot|exp|length|log|max|min|mod|pow|round|sin|sqrt|tan)$/;
const letters = Object.keys(greek).join('|');
const name = new RegExp(`^(?:(?:[A-Za-z]|${letters})(?:\\d+|_\\w+)?'?)$`), indexed = new RegExp(`^(?:[A-Za-z]|${letters})_\\w+'?$`);
// (A possessive is a word. A bound of a length begins before a name, and ends behind one; so does one of an inner product.)
const pattern = /(?<space>\s+)|(?<number>\d+(?:\.\d+)?(?:e-?\d+)?°?(?!\w\w|[\d%]))|(?<word>\p{L}{2,}\w*(?:-\p{L}+)+|\p{L}[\p{L}\w]*(?:'s\b|')?)|(?<open>\(|(?<![\w)|])\|(?=[\w(-])|<(?=[\w]))|(?<close>\)|(?<=[\w)'])\||(?<=[\w)'])>)|(?<sign><=|>=|[-=<>+*/^·]|(?<=[A-Za-z)])\.(?=[A-Za-z])|(?<= )\.(?= ))|(?<comma>,)|(?<other>[^])/gu;
const bounds = { ')': '(', '|': '|', '>': '<' };
const isRelation = (piece) => /^(?:<=|>=|[=<>])$/.test(piece?.text);
const plainWords = new Set('a an and are as at be both but by for from in is it its no not of on or so than that the then there they this to two was what where which with'.split(' '));

// Which words are names: pieces get `isName`.
function tell(pieces) {
  const beyond = (i, step) => {
    const at = pieces[i + step]?.kind === 'space' ? i + 2 * step : i + step;
    return { piece: pieces[at], touches: at === i + step };
  };
  const isProse = (piece) => piece?.kind === 'word' && !name.test(piece.text) && !functions.test(piece.text);
  pieces.forEach((piece, i) => {
    if (piece.kind !== 'word') return;
    const before = beyond(i, -1), after = beyond(i, 1);
    const spaced = (at) => pieces[at - 1]?.kind === 'space' && pieces[at + 1]?.kind === 'space';
    const joins = ({ piece: other, touches }, beyondThis) => other?.kind === 'sign' && (touches ? !isRelation(other) : other.text === '*' || (other.text === '+' && spaced(pieces.indexOf(other)) && !isProse(beyondThis.piece)));
    if (functions.test(piece.text)) piece.isName = after.piece?.kind === 'open' ? after.touches : ['number', 'word'].includes(after.piece?.kind) && !isProse(after.piece);
    else if (/^[aAI]$/.test(piece.text)) piece.isName = !(after.piece?.kind === 'word' && !after.touches && isProse(after.piece));
    else if (name.test(piece.text)) piece.isName = true;
    else if (plainWords.has(piece.text.toLowerCase()) || /-|'s$|[^\w']/.test(piece.text)) piece.isName = false;
    else piece.isName = joins(before, after) || joins(after, before) || (isRelation(after.piece) && !isProse(before.piece)) || (isRelation(before.piece) && !isProse(after.piece));
  });
}

// The runs of a text that are formulas, [{ from, to }].
export function formulasOf(text) {
  const pieces = [...text.matchAll(pattern)].map(({ 0: one, index, groups }) => ({ text: one, from: index, to: index + one.length, kind: Object.keys(groups).find((kind) => groups[kind] !== undefined) }));
  tell(pieces);
  const runs = [];
  let run = [];
  const end = () => {
    runs.push(run);
    run = [];
  };
  // Bounds that nothing closes or opens in a run are the sentence's.
  let depth = 0;
  for (const piece of pieces) {
    const belongs = piece.kind === 'word' ? piece.isName : piece.kind === 'comma' ? depth > 0 : piece.kind !== 'other';
    if (!belongs) end();
    else run.push(piece);
    depth = belongs ? depth + (piece.kind === 'open') - (piece.kind === 'close' && depth > 0) : 0;
  }
  end();
  return runs.flatMap(balanced).map(trimmed).filter(isFormula).map((all) => ({ from: all[0].from, to: all.at(-1).to }));
}
function balanced(run) {
  const open = [], alone = new Set();
  run.forEach(({ kind, text }, i) => {
    if (kind === 'open') open.push(i);
    if (kind === 'close' && run[open.pop()]?.text !== bounds[text]) alone.add(i);
  });
  for (const one of open) alone.add(one);
  const parts = [[]];
  run.forEach((piece, i) => (alone.has(i) ? parts.push([]) : parts.at(-1).push(piece)));
  // A list's comma is the sentence's, too, once its bounds are.
  return parts.flatMap((part) => {
    const split = [[]];
    let depth = 0;
    for (const piece of part) {
      depth += (piece.kind === 'open') - (piece.kind === 'close');
      if (piece.kind === 'comma' && !depth) split.push([]);
      else split.at(-1).push(piece);
    }
    return split;
  });
}
// Without the sentence's spaces around it, and units; nothing where it goes on beyond what is known.
function trimmed(run) {
  let from = 0, to = run.length;
  const operand = (piece) => ['number', 'word', 'open', 'close'].includes(piece?.kind), goesOn = (piece) => piece?.kind === 'sign' && !isRelation(piece);
  while (from < to && !operand(run[from]) && !(/^[-+]$/.test(run[from].text) && operand(run[from + 1]))) if (goesOn(run[from++])) return [];
  while (from < to && !operand(run[to - 1])) if (goesOn(run[--to])) return [];
  if (functions.test(run[to - 1]?.text)) return [];
  const [relation, space, number, between, unit] = run.slice(to - 5, to);
  if (isRelation(relation) && space?.kind === 'space' && number?.kind === 'number' && between?.kind === 'space' && /^[ms]$/.test(unit?.text)) to -= 2;
  return run.slice(from, to);
}
function isFormula(run) {
  return run.some((piece, i) =>
    (isRelation(piece) && i > 0 && i < run.length - 1) || piece.text === '^' || (piece.kind === 'word' && (indexed.test(piece.text) || (functions.test(piece.text) && run[i + 1]?.kind === 'open'))));
}

const spelled = { '&lt;': '<', '&gt;': '>', '&amp;': '&', '&quot;': '"' };
// A text with its formulas so: HTML, in and out, without tags.
function written(html) {
  const text = html.replace(/&(?:lt|gt|amp|quot);/g, (one) => spelled[one]).replace(/²/g, '^2').replace(/³/g, '^3');
  const escaped = (words) => words.replace(/&/g, '&amp;').replace(/</g, '&lt;').replace(/>/g, '&gt;').replace(/"/g, '&quot;');
  let at = 0, made = '';
  for (const { from, to } of formulasOf(text)) {
    const math = inWords(text.slice(from, to).replace(/\s+/g, ' '));
    if (!math) continue;
    made += escaped(text.slice(at, from)) + math;
    at = to;
  }
  return at ? made + escaped(text.slice(at)) : html;
}

// A lesson's HTML with the formulas of its words so; code, headings (also of columns, which screen readers want as words) and what is
// MathML already stay.
export const wordsIn = (html) =>
  html.replace(/<(pre|code|math|svg|script|h[1-6]|th|figcaption)\b.*?<\/\1>|<!--.*?-->|<[^>]*>|[^<]+/gs, (part) => (part.startsWith('<') ? part : written(part)));
