// Questions to the server: the newest one counts, and only one is on its way.

// Facts for tests: every request the page made, in order.
export const requests = [];

export function address(path, { time, values, ...options }) {
  const query = new URLSearchParams(options);
  if (time !== null && time !== undefined) query.set("t", time);
  for (const [name, value] of Object.entries(values)) query.append("set", `${name}=${value}`);
  return `${path}?${query}`;
}

export async function ask(path, question) {
  const url = address(path, question);
  requests.push(url);
  const response = await fetch(url);
  const answer = await response.json();
  return { ok: response.ok, ...answer };
}

// The vertices of patches that the page cannot evaluate itself, by patch; `null` if they belong to another text.
export async function askVertices(question, { patches, grid, revision }) {
  if (patches.length === 0) return { ok: true, samples: new Map() };
  const url = address("/vertices", { ...question, patches: patches.join(","), grid });
  requests.push(url);
  const response = await fetch(url);
  if (!response.ok) return { ok: false, ...(await response.json()) };
  if (response.headers.get("trimline-revision") !== String(revision)) return null;
  const numbers = new Float32Array(await response.arrayBuffer());
  const size = numbers.length / patches.length;
  return { ok: true, samples: new Map(patches.map((patch, k) => [patch, numbers.subarray(k * size, (k + 1) * size)])) };
}

// Runs `work` for the newest call only, one at a time.
export function newestOnly(work) {
  let running = false, again = false;
  return async function run() {
    if (running) { again = true; return; }
    running = true;
    do {
      again = false;
      await work();
    } while (again);
    running = false;
  };
}

// A file the server made, kept under the name the server gave it.
export async function keep(question) {
  const url = address("/export", question);
  requests.push(url);
  const response = await fetch(url);
  if (!response.ok) return (await response.json()).findings;
  const name = /filename="([^"]+)"/.exec(response.headers.get("content-disposition") ?? "")?.[1] ?? "surface";
  save(await response.blob(), name);
  return [];
}

export function save(blob, name) {
  const link = Object.assign(document.createElement("a"), { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
