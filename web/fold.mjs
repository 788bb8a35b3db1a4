// How words are compared in a search: without accents, in small letters, and in one of the two spellings of English. (The page has
// the same function: search.js is written from it.)
export function folded(words) {
  const spelling = { colour: 'color', centre: 'center', grey: 'gray', behaviour: 'behavior', neighbour: 'neighbor', modelling: 'modeling', labelled: 'labeled', metre: 'meter' };
  const plain = words.normalize('NFD').replace(/\p{M}/gu, '').toLowerCase();
  return plain.replace(new RegExp(Object.keys(spelling).join('|'), 'g'), (one) => spelling[one]).replace(/is(e|ing|ation)(?![a-z])/g, 'iz$1');
}
