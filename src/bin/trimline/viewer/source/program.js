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

// Values of every output at each v, and u where the program is of both: an array of rows.
export function run(program, symbols, v, t, u = null) {
  const rows = [];
  for (const [name, a, b] of program.ops) {
    const row = new Float64Array(v.length);
    if (name === "const") row.fill(a);
    else if (name === "symbol") row.fill(symbols[a]);
    else if (name === "t") row.fill(t);
    else if (name === "v") row.set(v);
    else if (name === "u" && u) row.set(u);
    else {
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
