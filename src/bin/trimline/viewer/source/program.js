// Straight-line programs over (u, v, t), run for a whole row of points at once: each operation is one loop.
//
// The program and its operations are those of the library; functions come from the platform here, which may differ
// from the library's in the last digits.

const FUNCTIONS = {
  neg: (a) => -a, add: (a, b) => a + b, sub: (a, b) => a - b, mul: (a, b) => a * b, div: (a, b) => a / b,
  sqrt: Math.sqrt, sin: Math.sin, cos: Math.cos, tan: Math.tan, cot: (a) => 1 / Math.tan(a), sec: (a) => 1 / Math.cos(a),
  csc: (a) => 1 / Math.sin(a), asin: Math.asin, acos: Math.acos, atan: Math.atan, atan2: Math.atan2, sinh: Math.sinh,
  cosh: Math.cosh, tanh: Math.tanh, asinh: Math.asinh, acosh: Math.acosh, atanh: Math.atanh, exp: Math.exp, ln: Math.log,
  log10: Math.log10, cbrt: Math.cbrt, abs: Math.abs, sign: Math.sign, floor: Math.floor, min: Math.min, max: Math.max,
  pow: Math.pow,
};

// A derivative of a piecewise polynomial: rows and columns of Taylor coefficients, by Horner's rule in each.
function piecewise({ orders, axes: [first, second], coefficients }, x, y) {
  const [rowAt, columnAt] = [locate(first, x), locate(second, y)];
  if (!rowAt || !columnAt) return NaN;
  const [row, dx] = rowAt, [column, dy] = columnAt;
  const powers = second.degree + 1, width = powers * (second.breaks.length - 1);
  let sum = 0;
  for (let k = first.degree; k >= orders[0]; k--) {
    const start = (row * (first.degree + 1) + k) * width + column * powers;
    let inner = 0;
    for (let l = second.degree; l >= orders[1]; l--) inner = inner * dy + coefficients[start + l] * falling(l, orders[1]);
    sum = sum * dx + inner * falling(k, orders[0]);
  }
  return sum;
}

// The piece at x and how far into it.
function locate({ breaks, periodic }, x) {
  const [low, high] = [breaks[0], breaks[breaks.length - 1]];
  if (periodic) x = Math.min(Math.max(x - Math.floor((x - low) / (high - low)) * (high - low), low), high);
  const slack = 1e-9 * (high - low);
  if (!(x >= low - slack && x <= high + slack)) return null;
  let [below, above] = [0, breaks.length - 1];
  while (above - below > 1) {
    const middle = (below + above) >> 1;
    if (breaks[middle] <= x) below = middle; else above = middle;
  }
  return [below, x - breaks[below]];
}

function falling(power, order) {
  let product = 1;
  for (let taken = 0; taken < order; taken++) product *= power - taken;
  return product;
}

// Values of every output at each v, and u where the program is of both: an array of rows.
export function run(program, symbols, v, t, u = null) {
  const rows = [];
  for (const [name, a, b, index] of program.ops) {
    const row = new Float64Array(v.length);
    if (name === "const") row.fill(a);
    else if (name === "symbol") row.fill(symbols[a]);
    else if (name === "t") row.fill(t);
    else if (name === "v") row.set(v);
    else if (name === "u" && u) row.set(u);
    else if (name === "spline") {
      const spline = program.splines[index];
      for (let i = 0; i < row.length; i++) row[i] = piecewise(spline, rows[a][i], b === null ? 0 : rows[b][i]);
    } else {
      const apply = FUNCTIONS[name];
      if (!apply) throw new Error(`the page does not know the function ${name}`);
      const [x, y] = [rows[a], rows[b]];
      if (y) for (let i = 0; i < row.length; i++) row[i] = apply(x[i], y[i]);
      else for (let i = 0; i < row.length; i++) row[i] = apply(x[i]);
    }
    rows.push(row);
  }
  return program.outputs.map((id) => rows[id]);
}

// `count` equal steps from one end of a range to the other, both included.
export function evenly([low, high], cells) {
  return Float64Array.from({ length: cells + 1 }, (_, i) => low * (1 - i / cells) + high * (i / cells));
}
