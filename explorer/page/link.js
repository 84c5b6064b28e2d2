// The whole state of the page in the fragment of its address.

/** Most mappings that are compared; the engine runs no more either. */
const MOST = 20;

/** The first mappings of a list, each once, and how many are left out. */
export function bounded(mappings) {
  const all = [...new Set(mappings)];
  return { overlays: all.slice(0, MOST), leftOut: Math.max(all.length - MOST, 0) };
}

/** What is said of mappings that are left out. */
export function leftOut(count) {
  return count ? `At most ${MOST} mappings are compared; ${count} left out` : "";
}

/** What the address holds; null without a design. */
export function read() {
  const held = new URLSearchParams(location.hash.slice(1));
  if (!held.has("design")) return null;
  return {
    design: held.get("design"),
    language: held.get("lang") ?? "c",
    x0: held.get("x0") ?? "",
    seed: Number(held.get("seed") ?? 0),
    log: held.get("scale") !== "linear",
    trial: trial(held),
    ...bounded(held.getAll("with")),
  };
}

/** What a run tries: `try=force:2`, `symbol=drag:0.3`. */
function trial(held) {
  const pairs = (name) => held.getAll(name).map((one) => one.split(":")).filter(([key, value]) => key && Number.isFinite(Number(value)));
  const numbers = (name) => Object.fromEntries(pairs(name).map(([key, value]) => [key, Number(value)]));
  return { ...numbers("try"), symbols: numbers("symbol") };
}

/** Writes the state to the address, without a step of history. */
export function write(state) {
  const held = new URLSearchParams({ design: state.design, lang: state.language });
  if (state.x0) held.set("x0", state.x0);
  if (state.seed) held.set("seed", state.seed);
  if (!state.log) held.set("scale", "linear");
  const { symbols, ...others } = state.trial;
  for (const [key, value] of Object.entries(others)) held.append("try", `${key}:${value}`);
  for (const [key, value] of Object.entries(symbols)) held.append("symbol", `${key}:${value}`);
  for (const mapping of state.overlays) held.append("with", mapping);
  history.replaceState(null, "", `#${held}`);
}
