// Looks isovalues up in the knots of a view. A drag moves an isovalue little, so each pixel keeps
// the place of its last knot.

class SurfaceLookup {
  // `pixels` are those that have knots.
  constructor(view, knots, pixels) {
    this.view = view;
    this.knots = knots;
    this.pixels = pixels;
    this.places = { rising: this.firstPlaces("rising"), falling: this.firstPlaces("falling") };
    this.distances = new Float32Array(pixels.length); // -1: no surface
    this.normals = new Float32Array(3 * pixels.length);
    this.table = normalsOf(view.normalSteps);
  }

  firstPlaces(direction) {
    const { start } = this.knots[direction];
    return this.view.knots[direction] > 0 ? this.pixels.map((pixel) => start[pixel]) : null;
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
    const { start, words } = this.knots[direction];
    const places = this.places[direction];
    if (!places) {
      if (!isMeant) {
        distances.fill(-1);
      }
      return;
    }
    const side = 2 * this.view.normalSteps + 1, middle = this.view.normalSteps * (side + 1);
    const count = pixels.length, step = this.view.distanceStep;
    for (let i = 0; i < count; ++i) {
      const pixel = pixels[i];
      if (isMeant && !isMeant(entries[pixel])) {
        continue;
      }
      const begin = start[pixel], end = start[pixel + 1];
      let knot = places[i];
      while (knot < end && words[3 * knot] >>> 16 < progress) {
        ++knot;
      }
      while (knot > begin && words[3 * knot - 3] >>> 16 >= progress) {
        --knot;
      }
      places[i] = knot;
      if (knot === end) {
        distances[i] = -1;
        continue;
      }
      const word = words[3 * knot];
      let n = 3 * (middle + ((word << 16) >> 24) * side + ((word << 24) >> 24));
      let x = table[n], y = table[n + 1], z = table[n + 2], distance = words[3 * knot + 1];
      if (knot > begin) {
        const before = words[3 * knot - 3], from = before >>> 16, half = words[3 * knot + 2];
        const share = (progress - from) / ((word >>> 16) - from), rest = 1 - share;
        // A parabola through the normals at both ends and half way.
        const a = rest * (rest - share), b = 4 * share * rest, c = share * (share - rest);
        const m = 3 * (middle + ((half << 16) >> 24) * side + ((half << 24) >> 24));
        n = 3 * (middle + ((before << 16) >> 24) * side + ((before << 24) >> 24));
        x = a * table[n] + b * table[m] + c * x;
        y = a * table[n + 1] + b * table[m + 1] + c * y;
        z = a * table[n + 2] + b * table[m + 2] + c * z;
        distance += rest * (words[3 * knot - 2] - distance);
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
