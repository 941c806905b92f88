// SPDX-License-Identifier: BSD-3-Clause
// What the reader does with the view, and what it tells: colour bars, values under the pointer.
const MOST_SWATCHES = 12;

function made(tag, className, text = "") {
  const element = document.createElement(tag);
  element.className = className;
  element.textContent = text;
  return element;
}

function colourText(bytes, number) {
  return `rgb(${bytes.slice(4 * number, 4 * number + 3).join(",")})`;
}

// Whole multiples of 1, 2 or 5 times a power of ten from low to high, about five of them.
function ticks(low, high) {
  const power = 10 ** Math.floor(Math.log10((high - low) / 5));
  const step = [1, 2, 5, 10].map((n) => n * power).find((n) => (high - low) / n <= 5);
  const first = Math.ceil(low / step - 1e-9), last = Math.floor(high / step + 1e-9);
  return Array.from({ length: last - first + 1 },
                    (_, i) => Number(((first + i) * step).toPrecision(12)));
}

function showBar(bar, field) {
  bar.replaceChildren();
  if (!field) return;
  const table = tableOf(field), bytes = table.bytes, label = made("div", "bar-label", field.label);
  bar.append(label);
  if (field.names.length) {
    for (const [number, name] of field.names.slice(0, MOST_SWATCHES).entries()) {
      const swatch = made("span", "swatch", name);
      swatch.style.setProperty("--colour", colourText(bytes, number % table.size));
      bar.append(swatch);
    }
    const more = field.names.length - MOST_SWATCHES;
    if (more > 0) bar.append(made("span", "", `and ${more} more`));
    return;
  }
  const stops = Array.from({ length: 33 }, (_, i) => colourText(bytes, Math.round(i * 255 / 32)));
  const strip = made("div", "strip"), range = rangeOf(field);
  const [low, high] = range.ends.map((end) => end / field.factor);
  strip.style.background = `linear-gradient(to right, ${stops.join(",")})`;
  label.textContent += field.unit ? ` (${field.unit})` : "";
  strip.classList.toggle("below", ["min", "both"].includes(range.beyond));
  strip.classList.toggle("above", ["max", "both"].includes(range.beyond));
  strip.style.setProperty("--low", stops[0]);
  strip.style.setProperty("--high", stops[32]);
  for (const value of ticks(low, high)) {
    const tick = made("span", "tick", numberText(value, 12));
    tick.style.left = `${100 * (value - low) / (high - low)}%`;
    strip.append(tick);
  }
  bar.append(strip);
}

function showBars() {
  for (const kind of ["rock", "cracks"]) showBar(byId(`view-${kind}-bar`), state[kind]);
}

// The values of a field at the time that is shown, once they are unpacked.
function valuesNow(field) {
  return readyArrays.get(about.frames[state.frame].arrays[field.values]);
}

function rockText(found) {
  const field = state.rock, values = valuesNow(field);
  const corners = [0, 1, 2].map((k) => 3 * found.triangle + k);
  const mixed = (of) => corners.reduce((sum, i, k) => sum + found.shares[k] * of(i), 0);
  const ofCorner = (i) => values[model.numberOf(field, values, i)];
  const value = field.atPoints ? mixed(ofCorner) : values[found.triangle];
  const at = [0, 1].map((axis) => mixed((i) => model.places[2 * i + axis]) + about.origin[axis]);
  return [Number.isNaN(value) ? "Rigid body" : `${field.label}: ${valueText(field, value)}`,
          `x = ${numberText(at[0], 6)} m, y = ${numberText(at[1], 6)} m`];
}

// What is known of a segment; a dry one has no values of fluid.
function crackText(segment) {
  const lines = ["On a crack"];
  for (const field of about.cracks) {
    const values = valuesNow(field), i = field.atPoints ? 2 * segment : segment;
    if (!values || Number.isNaN(values[i])) continue;
    const value = field.atPoints ? (values[i] + values[i + 1]) / 2 : values[i];
    lines.push(`${field.label}: ${valueText(field, value)}`);
  }
  return lines;
}

let pointed = null;  // where the pointer was last over the model

