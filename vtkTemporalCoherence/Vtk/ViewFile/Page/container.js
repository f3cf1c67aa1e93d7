// Reads a view file, and checks all of its header (ViewFile.md).

// What is wrong with the data, as a sentence.
class WrongFile extends Error {}

function require(isTrue, wrong) {
  if (!isTrue) {
    throw new WrongFile(wrong);
  }
}

const MOST_PIXELS = 2 ** 26;
const MOST_PACKED = 1032; // bytes that deflate packs into one

function bytesOfBase64(text) {
  if (Uint8Array.fromBase64) {
    return Uint8Array.fromBase64(text);
  }
  const characters = atob(text);
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < bytes.length; ++i) {
    bytes[i] = characters.charCodeAt(i);
  }
  return bytes;
}

// CRC-32 as zlib computes it.
function checksumOf(bytes) {
  const table = new Uint32Array(256);
  for (let i = 0; i < 256; ++i) {
    let value = i;
    for (let bit = 0; bit < 8; ++bit) {
      value = value & 1 ? (value >>> 1) ^ 0xedb88320 : value >>> 1;
    }
    table[i] = value;
  }
  let crc = 0xffffffff;
  for (const byte of bytes) {
    crc = table[(crc ^ byte) & 255] ^ (crc >>> 8);
  }
  return (crc ^ 0xffffffff) >>> 0;
}

function isWhole(value, low, high) {
  return Number.isInteger(value) && value >= low && value <= high;
}

function isObject(value) {
  return typeof value === "object" && value !== null;
}

function areFinite(values, count) {
  return Array.isArray(values) && values.length === count && values.every(Number.isFinite);
}

function checkSection(section, bytes) {
  require(section && isWhole(section.offset, 0, bytes) && isWhole(section.bytes, 0, bytes) &&
    section.offset + section.bytes <= bytes, "The file ends before a section does.");
  require(isWhole(section.unpacked, 1, MOST_PACKED * section.bytes),
    "A section cannot be as large as it says.");
}

function checkChunks(view, bytes) {
  const knots = { rising: 0, falling: 0 };
  const next = { rising: 0, falling: 0 };
  require(Array.isArray(view.chunks), "A view has no list of chunks.");
  for (const chunk of view.chunks) {
    checkSection(chunk, bytes);
    require(chunk.direction === "rising" || chunk.direction === "falling",
      "A direction is neither rising nor falling.");
    const first = next[chunk.direction];
    require(isWhole(chunk.first, first, view.size[1] - 1) &&
      isWhole(chunk.rows, 1, view.size[1] - chunk.first), "Chunks overlap, or are not in order.");
    next[chunk.direction] = chunk.first + chunk.rows;
    require(isWhole(chunk.knots, 0, chunk.unpacked / 6), "A chunk is too small for its knots.");
    knots[chunk.direction] += chunk.knots;
  }
  require(knots.rising === view.knots.rising && knots.falling === view.knots.falling &&
    knots.rising + knots.falling < 2 ** 30, "Chunks do not hold the knots of their view.");
}

function checkView(view, bytes) {
  require(typeof view.name === "string" && areFinite(view.size, 2) &&
    view.size.every((side) => isWhole(side, 1, 16384)), "A view has no name or size.");
  require(areFinite(view.range, 2) && view.range[0] <= view.range[1], "A range is impossible.");
  const { progress, rays, box } = view;
  require(progress && isWhole(progress.largest, 1, 65535) && progress.margin === 4 &&
    Number.isFinite(progress.step) && progress.step > 0, "The steps of progress are impossible.");
  require(Number.isFinite(view.distanceStep) && view.distanceStep > 0 &&
    isWhole(view.normalSteps, 1, 127) && Number.isFinite(view.tolerance) &&
    Number.isFinite(view.voxel), "The steps of distances or normals are impossible.");
  require(rays && ["origin", "originX", "originY", "direction", "directionX", "directionY",
    "forward"].every((name) => areFinite(rays[name], 3)) && Number.isFinite(rays.near) &&
    typeof rays.parallel === "boolean", "The rays of a view are incomplete.");
  require(box && areFinite(box.matrix, 16) && areFinite(box.low, 3) && areFinite(box.high, 3),
    "The box of a view is incomplete.");
  require(view.planes === undefined || (Array.isArray(view.planes) && view.planes.length <= 64 &&
    view.planes.every((plane) => areFinite(plane, 4))), "The planes of a view are impossible.");
  require(view.lights === undefined || areLights(view.lights), "The lights are impossible.");
  checkChunks(view, bytes);
  const pixels = view.size[0] * view.size[1];
  for (const [name, unpacked] of [["entries", 2 * pixels], ["unknown", Math.ceil(pixels / 8)]]) {
    if (view[name] !== undefined) {
      checkSection(view[name], bytes);
      require(view[name].unpacked === unpacked, "A section has another size than its view.");
    }
  }
}

