// SPDX-License-Identifier: BSD-3-Clause
// Finds the triangle at a place: squares over the model, each with the triangles that reach into it.
class Finder {
  constructor(corners) {  // x and y of three corners, triangle after triangle
    this.corners = corners;
    const count = corners.length / 6;
    let [left, low, right, high] = [Infinity, Infinity, -Infinity, -Infinity];
    for (let i = 0; i < corners.length; i += 2) {
      left = Math.min(left, corners[i]);
      right = Math.max(right, corners[i]);
      low = Math.min(low, corners[i + 1]);
      high = Math.max(high, corners[i + 1]);
    }
    this.bounds = { left, low, right, high };
    this.side = Math.sqrt(Math.max((right - left) * (high - low), 1e-300) / Math.max(count, 1)) * 1.5;
    this.columns = Math.floor((right - left) / this.side) + 1;
    this.rows = Math.floor((high - low) / this.side) + 1;
    this.starts = new Uint32Array(this.columns * this.rows + 1);
    this.eachSquare((square) => { ++this.starts[square + 1]; });
    for (let i = 1; i < this.starts.length; ++i) this.starts[i] += this.starts[i - 1];
    this.triangles = new Uint32Array(this.starts[this.starts.length - 1]);
    const next = this.starts.slice();
    this.eachSquare((square, triangle) => { this.triangles[next[square]++] = triangle; });
  }

  column(x) { return Math.floor((x - this.bounds.left) / this.side); }
  row(y) { return Math.floor((y - this.bounds.low) / this.side); }

  eachSquare(visit) {
    const c = this.corners;
    for (let t = 0, i = 0; i < c.length; ++t, i += 6) {
      const first = this.column(Math.min(c[i], c[i + 2], c[i + 4]));
      const last = this.column(Math.max(c[i], c[i + 2], c[i + 4]));
      const top = this.row(Math.max(c[i + 1], c[i + 3], c[i + 5]));
      for (let row = this.row(Math.min(c[i + 1], c[i + 3], c[i + 5])); row <= top; ++row) {
        for (let column = first; column <= last; ++column) visit(row * this.columns + column, t);
      }
    }
  }

  // The triangle with the place and the shares of its corners there; null where there is none.
  at(x, y) {
    const column = this.column(x), row = this.row(y), c = this.corners;
    if (column < 0 || row < 0 || column >= this.columns || row >= this.rows) return null;
    const square = row * this.columns + column;
    for (let k = this.starts[square]; k < this.starts[square + 1]; ++k) {
      const triangle = this.triangles[k], i = 6 * triangle;
      const [ax, ay] = [c[i + 2] - c[i], c[i + 3] - c[i + 1]];
      const [bx, by] = [c[i + 4] - c[i], c[i + 5] - c[i + 1]];
      const [px, py] = [x - c[i], y - c[i + 1]], area = ax * by - ay * bx;
      const second = (px * by - py * bx) / area, third = (ax * py - ay * px) / area;
      const first = 1 - second - third;
      if (Math.min(first, second, third) >= -1e-6) return { triangle, shares: [first, second, third] };
    }
    return null;
  }
}

// The crack segment (x and y of both ends each) nearest to a place, at most `reach` away; -1 if none.
function nearestSegment(ends, x, y, reach) {
  let nearest = -1, least = reach * reach;
  for (let s = 0, i = 0; i < ends.length; ++s, i += 4) {
    const [dx, dy] = [ends[i + 2] - ends[i], ends[i + 3] - ends[i + 1]];
    const [px, py] = [x - ends[i], y - ends[i + 1]], square = dx * dx + dy * dy;
    const share = square > 0 ? Math.min(1, Math.max(0, (px * dx + py * dy) / square)) : 0;
    const away = (px - share * dx) ** 2 + (py - share * dy) ** 2;
    if (away <= least) [least, nearest] = [away, s];
  }
  return nearest;
}