function showTip(event) {
  pointed = event;
  const place = placeAt(event.clientX, event.clientY);
  const segment = model.segments && state.cracks
    ? nearestSegment(model.movedLine, ...place, 5 / state.zoom) : -1;
  const found = model.find(...place);
  const lines = [...(found ? rockText(found) : []),
                 ...(segment >= 0 ? crackText(segment) : [])];
  tip.hidden = lines.length === 0;
  tip.textContent = lines.join("\n");
  const box = canvas.getBoundingClientRect();
  const [x, y] = [event.clientX - box.left, event.clientY - box.top];
  tip.style.left = `${x + tip.offsetWidth + 20 > box.width ? Math.max(0, x - tip.offsetWidth - 14) : x + 14}px`;
  tip.style.top = `${Math.min(y + 14, Math.max(0, box.height - tip.offsetHeight))}px`;
}

// One pointer drags, two zoom, none shows values.
function followPointers() {
  const down = new Map();
  const spread = () => { const [a, b] = [...down.values()]; return Math.hypot(a[0] - b[0], a[1] - b[1]); };
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    down.set(event.pointerId, [event.clientX, event.clientY]);
    tip.hidden = true;
  });
  canvas.addEventListener("pointermove", (event) => {
    const before = down.get(event.pointerId), now = [event.clientX, event.clientY];
    if (!before) { showTip(event); return; }
    const width = down.size === 2 ? spread() : 0;
    down.set(event.pointerId, now);
    if (width) { zoomBy(spread() / width, ...now); return; }
    state.centre = [state.centre[0] - (now[0] - before[0]) / state.zoom,
                    state.centre[1] + (now[1] - before[1]) / state.zoom];
    redraw();
  });
  for (const kind of ["pointerup", "pointercancel"]) {
    canvas.addEventListener(kind, (event) => down.delete(event.pointerId));
  }
  canvas.addEventListener("pointerleave", () => { tip.hidden = true; pointed = null; });
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 30 : 1;
    zoomBy(Math.exp(-0.002 * lines * event.deltaY), event.clientX, event.clientY);
  }, { passive: false });
}

function followKeys() {
  const far = 60, box = () => canvas.getBoundingClientRect();
  const shift = (dx, dy) => {
    state.centre = [state.centre[0] + dx / state.zoom, state.centre[1] + dy / state.zoom];
    redraw();
  };
  const middle = () => [box().left + box().width / 2, box().top + box().height / 2];
  const actions = {
    ArrowLeft: () => shift(-far, 0), ArrowRight: () => shift(far, 0), ArrowUp: () => shift(0, far),
    ArrowDown: () => shift(0, -far), "+": () => zoomBy(1.3, ...middle()),
    "-": () => zoomBy(1 / 1.3, ...middle()), 0: showWhole, " ": () => player?.toggle(),
    ",": () => player?.step(-1), ".": () => player?.step(1),
  };
  canvas.addEventListener("keydown", (event) => {
    if (!(event.key in actions) || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    actions[event.key]();
  });
}

function followControls() {
  for (const kind of ["rock", "cracks"]) {
    byId(`view-${kind}`)?.addEventListener("change", (event) => {
      choose(kind, event.target.value).catch(tellFailure);
    });
  }
  state.edges = byId("view-edges").checked;
  byId("view-edges").addEventListener("change", (event) => { state.edges = event.target.checked; redraw(); });
  byId("view-whole").addEventListener("click", showWhole);
  byId("view-scale")?.addEventListener("input", (event) => {
    const factor = event.target.valueAsNumber;
    if (!(factor >= 0)) return;
    model.deform(factor);
    redraw();
  });
  window.addEventListener("resize", redraw);
}

async function start() {
  if (!gl) throw Error("this browser shows no WebGL 2");
  model = new Model();
  model.dark = colourTable(gl, { colours: "ICAg/w==", names: ["outline"] });
  const factor = byId("view-scale")?.valueAsNumber;  // a browser may keep one over a reload
  model.factor = factor >= 0 ? factor : about.scale;
  wanted.cracks = about.cracks.find((one) => one.name === byId("view-cracks")?.value) ?? null;
  await choose("rock", byId("view-rock").value);
  followPointers();
  followKeys();
  followControls();
  if (about.frames.length > 1) player = new Player();
  showWhole();
  canvas.dataset.state = "ready";
}

start().catch((error) => {
  const note = byId("view-note");
  note.hidden = false;
  note.textContent = `The view cannot be shown here: ${error.message}. The pictures below do not need it.`;
  canvas.dataset.state = "failed";
});