function areLights(lights) {
  return Array.isArray(lights) && lights.length <= 64 && lights.every((light) =>
    isObject(light) && ["position", "direction", "diffuse", "specular"].every((name) =>
      areFinite(light[name], 3)));
}

function checkLook(header) {
  const { surfaces, material } = header;
  require(Array.isArray(surfaces) && isWhole(surfaces.length, 1, 8) &&
    surfaces.every((surface) => isObject(surface) && Number.isFinite(surface.isovalue) &&
      areFinite(surface.color, 3) && Number.isFinite(surface.opacity)),
  "The surfaces to show are impossible.");
  require(material && ["ambient", "diffuse", "specular", "specularPower"].every((name) =>
    Number.isFinite(material[name])), "The material is incomplete.");
  require(areLights(header.lights), "The lights are impossible.");
  require(areFinite(header.background, 3), "The background is no colour.");
  require(header.background2 === undefined || areFinite(header.background2, 3),
    "The background is no colour.");
  require(header.colors === undefined || (Array.isArray(header.colors) &&
    header.colors.length <= 4096 && header.colors.every((color) => areFinite(color, 4))),
  "The colours are impossible.");
  const histogram = header.histogram;
  require(histogram === undefined || (isObject(histogram) && areFinite(histogram.range, 2) &&
    Array.isArray(histogram.counts) && histogram.counts.length <= 256 &&
    histogram.counts.every((count) => Number.isFinite(count) && count >= 0)),
  "The histogram is impossible.");
  for (const name of ["title", "caption", "citation", "array", "units"]) {
    require(typeof header[name] === "string", "A text is missing.");
  }
}

// The header of a file, and the bytes of its sections.
function readContainer(file) {
  const magic = [84, 67, 86, 73, 69, 87, 13, 10];
  require(file.length >= 24 && magic.every((byte, i) => file[i] === byte),
    "This is no view file: it does not begin with TCVIEW.");
  const numbers = new DataView(file.buffer, file.byteOffset, 24);
  const version = numbers.getUint32(8, true), length = numbers.getUint32(12, true);
  require(version === 1, `This view file has version ${version}; this page reads version 1.`);
  require(length <= file.length - 24, "The view file is cut off in its header.");
  const text = file.subarray(24, 24 + length);
  require(checksumOf(text) === numbers.getUint32(16, true),
    "The header of the view file is damaged: its checksum is wrong.");
  let header;
  try {
    header = JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(text));
  } catch {
    throw new WrongFile("The header of the view file is no JSON.");
  }
  const sections = file.subarray(24 + length);
  require(header && header.format === "vtkTemporalCoherence view" && header.version === 1,
    "The header of the view file has another format or version.");
  checkLook(header);
  require(Array.isArray(header.views) && isWhole(header.views.length, 1, 64),
    "The file has no view, or more than 64.");
  let pixels = 0, used = 0;
  for (const view of header.views) {
    require(view && view.knots, "A view is incomplete.");
    checkView(view, sections.length);
    pixels += view.size[0] * view.size[1];
    for (const section of [...view.chunks, view.entries, view.unknown]) {
      used += section ? section.bytes : 0;
    }
  }
  require(pixels <= MOST_PIXELS, "The views have too many pixels.");
  // Else few bytes could be unpacked to any size.
  require(used <= sections.length, "The sections of the file overlap.");
  return { header, sections };
}
