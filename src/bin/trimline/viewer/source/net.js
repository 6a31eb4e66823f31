// A B-spline surface Σ_ij N_i(u) M_j(v) P_ij as such a sum: its functions of v are the M_j, those of u the Σ_i N_i P_ij.

import { Tables } from "./tables.js";

export class Net extends Tables {
  set(data, cells, time) {
    super.set(data, cells);
    this.setTime(this.knows(time) ? time : data.time);
    this.fillAmplitudes();
    this.fillBasis();
  }

  knows(t) {
    return this.knowsAllTimes || t === this.data.time;
  }

  get knowsAllTimes() {
    return !this.data.form.is_instant;
  }

  get count() {
    return this.pointsOf(1);
  }

  // Control points in u (0) or in v (1).
  pointsOf(axis) {
    const { knots, degrees } = this.data.form;
    return knots[axis].length - degrees[axis] - 1;
  }

  bsplines(axis, x) {
    return bsplines(this.data.form.knots[axis], this.data.form.degrees[axis], x);
  }

  amplitudes(u) {
    const { points } = this.data.form;
    const { first, orders } = this.bsplines(0, u);
    return orders.map((values) => {
      const g = new Float64Array(3 * this.count);
      values.forEach((value, a) => {
        for (let j = 0; j < this.count; j++) {
          const point = points[(first + a) * this.count + j];
          for (let k = 0; k < 3; k++) g[3 * j + k] += value * point[k];
        }
      });
      return g;
    });
  }

  basis(v) {
    const rows = Array.from({ length: 3 * this.count }, () => new Float64Array(v.length));
    v.forEach((x, column) => {
      const { first, orders } = this.bsplines(1, x);
      orders.forEach((values, order) => values.forEach((value, b) => { rows[order * this.count + first + b][column] = value; }));
    });
    return rows;
  }
}

// The B-splines that are not zero at x, from number `first` on: their values, first derivatives and second, by
// de Boor's recurrence.
function bsplines(knots, degree, x) {
  let k = degree;
  while (k + 2 + degree < knots.length && x >= knots[k + 1]) k += 1;
  let orders = [[1], [0], [0]];
  for (let j = 1; j <= degree; j++) {
    const [n, n_x] = orders;
    const next = [[], [], []];
    for (let r = 0; r <= j; r++) {
      const share = (values, at) => (at >= 0 && at < j ? values[at] / (knots[k + 1 + at] - knots[k + 1 - j + at]) : 0);
      const [a, b] = [share(n, r - 1), share(n, r)];
      next[0].push((r > 0 ? (x - knots[k - j + r]) * a : 0) + (r < j ? (knots[k + 1 + r] - x) * b : 0));
      next[1].push(j * (a - b));
      next[2].push(j * (share(n_x, r - 1) - share(n_x, r)));
    }
    orders = next;
  }
  return { first: k - degree, orders };
}
