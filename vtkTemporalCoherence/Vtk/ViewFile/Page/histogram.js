// The histogram, and the marks of isovalues in it.

class Histogram {
  constructor(canvas, header) {
    this.canvas = canvas;
    this.header = header;
  }

  // The values at the left and the right.
  rangeOf(view) {
    const [low, high] = view.range;
    return low < high ? [low, high] : [low - 0.5, high + 0.5];
  }

  valueAt(view, share) {
    const [low, high] = this.rangeOf(view);
    return Math.min(Math.max(low + share * (high - low), view.range[0]), view.range[1]);
  }

  draw(view, isovalues, chosen) {
    const { canvas } = this, ratio = globalThis.devicePixelRatio || 1;
    const width = Math.max(Math.round(canvas.clientWidth * ratio), 1);
    const height = Math.max(Math.round(canvas.clientHeight * ratio), 1);
    if (canvas.width !== width || canvas.height !== height) {
      [canvas.width, canvas.height] = [width, height];
    }
    const style = getComputedStyle(document.documentElement);
    const context = canvas.getContext("2d");
    context.clearRect(0, 0, width, height);
    context.fillStyle = style.getPropertyValue("--bars");
    this.drawBars(context, view, width, height);
    const [low, high] = this.rangeOf(view);
    isovalues.forEach((isovalue, i) => {
      const x = (isovalue - low) / (high - low) * width;
      const thick = (i === chosen ? 3 : 1.5) * ratio;
      context.fillStyle = style.getPropertyValue("--mark");
      context.fillRect(Math.min(Math.max(x - thick / 2, 0), width - thick), 0, thick, height);
    });
  }

  drawBars(context, view, width, height) {
    const histogram = this.header.histogram, [low, high] = this.rangeOf(view);
    if (!histogram || histogram.counts.length === 0) {
      return;
    }
    const [first, last] = histogram.range, { counts } = histogram;
    const each = (last - first) / counts.length;
    const isSeen = (i) => first + (i + 1) * each > low && first + i * each < high;
    const heights = counts.map((count, i) => (isSeen(i) ? Math.sqrt(count) : 0));
    const most = Math.max(...heights) || 1;
    heights.forEach((bar, i) => {
      // Whole pixels: else a line shows between bars.
      const x = Math.round((first + i * each - low) / (high - low) * width);
      const end = Math.round((first + (i + 1) * each - low) / (high - low) * width);
      context.fillRect(x, height * (1 - 0.95 * bar / most), Math.max(end - x, 1),
        height * 0.95 * bar / most);
    });
  }
}
