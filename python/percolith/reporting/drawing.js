// SPDX-License-Identifier: BSD-3-Clause
// Draws triangles and thick lines by WebGL. Values become colours in the fragment shader, so that
// they are interpolated before they are coloured.
const ABSENT = -3e38;  // stands for NaN, which shaders need not know

const COLOURING = `#version 300 es
precision highp float;
uniform sampler2D colours;
uniform vec3 absent;
uniform float tableSize, edges;
in float share, lacks;
in vec3 corner;
out vec4 colour;
void main() {
  if (lacks > 0.5 && absent.r < 0.0) discard;
  float place = (clamp(share, 0.0, 1.0) * (tableSize - 1.0) + 0.5) / tableSize;
  vec3 shown = lacks > 0.5 ? absent : texture(colours, vec2(place, 0.5)).rgb;
  vec3 distance = corner / fwidth(corner);
  float line = 1.0 - smoothstep(0.3, 1.1, min(distance.x, min(distance.y, distance.z)));
  colour = vec4(mix(shown, vec3(0.1), 0.55 * edges * line), 1.0);
}`;

const SHARED = `#version 300 es
uniform vec2 centre, halfSize, ends;
uniform float zoom, factor;
out float share, lacks;
out vec3 corner;
vec2 pixels(vec2 place, vec2 displacement) { return (place + factor * displacement - centre) * zoom; }
void colourBy(float value) {
  lacks = value < -2e38 ? 1.0 : 0.0;
  share = (value - ends.x) / (ends.y - ends.x);
}
`;

const TRIANGLES = SHARED + `
in vec2 place, displacement;
in float value;
void main() {
  gl_Position = vec4(pixels(place, displacement) / halfSize, 0.0, 1.0);
  colourBy(value);
  int number = gl_VertexID % 3;
  corner = vec3(number == 0, number == 1, number == 2);
}`;

const LINES = SHARED + `
in vec4 place, displacement;  // of both ends
in vec2 value;
uniform float width, thin;
void main() {
  float along = float(gl_VertexID / 2), side = float(gl_VertexID % 2) * 2.0 - 1.0;
  vec2 first = pixels(place.xy, displacement.xy), last = pixels(place.zw, displacement.zw);
  vec2 direction = (last - first) / max(length(last - first), 1e-6);
  vec2 aside = side * vec2(-direction.y, direction.x) + (2.0 * along - 1.0) * direction;
  float thickness = width * (value.x < thin ? 0.5 : 1.0);
  gl_Position = vec4((mix(first, last, along) + 0.5 * thickness * aside) / halfSize, 0.0, 1.0);
  colourBy(along < 0.5 ? value.x : value.y);
  corner = vec3(1.0);
}`;

function compiled(gl, vertex, fragment) {
  const program = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw Error(gl.getShaderInfoLog(shader));
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw Error(gl.getProgramInfoLog(program));
  return program;
}

// What is drawn by one program: corners of triangles, or lines of two ends.
class Shape {
  constructor(gl, program, isLines) {
    Object.assign(this, { gl, program, isLines, count: 0 });
    this.arrays = gl.createVertexArray();
    this.buffers = new Map();
  }

  // Places and displacements, x and y of each corner or end.
  setPlaces(place, displacement) {
    const width = this.isLines ? 4 : 2;
    this.count = place.length / width;
    this.feed("place", place, width);
    this.feed("displacement", displacement, width);
  }

  // Values of every corner or end; NaN where there is none.
  setValues(values) {
    this.feed("value", values.map((v) => (Number.isNaN(v) ? ABSENT : v)), this.isLines ? 2 : 1);
  }

  // Without an array the attribute is zero; left alone its last component would be one.
  feed(name, array, width) {
    const gl = this.gl, location = gl.getAttribLocation(this.program, name);
    if (!array) {
      gl.vertexAttrib4f(location, 0, 0, 0, 0);
      return;
    }
    if (!this.buffers.has(name)) this.buffers.set(name, gl.createBuffer());
    gl.bindVertexArray(this.arrays);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers.get(name));
    gl.bufferData(gl.ARRAY_BUFFER, array, gl.DYNAMIC_DRAW);
    gl.enableVertexAttribArray(location);
    gl.vertexAttribPointer(location, width, gl.FLOAT, false, 0, 0);
    gl.vertexAttribDivisor(location, this.isLines ? 1 : 0);
    gl.bindVertexArray(null);
  }

  draw(uniforms, table) {
    const gl = this.gl;
    if (!this.count) return;
    gl.useProgram(this.program);
    gl.bindTexture(gl.TEXTURE_2D, table.texture);
    for (const [name, value] of Object.entries({ ...uniforms, tableSize: table.size })) {
      const location = gl.getUniformLocation(this.program, name), numbers = [].concat(value);
      if (location) gl[`uniform${numbers.length}fv`](location, numbers);
    }
    gl.bindVertexArray(this.arrays);
    if (this.isLines) gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, this.count);
    else gl.drawArrays(gl.TRIANGLES, 0, this.count);
    gl.bindVertexArray(null);
  }
}

// A table of colours as a texture.
function colourTable(gl, field) {
  const bytes = bytesOf(field.colours), size = bytes.length / 4;
  const filter = field.names.length ? gl.NEAREST : gl.LINEAR;
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, size, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, filter);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, filter);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
  return { texture, size, bytes };
}
