// What is drawn of a run: each state with its estimate and its reference or its error, each input, what is estimated of the plant.

/** The panels of `runs`, with the errors by decades where `logarithmic`. */
export function panels(answered, runs, logarithmic) {
  const { states, inputs } = answered;
  const follows = answered.follows && runs.some((run) => run.errors.length);
  const all = states.map((name, j) => state(answered, name, j, follows, logarithmic));
  if (!answered.follows && runs.some((run) => run.errors.length)) {
    all.push(...answered.chains.map((chain, j) => panel(`e${chain}`, (run) => run.errors[j] ?? [], logarithmic, { key: "tracking error" })));
  }
  all.push(...inputs.map((name, k) => panel(name, (run) => run.u[k], false, {
    held: true,
    bounds: [{ at: runs[0].u_max[k], name: "limit" }, { at: runs[0].u_min[k], name: "limit" }],
  })));
  if (runs.some((run) => run.disturbance.length)) {
    all.push(panel("d", (run) => run.disturbance, false, { key: "estimated disturbance" }));
  }
  return all.filter(({ of }) => runs.some((run) => of(run).length));
}

/** The sizes of the states of a run at the deadline, or of its tracking errors. */
export function atDeadline(answered, run) {
  const at = run.t.findLastIndex((t) => t <= run.end.t);
  const follows = answered.follows && run.errors.length > 0;
  const all = follows ? run.errors.map((one) => one[at]) : run.end.x;
  return { symbol: follows ? "e" : "x", follows, values: all.map((x) => Math.abs(x ?? NaN)) };
}

function panel(name, of, logarithmic, more = {}) {
  const bare = { key: "dotted: deadline", lines: () => [], bounds: [], held: false };
  return { ...bare, ...more, name: logarithmic ? `|${name}|` : name, of, logarithmic };
}

function state(answered, name, j, follows, logarithmic) {
  const estimates = (run) => {
    const values = run.estimates[j + 1 - (answered.first_estimated ?? 1)];
    return values?.length ? [{ name: `estimate of ${name}`, kind: "estimate", values }] : [];
  };
  const most = [{ at: answered.error[j], name: "error" }];
  const walls = answered.x_max[j] === null ? [] : [{ at: answered.x_max[j], name: "x_max" }, { at: -answered.x_max[j], name: "x_max" }];
  if (follows && logarithmic) {
    return panel(`${name} \u2212 r`, (run) => run.errors[j] ?? [], true, { key: "tracking error", bounds: most });
  }
  if (follows) {
    const reference = (run) => (run.errors[j] ? [{ name: "r", kind: "reference", values: run.x[j].map((x, i) => x - run.errors[j][i]) }] : []);
    return panel(name, (run) => run.x[j], false, { key: "dashed: r(t)", bounds: walls, lines: (run) => [...estimates(run), ...reference(run)] });
  }
  const key = answered.series.some((run) => run.t && estimates(run).length) ? "thin: estimate" : undefined;
  const bounds = logarithmic ? most.concat(walls.slice(0, 1)) : walls;
  return panel(name, (run) => run.x[j], logarithmic, { ...(key && { key }), bounds, lines: estimates });
}
