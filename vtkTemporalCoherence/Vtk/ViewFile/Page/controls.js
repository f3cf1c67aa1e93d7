// What the reader does: dragging, keys, buttons.

const byId = (id) => document.getElementById(id);

function hexOf(color) {
  return "#" + color.map((value) =>
    Math.round(255 * Math.min(Math.max(value, 0), 1)).toString(16).padStart(2, "0")).join("");
}

function colorOf(hex) {
  return [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16) / 255);
}

// The colour of a surface by its isovalue; null without colours in the file.
function colorAt(colors, isovalue) {
  if (!colors || colors.length === 0) {
    return null;
  }
  const next = colors.findIndex((color) => color[0] >= isovalue);
  if (next <= 0) {
    return colors[next === 0 ? 0 : colors.length - 1].slice(1);
  }
  const a = colors[next - 1], b = colors[next];
  const share = b[0] > a[0] ? (isovalue - a[0]) / (b[0] - a[0]) : 1;
  return [1, 2, 3].map((c) => a[c] + share * (b[c] - a[c]));
}

function shortNumber(value) {
  return Number(value.toPrecision(6)).toString();
}

// Calls `move` with the pointer while it is dragged from an element, and `click` if it did not move.
function onDrag(element, move, click) {
  let last = null, isMoved = false;
  element.addEventListener("pointerdown", (event) => {
    if (event.button === 0) {
      element.setPointerCapture(event.pointerId);
      last = event;
      isMoved = false;
      move(event, event, true);
    }
  });
  element.addEventListener("pointermove", (event) => {
    if (last) {
      isMoved ||= Math.hypot(event.clientX - last.clientX, event.clientY - last.clientY) > 2;
      if (isMoved) {
        move(event, last, false);
        last = event;
      }
    }
  });
  for (const name of ["pointerup", "pointercancel"]) {
    element.addEventListener(name, (event) => {
      if (last && !isMoved && name === "pointerup") {
        click(event);
      }
      last = null;
    });
  }
}

