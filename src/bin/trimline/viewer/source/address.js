// The state of the view in the page's address, behind the #: a reload or a link shows the same picture.

export function read() {
  const query = new URLSearchParams(location.hash.slice(1));
  const values = {};
  for (const change of query.getAll("set")) {
    const at = change.indexOf("=");
    if (at > 0) values[change.slice(0, at)] = change.slice(at + 1);
  }
  const numbers = (text, count) => {
    const found = (text ?? "").split(",").map(Number);
    return found.length === count && found.every(Number.isFinite) ? found : null;
  };
  return {
    time: query.has("t") && Number.isFinite(Number(query.get("t"))) ? Number(query.get("t")) : null,
    shade: query.get("shade"),
    grid: query.get("grid"),
    off: (query.get("off") ?? "").split(",").filter(Boolean),
    lines: query.get("lines") === "1",
    camera: numbers(query.get("camera"), 6),
    values,
  };
}

let later = 0;

// Writes soon: browsers refuse an address that changes with every frame.
export function write(state) {
  clearTimeout(later);
  later = setTimeout(() => {
    const query = new URLSearchParams();
    if (state.time !== null) query.set("t", Number(state.time.toPrecision(6)));
    query.set("shade", state.shade);
    query.set("grid", state.grid);
    if (state.lines) query.set("lines", "1");
    if (state.off.length) query.set("off", state.off.join(","));
    if (state.camera) query.set("camera", state.camera.join(","));
    for (const [name, value] of Object.entries(state.values)) query.append("set", `${name}=${value}`);
    history.replaceState(null, "", `#${query}`);
  }, 150);
}
