// Looks isovalues up in the knots of a view. A drag moves an isovalue little, so each pixel keeps
// the place of its last knot.

class SurfaceLookup {
  // `pixels` are those that have knots.
  constructor(view, knots, pixels) {
    this.view = view;
    this.knots = knots;
    this.pixels = pixels;
    this.begins = { rising: this.beginsOf("rising"), falling: this.beginsOf("falling") };
    this.places = { rising: this.begins.rising.slice(), falling: this.begins.falling.slice() };
    this.distances = new Float32Array(pixels.length); // -1: no surface
    this.normals = new Float32Array(3 * pixels.length);
    this.table = normalsOf(view.normalSteps);
  }

  // Where the knots of each of `pixels` begin. Between them no pixel has knots.
  beginsOf(direction) {
    const { start } = this.knots[direction], count = this.pixels.length;
    const begins = new Uint32Array(count + 1);
    for (let i = 0; i < count; ++i) {
      begins[i] = start[this.pixels[i]];
    }
    begins[count] = this.view.knots[direction];
    return begins;
  }

  // The progress of an isovalue in a direction, in steps.
  progressOf(direction, isovalue) {
    const [low, high] = this.view.range, { margin, step } = this.view.progress;
    const difference = isovalue - low;
    return margin + (direction === "rising" ? difference : high - low - difference) / step;
  }

  // Distances and normals of an isovalue, for each of `pixels`.
  lookUp(isovalue) {
    const { entries } = this.knots;
    const rising = this.progressOf("rising", isovalue);
    if (!entries) {
      this.lookUpIn("rising", rising, null, rising);
      return;
    }
    this.distances.fill(-1);
    this.lookUpIn("rising", rising, (entry) => !(entry > rising), rising);
    this.lookUpIn("falling", this.progressOf("falling", isovalue), (entry) => entry > rising);
  }

  // \param isMeant tells by its entry whether a pixel is looked up; null: all are
  lookUpIn(direction, progress, isMeant) {
    const { pixels, distances, normals, table, knots: { entries } } = this;
    const { progress: reached, data } = this.knots[direction];
    const begins = this.begins[direction], places = this.places[direction];
    const side = 2 * this.view.normalSteps + 1, middle = 3 * this.view.normalSteps * (side + 1);
    const wanted = Math.ceil(progress); // knots have whole numbers
    const count = pixels.length, step = this.view.distanceStep;
    for (let i = 0; i < count; ++i) {
      if (isMeant && !isMeant(entries[pixels[i]])) {
        continue;
      }
      const begin = begins[i], end = begins[i + 1];
      let knot = places[i];
      while (knot < end && reached[knot] < wanted) {
        ++knot;
      }
      while (knot > begin && reached[knot - 1] >= wanted) {
        --knot;
      }
      places[i] = knot;
      if (knot === end) {
        distances[i] = -1;
        continue;
      }
      const normal = data[2 * knot + 1];
      let n = middle + 3 * ((normal >> 24) * side + ((normal << 8) >> 24));
      let x = table[n], y = table[n + 1], z = table[n + 2], distance = data[2 * knot];
      if (knot > begin) {
        const from = reached[knot - 1], before = data[2 * knot - 1];
        const share = (progress - from) / (reached[knot] - from), rest = 1 - share;
        // A parabola through the normals at both ends and half way.
        const a = rest * (rest - share), b = 4 * share * rest, c = share * (share - rest);
        const m = middle + 3 * (((normal << 16) >> 24) * side + ((normal << 24) >> 24));
        n = middle + 3 * ((before >> 24) * side + ((before << 8) >> 24));
        x = a * table[n] + b * table[m] + c * x;
        y = a * table[n + 1] + b * table[m + 1] + c * y;
        z = a * table[n + 2] + b * table[m + 2] + c * z;
        distance += rest * (data[2 * knot - 2] - distance);
        const scale = 1 / Math.sqrt(x * x + y * y + z * z);
        x *= scale;
        y *= scale;
        z *= scale;
      }
      distances[i] = distance * step;
      normals[3 * i] = x;
      normals[3 * i + 1] = y;
      normals[3 * i + 2] = z;
    }
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