class Controls {
  constructor(viewer) {
    this.viewer = viewer;
    this.watchSlider();
    this.watchPicture();
    this.watchButtons();
    this.watchLook();
    document.addEventListener("keydown", (event) => this.onKey(event));
    // By the window, its scale, or a scroll bar.
    addEventListener("resize", () => viewer.drawHistogram());
    new ResizeObserver(() => viewer.drawHistogram()).observe(byId("histogram"));
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change",
      () => viewer.drawHistogram());
  }

  watchSlider() {
    const slider = byId("slider"), { viewer } = this;
    onDrag(slider, (event) => {
      const box = slider.getBoundingClientRect();
      viewer.setIsovalue(viewer.histogram.valueAt(viewer.view,
        (event.clientX - box.left) / box.width));
    }, () => {});
    slider.addEventListener("keydown", (event) => {
      const [low, high] = viewer.view.range, step = (high - low) / 256;
      const moves = { ArrowLeft: -step, ArrowDown: -step, ArrowRight: step, ArrowUp: step,
        PageDown: -16 * step, PageUp: 16 * step, Home: low - high, End: high - low };
      if (Object.hasOwn(moves, event.key)) {
        event.preventDefault();
        viewer.setIsovalue(viewer.surface().isovalue + moves[event.key]);
      }
    });
    byId("isovalue").addEventListener("change", (event) => {
      if (Number.isFinite(event.target.valueAsNumber)) {
        viewer.setIsovalue(event.target.valueAsNumber);
      }
    });
  }

  watchPicture() {
    const canvas = byId("picture"), { viewer } = this;
    const radians = Math.PI / 400; // for a pixel of the screen
    // What is light moves with the pointer, so the light turns the other way.
    onDrag(canvas, (event, last, isFirst) => {
      if (!isFirst) {
        viewer.turnLight(radians * (last.clientX - event.clientX),
          radians * (event.clientY - last.clientY));
      }
    }, (event) => {
      const box = canvas.getBoundingClientRect(), [width, height] = viewer.view.size;
      const scale = Math.min(box.width / width, box.height / height);
      viewer.pick((event.clientX - box.left - (box.width - scale * width) / 2) / scale,
        (event.clientY - box.top - (box.height - scale * height) / 2) / scale);
    });
    canvas.addEventListener("keydown", (event) => {
      const turns = { ArrowLeft: [0.1, 0], ArrowRight: [-0.1, 0], ArrowUp: [0, -0.1],
        ArrowDown: [0, 0.1] };
      if (Object.hasOwn(turns, event.key)) {
        event.preventDefault();
        viewer.turnLight(...turns[event.key]);
      } else if (event.key === "Enter") {
        viewer.pick(viewer.view.size[0] / 2, viewer.view.size[1] / 2);
      }
    });
  }

  watchButtons() {
    const { viewer } = this;
    byId("next").addEventListener("click", () => viewer.showNextView());
    byId("full").addEventListener("click", () => this.switchFullScreen());
    byId("save").addEventListener("click", () => this.save());
    byId("add").addEventListener("click", () => viewer.addSurface());
    byId("remove").addEventListener("click", () => viewer.removeSurface());
    byId("surface").addEventListener("change", (event) =>
      viewer.choose(event.target.selectedIndex));
  }

  watchLook() {
    const { viewer } = this;
    byId("color").addEventListener("input", (event) => {
      const surface = viewer.surface();
      surface.color = colorOf(event.target.value);
      surface.isOwnColor = true;
      viewer.redraw();
    });
    byId("opacity").addEventListener("input", (event) => {
      viewer.surface().opacity = event.target.valueAsNumber;
      viewer.redraw();
    });
    for (const [id, name] of [["ambient", "ambient"], ["diffuse", "diffuse"],
      ["specular", "specular"], ["power", "specularPower"]]) {
      byId(id).addEventListener("input", (event) => {
        viewer.material[name] = event.target.valueAsNumber;
        viewer.redraw();
      });
    }
    byId("reset").addEventListener("click", () => viewer.resetLook());
  }

  onKey(event) {
    if (event.ctrlKey || event.metaKey || event.altKey ||
        ["INPUT", "SELECT", "TEXTAREA"].includes(event.target.tagName)) {
      return;
    }
    const commands = { n: () => this.viewer.showNextView(), f: () => this.switchFullScreen(),
      s: () => this.save() };
    commands[event.key.toLowerCase()]?.();
  }

  switchFullScreen() {
    if (document.fullscreenElement) {
      document.exitFullscreen();
    } else {
      byId("figure").requestFullscreen?.().catch(() => {});
    }
  }

  save() {
    byId("picture").toBlob((blob) => {
      const link = document.createElement("a");
      link.href = URL.createObjectURL(blob);
      link.download = "isosurface.png";
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    }, "image/png");
  }

  // Show the state of the viewer in the controls.
  refresh() {
    const { viewer } = this, surface = viewer.surface(), [low, high] = viewer.view.range;
    const slider = byId("slider"), number = byId("isovalue"), list = byId("surface");
    slider.setAttribute("aria-valuemin", low);
    slider.setAttribute("aria-valuemax", high);
    slider.setAttribute("aria-valuenow", surface.isovalue);
    slider.setAttribute("aria-valuetext", viewer.withUnits(surface.isovalue));
    [number.min, number.max] = [low, high];
    number.value = shortNumber(surface.isovalue);
    list.replaceChildren(...viewer.surfaces.map((each, i) =>
      new Option(`${i + 1}: ${shortNumber(each.isovalue)}`, i, false, i === viewer.chosen)));
    byId("add").disabled = viewer.surfaces.length >= 8;
    byId("remove").disabled = viewer.surfaces.length < 2;
    byId("next").hidden = viewer.header.views.length < 2;
    byId("color").value = hexOf(surface.color);
    byId("opacity").value = surface.opacity;
    for (const [id, name] of [["ambient", "ambient"], ["diffuse", "diffuse"],
      ["specular", "specular"], ["power", "specularPower"]]) {
      byId(id).value = viewer.material[name];
    }
  }
}
