// SPDX-License-Identifier: BSD-3-Clause
// The interactive view: the model of rock and cracks, what is chosen, how it is moved.
const byId = (id) => document.getElementById(id);
const about = JSON.parse(byId("view-about").textContent);
const canvas = byId("view-canvas"), tip = byId("view-tip");
// Smooth edges nearly double the time of a drawing where there is no graphics card.
const gl = canvas.getContext("webgl2", { antialias: about.triangles < 50000,
                                         preserveDrawingBuffer: true });

let model = null;
const state = { centre: [0, 0], zoom: 1, frame: -1, rock: null, cracks: null, edges: false,
                alone: false, asked: false };

// x and y in m, from the middle of the model, of a place of the window.
function placeAt(x, y) {
  const box = canvas.getBoundingClientRect();
  return [state.centre[0] + (x - box.left - box.width / 2) / state.zoom,
          state.centre[1] - (y - box.top - box.height / 2) / state.zoom];
}

function redraw() {
  if (state.asked) return;
  state.asked = true;
  requestAnimationFrame(() => { state.asked = false; draw(); });
}

function tableOf(field) {
  return field.table ??= colourTable(gl, field);
}

// Where the colours of a field end: of all times, or of the time that is shown alone.
function rangeOf(field) {
  return (state.alone && about.frames[state.frame].ranges[field.values]) || field;
}

function endsOf(field) {
  return field.names.length ? [0, Math.max(tableOf(field).size - 1, 1e-9)] : rangeOf(field).ends;
}

const DARK = [0.125, 0.125, 0.125];  // as the outlines of pictures
const FAR = [1e38, 2e38];  // above all values, so that all have the one colour of model.dark

function draw() {
  const ratio = window.devicePixelRatio || 1, box = canvas.getBoundingClientRect();
  const size = [Math.round(box.width * ratio), Math.round(box.height * ratio)];
  if (canvas.width !== size[0] || canvas.height !== size[1]) [canvas.width, canvas.height] = size;
  gl.viewport(0, 0, ...size);
  gl.clearColor(1, 1, 1, 1);
  gl.clear(gl.COLOR_BUFFER_BIT);
  const where = { centre: state.centre, halfSize: size.map((side) => side / 2), zoom: state.zoom * ratio,
                  factor: model.factor, edges: 0, absent: [0.7, 0.7, 0.7] };
  const showsCracks = model.segments && state.cracks;
  // Below the rock, so that gaps without a value do not shine white but are dark as outlines are.
  if (showsCracks) model.gaps.draw({ ...where, ends: FAR, absent: DARK }, model.dark);
  model.rock.draw({ ...where, ends: endsOf(state.rock), edges: state.edges ? 1 : 0 }, tableOf(state.rock));
  if (showsCracks) drawCracks(where, ratio);
}

// Dark lines along both faces first, so that the colours of gaps that meet are one and the outline
// goes around them all, however far the faces have parted.
function drawCracks(where, ratio) {
  const ends = endsOf(state.cracks), table = tableOf(state.cracks), absent = [-1, -1, -1];  // not drawn
  const thin = state.cracks.name === "mode" ? 0.5 : ABSENT;
  model.faces.draw({ ...where, ends: FAR, absent, thin, width: 4 * ratio }, model.dark);
  model.gaps.draw({ ...where, ends, absent }, table);
  model.faces.draw({ ...where, ends, absent, thin, width: 2.4 * ratio }, table);
}

function showWhole() {
  const moved = model.moved(model.places, model.displacement, model.factor);
  let [left, low, right, high] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let i = 0; i < moved.length; i += 2) {
    [left, right] = [Math.min(left, moved[i]), Math.max(right, moved[i])];
    [low, high] = [Math.min(low, moved[i + 1]), Math.max(high, moved[i + 1])];
  }
  const box = canvas.getBoundingClientRect();
  state.centre = [(left + right) / 2, (low + high) / 2];
  state.zoom = 0.96 * Math.min(box.width / (right - left), box.height / (high - low));
  redraw();
}

// Keeps the place under (x, y) of the window where it is.
function zoomBy(times, x, y) {
  const [before, most] = [placeAt(x, y), 1e7 / Math.max(...about.size)];
  state.zoom = Math.min(most, Math.max(10 / Math.max(...about.size), state.zoom * times));
  const after = placeAt(x, y);
  state.centre = state.centre.map((value, i) => value + before[i] - after[i]);
  redraw();
}

const wanted = { frame: about.asked, rock: null, cracks: null };
let turn = 0, player = null;

// Shows what is wanted as soon as its arrays are unpacked, unless something else is by then.
async function show(change) {
  Object.assign(wanted, change);
  const mine = ++turn, { frame, rock, cracks } = wanted;
  const shapes = await model.load(frame);
  const names = [rock, cracks].flatMap((field) => (field ? [field.values] : []));
  const values = await arraysOf(frame, names);
  // For the values under the pointer, which go without those that cannot be unpacked.
  arraysOf(frame, about.cracks.map((field) => field.values)).catch(() => {});
  if (mine !== turn) return;
  const segments = about.frames[frame].segments;
  if (frame !== state.frame) {
    model.place(shapes, segments);
    model.deform(model.factor);
  }
  Object.assign(state, { frame, rock, cracks });
  model.colourRock(rock, values[rock.values]);
  if (cracks && segments) model.colourCracks(cracks, values[cracks.values]);
  showBars();
  player?.tell();
  if (pointed && !tip.hidden) showTip(pointed);
  redraw();
}

function tellFailure(error) {
  const note = byId("view-note");
  note.hidden = false;
  note.textContent = `A part of the view cannot be shown: ${error.message}.`;
}

function choose(kind, name) {
  return show({ [kind]: about[kind].find((one) => one.name === name) ?? null });
}
