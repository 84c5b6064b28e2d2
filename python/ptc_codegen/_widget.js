// Sliders of a design and its card. What is shown is computed in Python.

const STEPS = 400;

/** The value of a slider, with three digits. */
function valueAt({ low, high, wide, whole }, step) {
  const part = step / STEPS;
  const value = wide ? low * (high / low) ** part : low + (high - low) * part;
  return whole ? Math.round(value) : Number(value.toPrecision(3));
}

function stepOf({ low, high, wide }, value) {
  const part = wide ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low);
  return Math.round(STEPS * part);
}

function row(knob, changed) {
  const label = document.createElement("label");
  const range = document.createElement("input");
  const shown = document.createElement("output");
  label.textContent = knob.key;
  Object.assign(range, { type: "range", min: 0, max: STEPS, value: stepOf(knob, knob.value) });
  range.setAttribute("aria-label", knob.key);
  shown.textContent = knob.value;
  range.addEventListener("input", () => {
    const value = valueAt(knob, Number(range.value));
    shown.textContent = value;
    changed(knob.key, value);
  });
  label.append(range, shown);
  return label;
}

function render({ model, el }) {
  const values = { ...model.get("asked").values };
  const sliders = document.createElement("div");
  const card = document.createElement("div");
  sliders.className = "ptc-sliders";
  let due = false;

  // One request at a time: a slider moves faster than a loop is checked.
  function send() {
    const { number } = model.get("asked");
    const busy = model.get("answered") < number;
    el.classList.toggle("ptc-busy", busy);
    if (busy || !due) return;
    due = false;
    model.set("asked", { number: number + 1, values: { ...values } });
    model.save_changes();
    el.classList.add("ptc-busy");
  }

  function changed(key, value) {
    values[key] = value;
    due = true;
    send();
  }

  const show = () => {
    card.innerHTML = model.get("html");
  };
  sliders.append(...model.get("knobs").map((knob) => row(knob, changed)));
  el.append(sliders, card);
  model.on("change:html", show);
  model.on("change:answered", send);
  show();
  return () => {
    model.off("change:html", show);
    model.off("change:answered", send);
  };
}

export default { render };
