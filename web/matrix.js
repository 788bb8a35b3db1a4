// What a matrix that is shown is made of, in words: which coordinates it takes to which, of which two others it is the product, and what
// each entry does, with its present values.

export const number = (value) => (value === null ? '-' : String(Number(value.toPrecision(6))));

const axes = ['x', 'y', 'z', 'w'];

// "viewFromModel" -> ["view", "model"]; none where it is not such a name.
function between(name) {
  const [, to, from] = name.match(/^([a-z]\w*?)From([A-Z]\w*)$/) ?? [];
  return to && [to, from[0].toLowerCase() + from.slice(1)];
}

const productOf = (one, other) => one.map((row) => axes.map((axis, column) => row.reduce((sum, value, k) => sum + value * other[k][column], 0)));
const isNear = (one, other) => {
  const largest = Math.max(...one.flat().map(Math.abs));
  return one.every((row, i) => row.every((value, j) => Math.abs(value - other[i][j]) <= 1e-6 * largest)); // the demo may have rounded to float
};

// The names of the two others that it is the product of: "aFromC" of "aFromB" and "bFromC", where their numbers say so, too.
function factorsOf(name, matrices) {
  const ends = between(name);
  if (!ends) return undefined;
  for (const left of Object.keys(matrices)) {
    const one = between(left);
    if (left === name || !one || one[0] !== ends[0]) continue;
    for (const right of Object.keys(matrices)) {
      const other = between(right);
      if (right === name || !other || other[0] !== one[1] || other[1] !== ends[1]) continue;
      if (isNear(matrices[name], productOf(matrices[left], matrices[right]))) return [left, right];
    }
  }
  return undefined;
}

// What a projection's rows say of the view: where its edges are, at distance 1 of a perspective one. (Row by row, of a matrix of which
// each row has but its own axis, and z or the constant.)
function viewOf(rows, row, to) {
  const isPerspective = rows[3].join() === '0,0,-1,0', isParallel = rows[3].join() === '0,0,0,1';
  if (to !== 'clip' || !(isPerspective || isParallel) || row > 2 || !rows[row][row]) return '';
  const [scale, z, constant] = [rows[row][row], rows[row][2], rows[row][3]];
  if (rows[row].some((value, column) => value && column !== row && column !== (row < 2 && isPerspective ? 2 : 3))) return '';
  const at = (edge) => number(row < 2 ? (isPerspective ? (edge + z) / scale : (edge - constant) / scale) : isPerspective ? constant / (scale + edge) : (constant - edge) / scale);
  const ends = { axis: axes[row], low: at(-1), high: at(1) };
  if (row === 2) return word('matrixDepth', ends);
  if (!isPerspective) return word('matrixWide', ends);
  const angle = ((Math.atan((1 + z) / scale) + Math.atan((1 - z) / scale)) * 180) / Math.PI;
  return word('matrixAngle', { ...ends, angle: number(angle) });
}

function entryOf(rows, row, column, [to, from]) {
  const value = number(rows[row][column]), given = { value, to, from, row: axes[row], column: axes[column] };
  if (row === 3) return rows[3].join() === '0,0,0,1' ? word('matrixLast', given) : word('matrixAdds', given);
  if (rows[3].join() !== '0,0,0,1') return word(column === 3 ? 'matrixAlways' : 'matrixAdds', given);
  return word(column === 3 ? 'matrixOrigin' : 'matrixAxis', given);
}

// { product, takes, entry(row, column) } of one of the matrices, each by its name: "viewFromCar = viewFromWorld * worldFromCar" or "";
// what it does; and a line or more for each entry.
export function madeOf(name, matrices) {
  const rows = matrices[name], factors = factorsOf(name, matrices), ends = between(name) ?? ['', ''];
  const sum = (row, column) => axes.map((axis, k) => `${number(matrices[factors[0]][row][k])} * ${number(matrices[factors[1]][k][column])}`).join(' + ');
  return {
    product: factors ? `${name} = ${factors.join(' * ')}` : '',
    takes: ends[0] && word('matrixTakes', { to: ends[0], from: ends[1] }),
    entry: (row, column) => [
      ends[0] && entryOf(rows, row, column, ends),
      viewOf(rows, row, ends[0]),
      factors && word('matrixSum', { row: row + 1, column: column + 1, left: factors[0], right: factors[1], sum: sum(row, column), value: number(rows[row][column]) }),
    ].filter(Boolean).join('\n'),
  };
}
