// Unpacks the knots of a view: `progress` of each, and two words of `data`: its distance, and four
// bytes with the octahedral coordinates of its normal and of the one half way from the knot before.

// Inflates a section; never beyond the size that it says.
async function unpack(sections, section) {
  const packed = sections.subarray(section.offset, section.offset + section.bytes);
  const reader = new Blob([packed]).stream()
    .pipeThrough(new DecompressionStream("deflate")).getReader();
  const bytes = new Uint8Array(section.unpacked);
  let length = 0;
  try {
    for (;;) {
      const { done, value } = await reader.read();
      if (done) {
        break;
      }
      if (value.length > bytes.length - length) {
        await reader.cancel();
        throw new WrongFile("A section is larger than it says.");
      }
      bytes.set(value, length);
      length += value.length;
    }
  } catch (error) {
    throw error instanceof WrongFile ? error
      : new WrongFile("A section is damaged: its checksum is wrong.");
  }
  require(length === bytes.length, "A section is smaller than it says.");
  return bytes;
}

// Where a chunk's streams are, and numbers from them.
class Streams {
  constructor(bytes, knots) {
    const damaged = "A chunk is damaged: the lengths of its parts are wrong.";
    require(bytes.length >= 20, damaged);
    const lengths = new DataView(bytes.buffer, bytes.byteOffset, 20);
    this.bytes = bytes;
    this.at = [];
    this.end = [];
    let begin = 20;
    for (let stream = 0; stream < 5; ++stream) {
      const length = lengths.getUint32(4 * stream, true);
      require(length <= bytes.length - begin, damaged);
      this.at.push(begin);
      this.end.push(begin + length);
      begin += length;
    }
    require(begin === bytes.length && this.end[1] - this.at[1] === knots &&
      this.end[4] - this.at[4] === 4 * knots, damaged);
  }

  // The next signed number of a stream.
  number(stream) {
    const bytes = this.bytes, end = this.end[stream];
    let at = this.at[stream], value = 0, scale = 1;
    for (;;) {
      require(at < end && scale < 2 ** 42, "A chunk is damaged: it ends too early.");
      const byte = bytes[at++];
      if (byte < 128) {
        value += byte * scale;
        break;
      }
      value += (byte & 127) * scale;
      scale *= 128;
    }
    this.at[stream] = at;
    return value % 2 === 0 ? value / 2 : -(value + 1) / 2;
  }

  isUsed() {
    return this.at[0] === this.end[0] && this.at[2] === this.end[2] && this.at[3] === this.end[3];
  }
}

// The fit of a neighbour, from fit().
let fitDistance = 0, fitU = 0, fitV = 0;

// The fit at a progress, of a ray whose first knot of at least this progress is `at`.
function fit({ progress, data }, begin, end, at, wanted, isJump) {
  if (at === end) {
    return false;
  }
  if (progress[at] === wanted) {
    while (isJump && at + 1 < end && progress[at + 1] === wanted) {
      ++at;
    }
    const normal = data[2 * at + 1];
    fitDistance = data[2 * at];
    fitU = normal >> 24;
    fitV = (normal << 8) >> 24;
    return true;
  }
  if (at === begin) {
    return false;
  }
  const share = wanted - progress[at - 1], gained = progress[at] - progress[at - 1];
  const before = data[2 * at - 1], behind = data[2 * at + 1], distance = data[2 * at - 2];
  const u = before >> 24, v = (before << 8) >> 24;
  fitDistance = distance + Math.floor((data[2 * at] - distance) * share / gained);
  fitU = u + Math.floor(((behind >> 24) - u) * share / gained);
  fitV = v + Math.floor((((behind << 8) >> 24) - v) * share / gained);
  return true;
}

// Reads how many knots pixels have: start[pixel + 1] from start[first pixel].
function readCounts(streams, view, chunk, start) {
  const width = view.size[0];
  let pixel = chunk.first * width, sum = start[pixel];
  const most = sum + chunk.knots;
  for (let row = 0; row < chunk.rows; ++row) {
    let count = 0;
    for (let x = 0; x < width; ++x) {
      count += streams.number(0);
      sum += count;
      require(count >= 0 && sum <= most,
        "A chunk is damaged: it does not say how many knots pixels have.");
      start[++pixel] = sum;
    }
  }
  require(sum === most, "A chunk is damaged: it does not say how many knots pixels have.");
}

