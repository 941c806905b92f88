// SPDX-License-Identifier: BSD-3-Clause
// The model at one time of the run: rock and cracks, where they lie and what they are coloured by.
const CORNERS = [0, 1, 2, 0, 2, 3];  // of the two triangles of a gap
const WIDEST = 5;  // times its length, that a gap is drawn
const END_OF_CORNER = [0, 1, 1, 0];  // of a segment, that a corner of its gap is at

// The arrays of a frame by the names that `about` gives them, those that it has.
async function arraysOf(frame, names) {
  const keys = about.frames[frame].arrays, found = {};
  for (const name of names) found[name] = name in keys ? await arrayOf(keys[name]) : null;
  return found;
}

class Model {
  constructor() {
    const triangles = compiled(gl, TRIANGLES, COLOURING), lines = compiled(gl, LINES, COLOURING);
    this.rock = new Shape(gl, triangles, false);
    this.gaps = new Shape(gl, triangles, false);
    this.faces = new Shape(gl, lines, true);
  }

  load(frame) {
    return arraysOf(frame, ["places", "node", "cells", "displacement", "gaps", "hubs", "hub-ends", "ends"]);
  }

  // Takes the arrays of a frame, as `load` gives them.
  place(arrays, segments) {
    Object.assign(this, { cells: arrays.cells, node: arrays.node, segments });
    this.nodeOfCorner = this.cells.map((point) => this.node[point]);
    const at = (nodes) => [gathered(arrays.places, nodes, 2),
                           arrays.displacement && gathered(arrays.displacement, nodes, 2)];
    [this.places, this.displacement] = at(this.nodeOfCorner);
    this.rock.setPlaces(this.places, this.displacement);
    this.hubEnds = arrays["hub-ends"] ?? [];
    if (arrays.gaps) this.placeGaps(arrays, arrays.hubs ?? [], at);
    else this.placeLines(arrays.ends ?? new Float32Array(0));
  }

  placeLines(ends) {
    this.facesOfSegment = 1;
    [this.line, this.lineDisplacement] = [ends, null];
    this.faces.setPlaces(ends, null);
    this.gaps.count = 0;
  }

  // A gap is two triangles between the faces of a crack, which are lines from end to end; where
  // gaps meet the space between them is closed by hubs.
  placeGaps(arrays, hubs, at) {
    const gaps = arrays.gaps;
    this.facesOfSegment = 2;
    const numbers = new Uint32Array(6 * this.segments + hubs.length);
    for (let i = 0; i < 6 * this.segments; ++i) numbers[i] = gaps[4 * Math.floor(i / 6) + CORNERS[i % 6]];
    numbers.set(hubs, 6 * this.segments);
    this.leaveOutWide(numbers, gaps, arrays);
    this.gaps.setPlaces(...at(numbers));
    const faces = Uint32Array.from(gaps, (_, i) => gaps[4 * Math.floor(i / 4) + [0, 1, 3, 2][i % 4]]);
    const [place, displacement] = at(faces);
    this.faces.setPlaces(place, displacement);
    const middle = (values) => Float32Array.from({ length: 4 * this.segments }, (_, i) => {
      const first = 8 * Math.floor(i / 4) + i % 4;
      return 0.5 * (values[first] + values[first + 4]);
    });
    [this.line, this.lineDisplacement] = [middle(place), middle(displacement)];
  }

  // Between pieces that have flown apart there is no gap: triangles there would lie over the rock.
  // They shrink to nothing. Each is as wide as its nodes have moved away from each other.
  leaveOutWide(numbers, gaps, { places, displacement }) {
    const apart = (values, a, b) => Math.hypot(values[2 * a] - values[2 * b],
                                               values[2 * a + 1] - values[2 * b + 1]);
    for (let i = 0; i < numbers.length; i += 3) {
      const hub = i / 3 - 2 * this.segments, [a, b, c] = numbers.subarray(i, i + 3);
      const segment = Math.floor(hub < 0 ? i / 6 : this.hubEnds[hub] / 2);
      const length = apart(places, gaps[4 * segment], gaps[4 * segment + 1]);
      const width = Math.max(apart(displacement, a, b), apart(displacement, b, c),
                             apart(displacement, c, a));
      if (width > WIDEST * length) numbers.fill(a, i, i + 3);
    }
  }

  moved(place, displacement, factor) {
    return displacement ? place.map((value, i) => value + factor * displacement[i]) : place;
  }

  deform(factor) {
    this.finder = null;
    this.movedLine = this.moved(this.line, this.lineDisplacement, factor);
    this.factor = factor;
  }

  find(x, y) {
    this.finder ??= new Finder(this.moved(this.places, this.displacement, this.factor));
    return this.finder.at(x, y);
  }

  // The number, among its values, of that of the rock at a corner: one a triangle, point or node.
  numberOf(field, values, corner) {
    if (!field.atPoints) return Math.floor(corner / 3);
    return values.length === this.node.length ? this.cells[corner] : this.nodeOfCorner[corner];
  }

  // Numbers with names begin anew where the colours end.
  shown(field, values) {
    const count = tableOf(field).size;
    return field.names.length > count ? values.map((v) => v % count) : values;
  }

  colourRock(field, values) {
    const each = Float32Array.from(this.cells, (_, corner) => values[this.numberOf(field, values, corner)]);
    this.rock.setValues(this.shown(field, each));
  }

  colourCracks(field, values) {
    const ofEnd = (end) => values[field.atPoints ? end : Math.floor(end / 2)], faces = this.facesOfSegment;
    const lines = Float32Array.from({ length: 2 * faces * this.segments },
                                    (_, i) => ofEnd(2 * Math.floor(i / (2 * faces)) + i % 2));
    this.faces.setValues(this.shown(field, lines));
    if (faces < 2) return;
    const corners = new Float32Array(this.gaps.count);
    for (let i = 0; i < 6 * this.segments; ++i) {
      corners[i] = ofEnd(2 * Math.floor(i / 6) + END_OF_CORNER[CORNERS[i % 6]]);
    }
    for (let i = 6 * this.segments; i < corners.length; ++i) {
      corners[i] = ofEnd(this.hubEnds[Math.floor((i - 6 * this.segments) / 3)]);
    }
    this.gaps.setValues(this.shown(field, corners));
  }
}
