// Chebyshev series: rows of coefficients by degree, several functions side by side.

// The values of all functions at one u, by Clenshaw's recurrence.
export function values({ range: [low, high], rows }, u) {
  const x = (2 * u - low - high) / (high - low);
  const width = rows[0].length;
  let next = new Float64Array(width), after = new Float64Array(width);
  for (let k = rows.length - 1; k > 0; k--) {
    const row = rows[k];
    for (let i = 0; i < width; i++) after[i] = 2 * x * next[i] - after[i] + row[i];
    [next, after] = [after, next];
  }
  return Float64Array.from(rows[0], (c, i) => x * next[i] - after[i] + c);
}

// The derivative in u, as a series: c'_(k-1) = c'_(k+1) + 2k c_k, half of it for k = 1.
export function derivative({ range, rows }) {
  const [low, high] = range;
  const width = rows[0].length;
  const result = Array.from({ length: Math.max(rows.length - 1, 1) }, () => new Float64Array(width));
  for (let k = rows.length - 1; k > 0; k--) {
    for (let i = 0; i < width; i++) {
      result[k - 1][i] = (k + 1 < result.length ? result[k + 1][i] : 0) + 2 * k * rows[k][i];
    }
  }
  const slope = 2 / (high - low);
  result.forEach((row, k) => row.forEach((_, i) => { row[i] *= k === 0 ? slope / 2 : slope; }));
  return { range, rows: result };
}

// The series at t between those at Chebyshev nodes of the time domain, by the barycentric formula.
export function between(range, { instants, amplitudes, terms }, t) {
  const count = instants.length;
  let weights = instants.map((instant, k) => (k % 2 ? -1 : 1) * Math.sin(Math.PI * (k + 0.5) / count) / (t - instant));
  const hit = instants.indexOf(t);
  if (hit >= 0) weights = instants.map((_, k) => (k === hit ? 1 : 0));
  const total = weights.reduce((sum, weight) => sum + weight, 0);
  const width = amplitudes[0].length / terms;
  const rows = Array.from({ length: terms }, () => new Float64Array(width));
  amplitudes.forEach((flat, k) => {
    const weight = weights[k] / total;
    for (let row = 0; row < terms; row++) {
      for (let i = 0; i < width; i++) rows[row][i] += weight * flat[row * width + i];
    }
  });
  return { range, rows };
}
