// The texts beside the picture: values with sliders, report, mathematics, and what is wrong with the spec.

import katex from "katex";

const element = (name, properties = {}, ...children) => {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
};

export const byId = (id) => document.getElementById(id);

// What a slider offers: the param's own range, or for a coefficient of the equation some room around its value.
function range({ range: stated, is_coefficient, value }) {
  if (stated) return stated;
  return is_coefficient ? [Math.min(0, 4 * value), Math.max(4, 4 * value)] : null;
}

// Builds sliders when the names change; otherwise moves them, but not the one in the user's hand.
export function showValues(parameters, onChange) {
  const host = byId("values");
  const names = JSON.stringify(parameters.map(({ name, range: stated }) => [name, stated]));
  if (host.dataset.names !== names) {
    host.dataset.names = names;
    host.replaceChildren(...parameters.map((parameter) => {
      const bounds = range(parameter);
      const number = element("input", { type: "text", title: "a number or an expression in params", spellcheck: false });
      number.addEventListener("change", () => onChange(parameter.name, number.value));
      const row = element("div", { className: "value" }, element("span", { textContent: parameter.label }));
      row.dataset.name = parameter.name;
      if (bounds) {
        const slider = element("input", { type: "range", min: bounds[0], max: bounds[1], step: "any" });
        slider.addEventListener("input", () => onChange(parameter.name, slider.value));
        row.append(slider);
      }
      row.append(number);
      return row;
    }));
  }
  parameters.forEach(({ value }, index) => {
    for (const input of host.children[index].querySelectorAll("input")) {
      if (input !== document.activeElement || input.type === "text") input.value = Number(value.toPrecision(12));
    }
  });
}

// How two surfaces meet, in a row of the report.
const contact = ({ gap, angle_degrees: angle }) =>
  `gap ${gap.toExponential(1)}, ${angle === null ? "no normals to compare" : `angle ${angle.toExponential(1)}°`}`;

const number = (value) => (value === null ? "unbounded" : Number(value.toPrecision(3)).toString());

// What is said of a part, by its kind.
const KINDS = {
  copy: ({ report }) => [["copy of", report.original]],
  net: ({ report }) => [
    ["method", report.method], ["control points", report.control_points.join(" x ")],
    ["amplification", report.amplification.map((value) => Number(value.toPrecision(3))).join(" in u, ") + " in v"],
  ],
  patch: ({ time, form, report }) => [
    ["method", report.method],
    ["holds", form.kind === "sampled" || form.is_instant ? `at t = ${Number(time.toPrecision(5))}` : "for every t"],
    ...(report.basis_size === 0 ? [["terms", report.modes]] : [
      ["basis functions", report.closure_size ? `${report.basis_size}, ${report.closure_size} with closure` : report.basis_size],
      ["terms each", report.modes],
    ]),
    ["boundary error", number(report.boundary_error)], ["PDE residual", number(report.pde_residual)],
    report.amplification === null ? ["rank", `${report.rank} of ${report.unknowns}, condition ${number(report.condition)}`]
      : ["amplification", number(report.amplification)],
    ["solved in", `${report.milliseconds.toFixed(1)} ms`],
  ],
};

export function showReport({ patches, seams, time: measured }) {
  const rows = patches.flatMap((patch) => [["patch", patch.name], ...KINDS[patch.report.kind](patch)]);
  const place = ({ patch, u, v }) => `${patch} at ${u === undefined ? `v = ${number(v)}` : `u = ${number(u)}`}`;
  const met = [
    ...patches.flatMap(({ name, joins }) => joins.map((join) => [`${place({ patch: name, u: join.u })} joins ${join.surface}`, contact(join)])),
    ...seams.map((seam) => [`${place(seam.between[0])} meets ${place(seam.between[1])}`, contact(seam)]),
  ];
  // Measured by the server with the solution; time may have moved on since without asking it.
  rows.push(["measured at", `t = ${Number(measured.toPrecision(5))}`], ...met);
  byId("report").replaceChildren(...rows.map(([what, value]) =>
    element("tr", {}, element("td", { textContent: what }), element("td", { textContent: value }))));
}

// MathML, which the browser draws without fonts or styles of ours.
function formula(text) {
  const host = element("div");
  katex.render(text, host, { output: "mathml", displayMode: false, throwOnError: false, maxExpand: 1000 });
  return host;
}

export function showMathematics(patches) {
  byId("equation").replaceChildren(...patches.flatMap(({ mathematics }) => mathematics.map(formula)));
  byId("basis").replaceChildren(...patches.flatMap(({ functions }) =>
    functions.map((text, j) => formula(`F_{${j + 1}} = ${text}`))));
}

function snippet({ text, line, column, end }, marker) {
  const characters = Array.from(text);
  const before = characters.slice(0, column - 1).map((c) => (c === "\t" ? "\t" : " ")).join("");
  const gutter = String(line);
  const caret = "^".repeat(Math.max(Math.min(end, characters.length + 1) - column, 1));
  return `${gutter} | ${text}\n${" ".repeat(gutter.length)} | ${before}${caret} ${marker}`.trimEnd();
}

export function showFindings(findings) {
  const host = byId("findings");
  host.hidden = findings.length === 0;
  host.replaceChildren(...findings.map(({ severity, code, message, marker, source, place, labels, hints }) => {
    const finding = element("div", { className: `finding ${severity}` });
    finding.append(element("strong", { textContent: code ? `${severity}[${code}]` : severity }), `: ${message}`);
    if (place) {
      finding.append(element("p", { textContent: `${source}:${place.line}:${place.column}` }));
      finding.append(element("pre", { textContent: snippet(place, marker) }));
    }
    labels.forEach(([what, at]) => finding.append(element("pre", { textContent: snippet(at, what) })));
    hints.forEach((hint) => finding.append(element("p", { textContent: `hint: ${hint}` })));
    return finding;
  }));
}

export function showLegend(legend) {
  const host = byId("legend");
  host.hidden = legend === null;
  if (!legend) return;
  host.classList.toggle("rising", legend.isRising);
  byId("legend-low").textContent = legend.low;
  byId("legend-high").textContent = legend.high;
  byId("legend-text").textContent = legend.text;
}

// A line of choices; `choose` is told which.
export function choices(select, names, chosen, choose) {
  select.replaceChildren(...names.map((name) => element("option", { value: name, textContent: name })));
  select.value = names.includes(chosen) ? chosen : names[0];
  select.addEventListener("change", () => choose(select.value));
}

export function toggles(host, names, isOn, toggle) {
  host.replaceChildren(...names.map((name) => {
    const box = element("input", { type: "checkbox", checked: isOn(name), name });
    box.addEventListener("change", () => toggle(name, box.checked));
    return element("label", {}, box, ` ${name}`);
  }));
}

export function buttons(host, named) {
  host.replaceChildren(...named.map(([name, act]) => {
    const button = element("button", { textContent: name });
    button.addEventListener("click", act);
    return button;
  }));
}
