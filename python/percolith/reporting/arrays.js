// SPDX-License-Identifier: BSD-3-Clause
// Arrays of the page: what packed.py packs. Each is unpacked when it is first asked for.
const promisedArrays = new Map(), readyArrays = new Map();

function bytesOf(text) {
  const letters = atob(text.trim());
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
  return bytes;
}

// Numbers of so many bytes each from their planes.
function joinedPlanes(planes, length, size) {
  const bytes = new Uint8Array(size * length);
  for (let plane = 0; plane < size; ++plane) {
    for (let i = 0; i < length; ++i) bytes[size * i + plane] = planes[plane * length + i];
  }
  return bytes.buffer;
}

async function unpack(key) {
  const element = document.getElementById("array-" + key), { kind, low, step } = element.dataset;
  const stream = new Blob([bytesOf(element.textContent)]).stream();
  const plain = stream.pipeThrough(new DecompressionStream("deflate"));
  const planes = new Uint8Array(await new Response(plain).arrayBuffer());
  const length = Number(element.dataset.length);
  const buffer = joinedPlanes(planes, length, kind === "uint16" ? 2 : 4);
  if (kind === "float32") return new Float32Array(buffer);
  if (kind === "uint16") {
    const [first, each] = [Number(low), Number(step)];
    return Float32Array.from(new Uint16Array(buffer), (n) => n === 65535 ? NaN : first + each * n);
  }
  const numbers = new Uint32Array(buffer);
  for (let i = 1; i < length; ++i) numbers[i] += numbers[i - 1];
  return numbers;
}

function arrayOf(key) {
  if (!promisedArrays.has(key)) {
    promisedArrays.set(key, unpack(key).then((array) => { readyArrays.set(key, array); return array; }));
  }
  return promisedArrays.get(key);
}

// Rows of `width` numbers of `values` by their numbers, one after the other.
function gathered(values, numbers, width) {
  const result = new Float32Array(width * numbers.length);
  for (let i = 0; i < numbers.length; ++i) {
    for (let k = 0; k < width; ++k) result[width * i + k] = values[width * numbers[i] + k];
  }
  return result;
}

function numberText(value, digits) {
  return String(Number(value.toPrecision(digits))).replaceAll("-", "\u2212");
}

// A value of a field as a reader expects it: its name, or five digits and the unit.
function valueText(field, value) {
  if (field.names.length) return field.names[Math.round(value)];
  const between = field.unit.startsWith("10") ? " × " : " ";
  return (numberText(value / field.factor, 5) + between + field.unit).trim();
}
