// A patch S(u, v, t) = Σ_j F_j(v, t) G_j(u): the F_j are a program, the G_j Chebyshev series.

import { run } from "./program.js";
import { between, derivative, values } from "./series.js";
import { Tables } from "./tables.js";

export class Separable extends Tables {
  // New numbers from the server; `motion` interpolates over time where the solution holds at one instant.
  set(data, cells, time) {
    super.set(data, cells);
    this.motion = null;
    const { range, coefficients } = data.form.amplitudes;
    this.take({ range, rows: coefficients }, data.time);
    this.setTime(this.knows(time) ? time : data.time);
  }

  take(series, time) {
    const slopes = derivative(series);
    this.orders = [series, slopes, derivative(slopes)];
    this.seriesTime = time;
    this.fillAmplitudes();
  }

  // Whether the surface at t can be drawn without the server.
  knows(t) {
    return this.knowsAllTimes || t === this.seriesTime;
  }

  get knowsAllTimes() {
    return !this.data.form.is_instant || this.motion !== null;
  }

  get count() {
    return this.data.form.count;
  }

  amplitudes(u) {
    return this.orders.map((series) => values(series, u));
  }

  basis(v) {
    return run(this.data.form.basis, this.data.symbols, v, this.time);
  }

  setTime(t) {
    if (this.data.form.is_instant && t !== this.seriesTime && this.motion) this.take(between(this.orders[0].range, this.motion, t), t);
    super.setTime(t);
    this.fillBasis();
  }
}
