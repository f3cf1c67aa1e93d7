// The picture of a view: its surfaces, composited over the background.

class Picture {
  constructor(canvas, view, knots, header) {
    this.view = view;
    this.knots = knots;
    this.header = header;
    this.pixels = pixelsWithKnots(view, knots);
    this.rays = new Rays(view);
    this.lookups = [];
    this.shader = new Shader(view, this.pixels);
    [canvas.width, canvas.height] = view.size;
    this.context = canvas.getContext("2d", { alpha: false });
    this.image = this.context.createImageData(...view.size);
    this.words = new Int32Array(this.image.data.buffer);
    this.background = this.backgroundOf();
    this.targets = this.pixels.map((pixel) => this.placeOf(pixel));
    this.words.set(this.background);
  }

  // Where a pixel lies in the image, whose rows go down.
  placeOf(pixel) {
    const [width, height] = this.view.size, x = pixel % width;
    return (height - 1 - (pixel - x) / width) * width + x;
  }

  backgroundOf() {
    const [width, height] = this.view.size, words = new Int32Array(width * height);
    const bytes = new Uint8ClampedArray(words.buffer);
    const bottom = this.header.background, top = this.header.background2 ?? bottom;
    for (let row = 0; row < height; ++row) {
      const share = height > 1 ? 1 - row / (height - 1) : 0;
      for (let c = 0; c < 3; ++c) {
        bytes[4 * row * width + c] = 255 * (bottom[c] + share * (top[c] - bottom[c]));
      }
      bytes[4 * row * width + 3] = 255;
      words.fill(words[row * width], row * width, (row + 1) * width);
    }
    return words;
  }

  // Draws surfaces: {isovalue, color, opacity}.
  draw(surfaces, material, lights) {
    while (this.lookups.length < surfaces.length) {
      this.lookups.push(new SurfaceLookup(this.view, this.knots, this.pixels));
    }
    this.lookups.length = surfaces.length;
    surfaces.forEach((surface, i) => this.lookups[i].lookUp(surface.isovalue));
    if (surfaces.length === 1 && surfaces[0].opacity >= 1) {
      this.shader.shade(this.lookups[0], surfaces[0].color, material, lights);
      this.showOpaque(this.lookups[0].distances, this.shader.colors);
    } else {
      this.composite(surfaces, material, lights);
    }
    this.context.putImageData(this.image, 0, 0);
  }

  showOpaque(distances, colors) {
    const { words, targets, background } = this, count = targets.length;
    for (let i = 0; i < count; ++i) {
      const target = targets[i];
      words[target] = distances[i] < 0 ? background[target] : colors[i];
    }
  }

  // From the back to the front, for each pixel.
  composite(surfaces, material, lights) {
    const layers = surfaces.map((surface, s) => {
      this.shader.shade(this.lookups[s], surface.color, material, lights);
      return { distances: this.lookups[s].distances, colors: this.shader.colors.slice(),
        opacity: surface.opacity };
    });
    const { targets, background } = this, bytes = this.image.data, order = [];
    for (let i = 0; i < targets.length; ++i) {
      const target = targets[i], back = background[target];
      let r = back & 255, g = (back >> 8) & 255, b = (back >> 16) & 255;
      order.length = 0;
      for (const layer of layers) {
        if (layer.distances[i] >= 0) {
          let at = order.length;
          order.push(layer);
          for (; at > 0 && order[at - 1].distances[i] < layer.distances[i]; --at) {
            order[at] = order[at - 1];
          }
          order[at] = layer;
        }
      }
      for (const { colors, opacity } of order) {
        const color = colors[i];
        r += opacity * ((color & 255) - r);
        g += opacity * (((color >> 8) & 255) - g);
        b += opacity * (((color >> 16) & 255) - b);
      }
      bytes[4 * target] = r;
      bytes[4 * target + 1] = g;
      bytes[4 * target + 2] = b;
      bytes[4 * target + 3] = 255;
    }
  }

  // What is at a pixel of the canvas: the nearest surface, its depth and place; or null.
  pick(x, y) {
    const [width, height] = this.view.size;
    const pixel = (height - 1 - Math.floor(y)) * width + Math.floor(x);
    let low = 0, high = this.pixels.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      [low, high] = this.pixels[middle] < pixel ? [middle + 1, high] : [low, middle];
    }
    if (this.pixels[low] !== pixel) {
      return null;
    }
    let surface = -1, distance = Infinity;
    this.lookups.forEach(({ distances }, i) => {
      if (distances[low] >= 0 && distances[low] < distance) {
        distance = distances[low];
        surface = i;
      }
    });
    if (surface < 0) {
      return null;
    }
    const { origin, direction, begin } = this.rays.of(pixel), depth = begin + distance;
    return { surface, depth, place: origin.map((value, c) => value + depth * direction[c]) };
  }
}
