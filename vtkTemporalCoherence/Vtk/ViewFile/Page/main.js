// Opens the page's view file, and shows its first view.

class Viewer {
  constructor({ header, sections }) {
    this.header = header;
    this.sections = sections;
    this.number = 0; // of the view
    this.pictures = [];
    this.isAsked = false;
    this.steps = []; // milliseconds of the last pictures
    this.takeLook();
    this.histogram = new Histogram(byId("histogram"), header);
  }

  get view() {
    return this.header.views[this.number];
  }

  surface() {
    return this.surfaces[this.chosen];
  }

  takeLook() {
    const { header } = this;
    this.surfaces = header.surfaces.map((surface) => ({ ...surface,
      isovalue: this.limited(surface.isovalue) }));
    this.material = { ...header.material };
    this.turned = [0, 0];
    this.chosen = 0;
  }

  limited(isovalue) {
    return Math.min(Math.max(isovalue, this.view.range[0]), this.view.range[1]);
  }

  withUnits(value) {
    const { units } = this.header;
    return shortNumber(value) + (units ? ` ${units}` : "");
  }

  async open() {
    let since = performance.now();
    const pause = async () => {
      if (performance.now() - since > 50) {
        await new Promise((resolve) => { setTimeout(resolve); });
        since = performance.now();
      }
    };
    if (!this.pictures[this.number]) {
      const { view, number } = this;
      const knots = await decodeView(view, this.sections, pause);
      this.pictures[number] = new Picture(byId("picture"), view, knots, this.header);
    }
    [byId("picture").width, byId("picture").height] = this.view.size;
    this.drawNow();
    this.drawHistogram();
  }

  drawNow() {
    const begin = performance.now();
    this.pictures[this.number].draw(this.surfaces, this.material,
      turnedLights(this.view.lights ?? this.header.lights, this.view, ...this.turned));
    this.steps.push(performance.now() - begin);
    this.steps.splice(0, this.steps.length - 100);
  }

  // Draws at the next refresh of the screen.
  redraw() {
    if (!this.isAsked && this.pictures[this.number]) {
      this.isAsked = true;
      requestAnimationFrame(() => {
        this.isAsked = false;
        this.drawNow();
        this.drawHistogram();
        this.controls.refresh();
      });
    }
  }

  drawHistogram() {
    this.histogram.draw(this.view, this.surfaces.map((surface) => surface.isovalue), this.chosen);
  }

  setIsovalue(isovalue) {
    const surface = this.surface();
    surface.isovalue = this.limited(isovalue);
    if (!surface.isOwnColor) {
      surface.color = colorAt(this.header.colors, surface.isovalue) ?? surface.color;
    }
    byId("told").textContent = `Isovalue ${this.withUnits(surface.isovalue)}`;
    this.redraw();
  }

  turnLight(across, up) {
    this.turned = [this.turned[0] + across, this.turned[1] + up];
    this.redraw();
  }

  pick(x, y) {
    const hit = this.pictures[this.number]?.pick(x, y);
    byId("told").textContent = !hit ? "No surface there."
      : `Isovalue ${this.withUnits(this.surfaces[hit.surface].isovalue)}, depth ` +
        `${shortNumber(hit.depth)}, at (${hit.place.map(shortNumber).join(", ")})`;
    return hit ?? null;
  }

  choose(number) {
    this.chosen = number;
    this.redraw();
  }

  addSurface() {
    const [low, high] = this.view.range, isovalue = (this.surface().isovalue + high) / 2;
    this.surfaces.push({ isovalue: Math.max(isovalue, low), opacity: 1,
      color: colorAt(this.header.colors, isovalue) ?? this.surface().color });
    this.surfaces[this.chosen].opacity = Math.min(this.surfaces[this.chosen].opacity, 0.4);
    this.choose(this.surfaces.length - 1);
  }

  removeSurface() {
    this.surfaces.splice(this.chosen, 1);
    this.choose(Math.min(this.chosen, this.surfaces.length - 1));
  }

  resetLook() {
    this.takeLook();
    this.redraw();
  }

  async showNextView() {
    if (this.header.views.length < 2) {
      return;
    }
    this.number = (this.number + 1) % this.header.views.length;
    this.surfaces.forEach((surface) => { surface.isovalue = this.limited(surface.isovalue); });
    byId("told").textContent = this.view.name;
    try {
      await this.open();
      this.controls.refresh();
    } catch (error) {
      tellFailure(error);
    }
  }

  tellAbout() {
    const [width, height] = this.view.size, [low, high] = this.view.range;
    byId("about").textContent = `${width} x ${height} pixels, isovalues from ` +
      `${this.withUnits(low)} to ${this.withUnits(high)}. Surfaces lie within ` +
      `${shortNumber(this.view.tolerance)} voxels of the true ones. Without the volume.`;
  }
}

function tellFailure(error) {
  byId("message").textContent = error instanceof WrongFile ? error.message
    : error instanceof RangeError ? "There is not enough memory for this picture."
      : `This page cannot show its picture: ${error.message}`;
  document.documentElement.dataset.state = "failed";
}

async function start() {
  try {
    if (typeof DecompressionStream === "undefined") {
      throw new WrongFile("This browser is too old: it cannot unpack the data of this picture.");
    }
    const element = byId("view-file");
    let file;
    try {
      file = bytesOfBase64(element.textContent);
    } catch {
      throw new WrongFile("The data of this page are damaged: they are no Base64.");
    }
    element.remove();
    const viewer = new Viewer(readContainer(file));
    viewer.tellAbout();
    await viewer.open();
    viewer.controls = new Controls(viewer);
    viewer.controls.refresh();
    byId("poster").remove();
    byId("picture").hidden = false;
    byId("message").textContent = "";
    document.documentElement.dataset.state = "ready";
    // For scripts that embed this page, and for tests.
    globalThis.isosurfaceView = viewer;
  } catch (error) {
    tellFailure(error);
  }
}

start();
