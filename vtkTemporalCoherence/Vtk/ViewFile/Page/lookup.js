// Looks isovalues up in the knots of a view. A drag moves an isovalue little, so each pixel keeps
// the piece of its fit where it was last, ready to be evaluated.

// The numbers of a piece. With the share t of its progress, its distance is DISTANCE + t GAIN, and
// its normal lies along the parabola NORMAL + t (LINEAR + t SQUARE), of three numbers each.
const [SCALE, DISTANCE, GAIN, NORMAL, LINEAR, SQUARE, PIECE] = [0, 1, 2, 3, 6, 9, 12];

// The kinds of pieces: a bit for the direction, and one for pieces without a surface.
const FALLING = 1, MISSED = 2;

class SurfaceLookup {
  // `pixels` are those that have knots.
  constructor(view, knots, pixels) {
    this.view = view;
    this.knots = [knots.rising, knots.falling];
    this.pixels = pixels;
    this.entries = knots.entries && pixels.map((pixel) => knots.entries[pixel]);
    // A piece holds for bounds[2 i] < progress <= bounds[2 i + 1]: at first, for none.
    this.bounds = new Uint16Array(2 * pixels.length);
    this.kinds = new Uint8Array(pixels.length);
    this.pieces = new Float32Array(PIECE * pixels.length);
    this.distances = new Float32Array(pixels.length); // -1: no surface
    this.normals = new Float32Array(3 * pixels.length); // of any length
    this.table = normalsOf(view.normalSteps);
  }

  // Distances and normals of an isovalue, for each of `pixels`.
  lookUp(isovalue) {
    const { bounds, kinds, pieces, distances, normals, entries } = this;
    const [low, high] = this.view.range, { margin, step } = this.view.progress;
    const rising = margin + (isovalue - low) / step;
    const falling = margin + (high - low - (isovalue - low)) / step;
    const count = distances.length;
    for (let i = 0; i < count; ++i) {
      const direction = entries !== null && entries[i] > rising ? FALLING : 0;
      const progress = direction === 0 ? rising : falling;
      if (!(bounds[2 * i] < progress && progress <= bounds[2 * i + 1]) ||
          (kinds[i] & FALLING) !== direction) {
        this.goTo(i, direction, progress);
      }
      if (kinds[i] >= MISSED) {
        continue;
      }
      const piece = PIECE * i, share = (progress - bounds[2 * i]) * pieces[piece];
      distances[i] = pieces[piece + DISTANCE] + share * pieces[piece + GAIN];
      normals[3 * i] = pieces[piece + NORMAL] +
        share * (pieces[piece + LINEAR] + share * pieces[piece + SQUARE]);
      normals[3 * i + 1] = pieces[piece + NORMAL + 1] +
        share * (pieces[piece + LINEAR + 1] + share * pieces[piece + SQUARE + 1]);
      normals[3 * i + 2] = pieces[piece + NORMAL + 2] +
        share * (pieces[piece + LINEAR + 2] + share * pieces[piece + SQUARE + 2]);
    }
  }

  // Keeps the piece of a pixel at a progress.
  goTo(i, direction, progress) {
    const { start, progress: reached } = this.knots[direction];
    const begin = start[this.pixels[i]], end = start[this.pixels[i] + 1];
    let knot = begin, behind = end;
    while (knot < behind) {
      const middle = (knot + behind) >>> 1;
      if (reached[middle] < progress) {
        knot = middle + 1;
      } else {
        behind = middle;
      }
    }
    this.bounds[2 * i] = knot > begin ? reached[knot - 1] : 0;
    if (knot === end) {
      this.bounds[2 * i + 1] = 65535;
      this.kinds[i] = direction + MISSED;
      this.distances[i] = -1;
    } else {
      this.bounds[2 * i + 1] = reached[knot];
      this.kinds[i] = direction;
      this.keep(PIECE * i, this.knots[direction], knot > begin ? knot - 1 : knot, knot);
    }
  }

  // Writes the piece from a knot to another one; to itself, where it is the first of its pixel.
  keep(piece, { progress: reached, data }, before, knot) {
    const { pieces, table } = this;
    const step = this.view.distanceStep, first = data[2 * before + 1], last = data[2 * knot + 1];
    const a = this.placeOf(first >> 24, (first << 8) >> 24);
    const b = this.placeOf(last >> 24, (last << 8) >> 24);
    const m = before < knot ? this.placeOf((last << 16) >> 24, (last << 24) >> 24) : a;
    pieces[piece + SCALE] = before < knot ? 1 / (reached[knot] - reached[before]) : 0;
    pieces[piece + DISTANCE] = step * data[2 * before];
    pieces[piece + GAIN] = step * (data[2 * knot] - data[2 * before]);
    for (let c = 0; c < 3; ++c) {
      const from = table[a + c], half = table[m + c], to = table[b + c];
      pieces[piece + NORMAL + c] = from;
      pieces[piece + LINEAR + c] = 4 * half - 3 * from - to;
      pieces[piece + SQUARE + c] = 2 * (from - 2 * half + to);
    }
  }

  // Where the unit vector of octahedral coordinates is in the table.
  placeOf(u, v) {
    const steps = this.view.normalSteps;
    return 3 * ((u + steps) * (2 * steps + 1) + v + steps);
  }
}

// The unit vectors of octahedral coordinates from -steps to steps.
function normalsOf(steps) {
  const side = 2 * steps + 1, table = new Float32Array(3 * side * side);
  for (let u = -steps; u <= steps; ++u) {
    for (let v = -steps; v <= steps; ++v) {
      let x = u / steps, y = v / steps;
      const z = 1 - Math.abs(x) - Math.abs(y);
      if (z < 0) {
        [x, y] = [(1 - Math.abs(y)) * (x < 0 ? -1 : 1), (1 - Math.abs(x)) * (y < 0 ? -1 : 1)];
      }
      const length = Math.hypot(x, y, z);
      table.set([x / length, y / length, z / length],
        3 * ((u + steps) * side + v + steps));
    }
  }
  return table;
}

// The pixels that have knots, row by row.
function pixelsWithKnots(view, knots) {
  const count = view.size[0] * view.size[1], pixels = new Uint32Array(count);
  const rising = knots.rising.start, falling = knots.falling.start;
  let found = 0;
  for (let pixel = 0; pixel < count; ++pixel) {
    if (rising[pixel + 1] > rising[pixel] || falling[pixel + 1] > falling[pixel]) {
      pixels[found++] = pixel;
    }
  }
  return pixels.slice(0, found);
}
