// Colours by VTK's Phong model, as the mapper computes them.

// Lights turned around the camera: by `across` and `up`, in radians.
function turnedLights(lights, view, across, up) {
  const { forward } = view.rays;
  const right = normalized(view.rays.directionX.some((value) => value !== 0)
    ? view.rays.directionX : view.rays.originX);
  const upward = normalized(view.rays.directionY.some((value) => value !== 0)
    ? view.rays.directionY : view.rays.originY);
  const turn = (vector) => {
    let [x, y, z] = [dot(vector, right), dot(vector, upward), dot(vector, forward)];
    [x, z] = [x * Math.cos(across) + z * Math.sin(across),
      z * Math.cos(across) - x * Math.sin(across)];
    [y, z] = [y * Math.cos(up) + z * Math.sin(up), z * Math.cos(up) - y * Math.sin(up)];
    return [0, 1, 2].map((c) => x * right[c] + y * upward[c] + z * forward[c]);
  };
  const isTurned = across !== 0 || up !== 0;
  return lights.map((light) => ({
    ...light,
    direction: isTurned ? turn(light.direction) : light.direction,
  }));
}

function normalized(vector) {
  const length = Math.hypot(...vector) || 1;
  return vector.map((value) => value / length);
}

// A colour in one word. Channels go from 0 to 255; those beyond are clamped.
function packed(red, green, blue) {
  const r = red < 255 ? (red + 0.5) | 0 : 255;
  const g = green < 255 ? (green + 0.5) | 0 : 255;
  const b = blue < 255 ? (blue + 0.5) | 0 : 255;
  return (r > 0 ? r : 0) | ((g > 0 ? g : 0) << 8) | ((b > 0 ? b : 0) << 16) | 0xff000000;
}

// A table of powers of numbers from 0 to 1.
function powersOf(power) {
  const table = new Float32Array(1025);
  for (let i = 0; i < table.length; ++i) {
    table[i] = (i / 1024) ** power;
  }
  return table;
}

// Shades the surfaces that a lookup found. With one-sided light, those seen from inside are dark.
class Shader {
  constructor(view, pixels) {
    this.view = view;
    this.pixels = pixels;
    this.colors = new Int32Array(pixels.length); // 8 bits each, red lowest; opaque
  }

  // Sets `colors` for the hits of a lookup.
  shade(lookup, color, material, lights) {
    const { distances } = lookup;
    if (!material.shade) {
      for (let i = 0; i < distances.length; ++i) {
        this.colors[i] = packed(255 * color[0], 255 * color[1], 255 * color[2]);
      }
      return;
    }
    const isSimple = lights.length === 1 && !lights[0].positional;
    if (isSimple) {
      this.shadeSimply(lookup, color, material, lights[0]);
    } else {
      this.shadeByAll(lookup, color, material, lights);
    }
  }

  // One light from afar: as a headlight.
  shadeSimply({ distances, normals, kinds }, color, material, light) {
    const { view: { size: [width, height], rays }, pixels, colors } = this;
    const [lx, ly, lz] = light.direction.map((value) => -value);
    const ambient = color.map((value) => 255 * material.ambient * value);
    const diffuse = color.map((value, c) => 255 * material.diffuse * light.diffuse[c] * value);
    const shine = light.specular.map((value) => 255 * Math.max(material.specular, 0) * value);
    const [ar, ag, ab] = ambient, [dr, dg, db] = diffuse, [sr, sg, sb] = shine;
    const dark = material.twoSided === false ? FALLING : 0;
    const isShiny = sr !== 0 || sg !== 0 || sb !== 0;
    const most = 4095, matt = new Int32Array(most + 1); // colours by the cosine, without shine
    for (let step = 0; step <= most; ++step) {
      const cosine = step / most;
      matt[step] = packed(ar + cosine * dr, ag + cosine * dg, ab + cosine * db);
    }
    const powers = powersOf(material.specularPower);
    const [x0, y0, z0] = rays.direction, [xx, yx, zx] = rays.directionX;
    const [xy, yy, zy] = rays.directionY;
    const count = pixels.length, perX = 2 / width, perY = 2 / height;
    let row = -1, bx = 0, by = 0, bz = 0, rowBegin = 0;
    for (let i = 0; i < count; ++i) {
      if (distances[i] < 0) {
        continue;
      }
      const pixel = pixels[i];
      if (pixel - rowBegin >= width || row < 0) {
        row = Math.floor(pixel / width);
        rowBegin = row * width;
        const y = perY * row + 1 / height - 1;
        bx = x0 + y * xy;
        by = y0 + y * yy;
        bz = z0 + y * zy;
      }
      const x = perX * (pixel - rowBegin) + 1 / width - 1;
      const vx = bx + x * xx, vy = by + x * yx, vz = bz + x * zx;
      let nx = normals[3 * i], ny = normals[3 * i + 1], nz = normals[3 * i + 2];
      const length = Math.sqrt(nx * nx + ny * ny + nz * nz);
      const turn = nx * vx + ny * vy + nz * vz > 0 ? -1 : 1;
      const scale = ((kinds[i] & dark) === 0 ? turn : -turn) / length;
      nx *= scale;
      ny *= scale;
      nz *= scale;
      const cosine = nx * lx + ny * ly + nz * lz;
      if (!isShiny) {
        colors[i] = matt[cosine > 0 ? (most * cosine + 0.5) | 0 : 0];
        continue;
      }
      let r = ar, g = ag, b = ab;
      if (cosine > 0) {
        r += cosine * dr;
        g += cosine * dg;
        b += cosine * db;
        const twice = 2 * cosine;
        let mirrored = (lx - twice * nx) * vx + (ly - twice * ny) * vy + (lz - twice * nz) * vz;
        if (mirrored > 0) {
          mirrored = Math.min(mirrored / Math.sqrt(vx * vx + vy * vy + vz * vz), 1);
          const place = 1024 * mirrored, low = place | 0;
          const power = powers[low] + (place - low) * (powers[low < 1024 ? low + 1 : low] -
            powers[low]);
          r += power * sr;
          g += power * sg;
          b += power * sb;
        }
      }
      colors[i] = packed(r, g, b);
    }
  }

  // Any lights.
  shadeByAll({ distances, normals, kinds }, color, material, lights) {
    const { pixels, colors, view } = this, rays = new Rays(view);
    for (let i = 0; i < pixels.length; ++i) {
      if (distances[i] < 0) {
        continue;
      }
      const { origin, direction, begin } = rays.of(pixels[i]);
      let normal = normalized([normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]]);
      const isInside = material.twoSided === false && (kinds[i] & FALLING) !== 0;
      normal = dot(normal, direction) > 0 !== isInside ? normal.map((value) => -value) : normal;
      const sum = color.map((value) => material.ambient * value);
      for (const light of lights) {
        const depth = begin + distances[i];
        const toLight = light.positional
          ? normalized([0, 1, 2].map((c) =>
            light.position[c] - origin[c] - depth * direction[c]))
          : light.direction.map((value) => -value);
        const cosine = dot(normal, toLight);
        if (!(cosine > 0)) {
          continue;
        }
        const mirrored = toLight.map((value, c) => value - 2 * cosine * normal[c]);
        const shine = Math.min(Math.max(dot(mirrored, direction), 0), 1) ** material.specularPower;
        for (let c = 0; c < 3; ++c) {
          sum[c] += cosine * material.diffuse * light.diffuse[c] * color[c] +
            shine * Math.max(material.specular, 0) * light.specular[c];
        }
      }
      colors[i] = packed(255 * sum[0], 255 * sum[1], 255 * sum[2]);
    }
  }
}