// Decodes a chunk. `start` is known up to its first pixel.
function decodeChunk(bytes, view, chunk, knots) {
  const { start, progress: places, data } = knots;
  const streams = new Streams(bytes, chunk.knots);
  readCounts(streams, view, chunk, start);
  const width = view.size[0], first = chunk.first * width, end = first + chunk.rows * width;
  const largest = view.progress.largest;
  let token = streams.at[1], normal = streams.at[4];
  for (let pixel = first; pixel < end; ++pixel) {
    const begin = start[pixel], ends = start[pixel + 1];
    if (begin === ends) {
      continue;
    }
    const hasLeft = (pixel - first) % width > 0, hasBelow = pixel >= first + width;
    const hasDiagonal = hasLeft && hasBelow;
    const leftBegin = hasLeft ? start[pixel - 1] : 0, leftEnd = hasLeft ? begin : 0;
    const belowBegin = hasBelow ? start[pixel - width] : 0;
    const belowEnd = hasBelow ? start[pixel - width + 1] : 0;
    const diagonalBegin = hasDiagonal ? start[pixel - width - 1] : 0;
    const diagonalEnd = hasDiagonal ? belowBegin : 0;
    let leftNext = leftBegin, leftAt = leftBegin, belowNext = belowBegin, belowAt = belowBegin;
    let diagonalAt = diagonalBegin, last = -1, wasJump = false, distance = 0, u = 0, v = 0;
    for (let knot = begin; knot < ends; ++knot, ++token, ++normal) {
      while (leftNext < leftEnd && places[leftNext] <= last) {
        ++leftNext;
      }
      while (belowNext < belowEnd && places[belowNext] <= last) {
        ++belowNext;
      }
      const leftProgress = leftNext < leftEnd ? places[leftNext] : -1;
      const belowProgress = belowNext < belowEnd ? places[belowNext] : -1;
      const kind = bytes[token];
      let progress = -1;
      if (kind === 0) {
        progress = leftProgress;
      } else if (kind === 1) {
        progress = belowProgress;
      } else if (kind === 2) {
        progress = last;
      } else if (kind === 3) {
        progress = streams.number(2) + (leftProgress >= 0 ? leftProgress
          : belowProgress >= 0 ? belowProgress : Math.max(last, 0));
      }
      const isJump = kind === 2;
      require(progress >= 0 && progress <= largest && (isJump ? !wasJump : progress > last),
        "A chunk is damaged: a knot is impossible.");
      wasJump = isJump;

      while (leftAt < leftEnd && places[leftAt] < progress) {
        ++leftAt;
      }
      while (belowAt < belowEnd && places[belowAt] < progress) {
        ++belowAt;
      }
      while (diagonalAt < diagonalEnd && places[diagonalAt] < progress) {
        ++diagonalAt;
      }
      const fitsDiagonal = fit(knots, diagonalBegin, diagonalEnd, diagonalAt, progress, isJump);
      const diagonal = fitDistance;
      const fitsLeft = fit(knots, leftBegin, leftEnd, leftAt, progress, isJump);
      const left = fitDistance, leftU = fitU, leftV = fitV;
      const fitsBelow = fit(knots, belowBegin, belowEnd, belowAt, progress, isJump);
      const below = fitDistance, belowU = fitU, belowV = fitV;
      const begins = last < 0, lastU = u, lastV = v;
      let expected = 0;
      if (fitsLeft && fitsBelow && fitsDiagonal) {
        const low = Math.min(left, below), high = Math.max(left, below);
        expected = diagonal >= high ? low : diagonal <= low ? high : left + below - diagonal;
      } else {
        expected = fitsLeft ? left : fitsBelow ? below : last >= 0 ? distance + 8 : 0;
      }
      distance = expected + streams.number(3);
      require(distance >= 0 && distance < 2 ** 31, "A chunk is damaged: a knot is impossible.");
      const takesLeft = fitsLeft && Math.abs(left - distance) < 40;
      const takesBelow = fitsBelow && Math.abs(below - distance) < 40;
      if (takesLeft && takesBelow) {
        u = (leftU + belowU) >> 1;
        v = (leftV + belowV) >> 1;
      } else if (takesLeft) {
        u = leftU;
        v = leftV;
      } else if (takesBelow) {
        u = belowU;
        v = belowV;
      }
      u = (u + bytes[normal]) << 24 >> 24;
      v = (v + bytes[normal + chunk.knots]) << 24 >> 24;
      const middleU = bytes[normal + 2 * chunk.knots] + (begins || isJump ? u : (lastU + u) >> 1);
      const middleV = bytes[normal + 3 * chunk.knots] + (begins || isJump ? v : (lastV + v) >> 1);
      places[knot] = progress;
      data[2 * knot] = distance;
      data[2 * knot + 1] = (u << 24) | ((v & 255) << 16) | ((middleU & 255) << 8) | (middleV & 255);
      last = progress;
    }
  }
  require(streams.isUsed(), "A chunk is damaged: it holds more than its knots.");
}

// The knots of one direction. `pause` is awaited after each chunk.
async function decodeDirection(view, direction, sections, pause) {
  const pixels = view.size[0] * view.size[1];
  const start = new Uint32Array(pixels + 1);
  const progress = new Uint16Array(view.knots[direction]);
  const data = new Int32Array(2 * view.knots[direction]);
  const knots = { start, progress, data };
  let done = 0; // pixels whose start is known
  const goTo = (pixel) => {
    start.fill(start[done], done, pixel + 1);
    done = pixel;
  };
  for (const chunk of view.chunks.filter((each) => each.direction === direction)) {
    goTo(chunk.first * view.size[0]);
    decodeChunk(await unpack(sections, chunk), view, chunk, knots);
    done = (chunk.first + chunk.rows) * view.size[0];
    await pause();
  }
  goTo(pixels);
  return knots;
}

function decodeEntries(bytes, width) {
  const entries = new Uint16Array(bytes.length / 2);
  for (let i = 0; i < entries.length; ++i) {
    entries[i] = (i % width === 0 ? 0 : entries[i - 1]) + bytes[i] +
      256 * bytes[i + entries.length];
  }
  return entries;
}

// All that is known of a view's pixels.
async function decodeView(view, sections, pause) {
  return {
    rising: await decodeDirection(view, "rising", sections, pause),
    falling: await decodeDirection(view, "falling", sections, pause),
    entries: view.entries ? decodeEntries(await unpack(sections, view.entries), view.size[0])
      : null,
    unknown: view.unknown ? await unpack(sections, view.unknown) : null,
  };
}
