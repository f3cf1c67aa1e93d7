// Where the rays of a view go, and where they begin.

function dot(a, b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

function invert(m) {
  // Gauss-Jordan on the rows of an affine 4 x 4 matrix.
  const rows = [0, 1, 2, 3].map((r) => [...m.slice(4 * r, 4 * r + 4),
    ...[0, 1, 2, 3].map((c) => (c === r ? 1 : 0))]);
  for (let column = 0; column < 4; ++column) {
    let pivot = column;
    for (let r = column; r < 4; ++r) {
      pivot = Math.abs(rows[r][column]) > Math.abs(rows[pivot][column]) ? r : pivot;
    }
    [rows[column], rows[pivot]] = [rows[pivot], rows[column]];
    const scale = rows[column][column];
    rows[column] = rows[column].map((value) => value / scale);
    for (let r = 0; r < 4; ++r) {
      const factor = rows[r][column];
      if (r !== column) {
        rows[r] = rows[r].map((value, c) => value - factor * rows[column][c]);
      }
    }
  }
  return rows.flatMap((row) => row.slice(4));
}

class Rays {
  constructor(view) {
    this.view = view;
    const toIndex = invert(view.box.matrix);
    this.planes = [...(view.planes ?? [])];
    for (let axis = 0; axis < 3; ++axis) {
      const row = toIndex.slice(4 * axis, 4 * axis + 4);
      const { low, high } = view.box;
      this.planes.push([row[0], row[1], row[2], row[3] - low[axis]]);
      this.planes.push([-row[0], -row[1], -row[2], high[axis] - row[3]]);
    }
  }

  // The ray of a pixel: where it starts, its unit vector, and how far from there it begins.
  of(pixel) {
    const { size: [width, height], rays } = this.view;
    const x = (2 * (pixel % width) + 1) / width - 1;
    const y = (2 * Math.floor(pixel / width) + 1) / height - 1;
    const origin = [0, 1, 2].map((c) => rays.origin[c] + x * rays.originX[c] + y * rays.originY[c]);
    const along = [0, 1, 2].map((c) =>
      rays.direction[c] + x * rays.directionX[c] + y * rays.directionY[c]);
    const length = Math.hypot(...along), direction = along.map((value) => value / length);
    let begin = Math.max(rays.near / dot(direction, rays.forward), 0);
    for (const plane of this.planes) {
      const slope = dot(plane, direction);
      if (slope > 0) {
        begin = Math.max(begin, -(dot(plane, origin) + plane[3]) / slope);
      }
    }
    return { origin, direction, begin };
  }
}
