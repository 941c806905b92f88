// SPDX-License-Identifier: BSD-3-Clause
// The interactive view: the model of rock and cracks, what is chosen, how it is moved.
const byId = (id) => document.getElementById(id);
const about = JSON.parse(byId("view-about").textContent);
const canvas = byId("view-canvas"), tip = byId("view-tip");
// Smooth edges nearly double the time of a drawing where there is no graphics card.
const gl = canvas.getContext("webgl2", { antialias: about.triangles < 50000,
                                         preserveDrawingBuffer: true });

// Places and displacements of rock and cracks, and how they are drawn.
class Model {
  async load() {
    const cells = this.cells = await arrayOf("cells");
    const points = gathered(await arrayOf("places"), await arrayOf("place"), 2);
    const displacement = about.deforms ? await arrayOf("displacement") : null;
    this.place = gathered(points, cells, 2);
    this.displacement = displacement && gathered(displacement, cells, 2);
    const triangles = compiled(gl, TRIANGLES, COLOURING);
    this.rock = new Shape(gl, triangles, cells.length, false, this.place, this.displacement);
    if (!about.segments) return;
    if (about.deforms) await this.loadGaps(points, displacement, triangles);
    else this.line = await arrayOf("ends");
    const lines = compiled(gl, LINES, COLOURING);
    this.cracks = new Shape(gl, lines, about.segments, true, this.line, this.lineDisplacement);
  }

  async loadGaps(points, displacement, triangles) {
    const gaps = await arrayOf("gaps"), corners = [0, 1, 2, 0, 2, 3];
    const numbers = Uint32Array.from({ length: 6 * about.segments },
                                     (_, i) => gaps[4 * Math.floor(i / 6) + corners[i % 6]]);
    this.gaps = new Shape(gl, triangles, numbers.length, false, gathered(points, numbers, 2),
                          gathered(displacement, numbers, 2));
    const middle = (values) => Float32Array.from({ length: 4 * about.segments }, (_, i) => {
      const gap = 4 * Math.floor(i / 4), end = Math.floor((i % 4) / 2), axis = i % 2;
      const faces = end ? [gaps[gap + 1], gaps[gap + 2]] : [gaps[gap], gaps[gap + 3]];
      return 0.5 * (values[2 * faces[0] + axis] + values[2 * faces[1] + axis]);
    });
    [this.line, this.lineDisplacement] = [middle(points), middle(displacement)];
  }

  moved(place, displacement, factor) {
    return displacement ? place.map((value, i) => value + factor * displacement[i]) : place;
  }

  deform(factor) {
    this.finder = null;
    this.movedLine = this.line && this.moved(this.line, this.lineDisplacement, factor);
    this.factor = factor;
  }

  find(x, y) {
    this.finder ??= new Finder(this.moved(this.place, this.displacement, this.factor));
    return this.finder.at(x, y);
  }

  // Values of each corner of the rock, or of both ends of each segment; numbers with names begin
  // anew where the colours end.
  async valuesOf(field) {
    const values = await arrayOf(field.values), isRock = about.rock.includes(field);
    const size = isRock ? this.cells.length : 2 * about.segments, each = isRock ? 3 : 2;
    let result = values;
    if (!field.atPoints) result = Float32Array.from({ length: size }, (_, i) => values[Math.floor(i / each)]);
    else if (isRock) result = gathered(values, this.cells, 1);
    return result;
  }

  async colour(field) {
    field.table ??= colourTable(gl, field);
    const count = field.table.size, values = await this.valuesOf(field);
    const shown = field.names.length > count ? values.map((v) => v % count) : values;
    if (about.rock.includes(field)) { this.rock.setValues(shown); return; }
    this.cracks.setValues(shown);
    const ends = [0, 1, 1, 0, 1, 0];
    this.gaps?.setValues(Float32Array.from({ length: 6 * about.segments },
                                           (_, i) => shown[2 * Math.floor(i / 6) + ends[i % 6]]));
  }
}

const model = new Model();
const state = { centre: [0, 0], zoom: 1, rock: null, cracks: null, edges: false, asked: false };

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

function endsOf(field) {
  return field.names.length ? [0, Math.max(field.table.size - 1, 1e-9)] : field.ends;
}

function draw() {
  const ratio = window.devicePixelRatio || 1, box = canvas.getBoundingClientRect();
  const size = [Math.round(box.width * ratio), Math.round(box.height * ratio)];
  if (canvas.width !== size[0] || canvas.height !== size[1]) [canvas.width, canvas.height] = size;
  gl.viewport(0, 0, ...size);
  gl.clearColor(1, 1, 1, 1);
  gl.clear(gl.COLOR_BUFFER_BIT);
  const where = { centre: state.centre, halfSize: size.map((side) => side / 2), zoom: state.zoom * ratio,
                  factor: model.factor, edges: 0, absent: [0.7, 0.7, 0.7] };
  model.rock.draw({ ...where, ends: endsOf(state.rock), edges: state.edges ? 1 : 0 }, state.rock.table);
  if (!model.cracks || !state.cracks) return;
  const ends = endsOf(state.cracks), table = state.cracks.table, absent = [-1, -1, -1];  // dry ones are not shown
  const thin = state.cracks.name === "mode" ? 0.5 : ABSENT;
  model.gaps?.draw({ ...where, ends, absent }, table);
  model.cracks.draw({ ...where, ends: [1e38, 2e38], absent, thin, width: 4 * ratio },
                    { ...table, texture: model.dark.texture });
  model.cracks.draw({ ...where, ends, absent, thin, width: 2.4 * ratio }, table);
}

function showWhole() {
  const moved = model.moved(model.place, model.displacement, model.factor);
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

const turns = { rock: 0, cracks: 0 };

async function choose(kind, name) {
  const turn = ++turns[kind];
  const field = about[kind].find((one) => one.name === name) ?? null;
  if (field) {
    await arrayOf(field.values);
    if (turn !== turns[kind]) return;  // another was chosen meanwhile
    await model.colour(field);
  }
  state[kind] = field;
  showBar(byId(`view-${kind}-bar`), field);
  redraw();
}
