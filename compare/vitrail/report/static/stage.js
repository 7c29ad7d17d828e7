"use strict";
/* The stage: one or two panes under one zoom, drawn from radiance. It knows pixels and the screen, nothing of the page. */

VITRAIL.Stage = class {
  constructor(element, data) {
    this.data = data;
    this.element = element;
    this.panes = [...element.querySelectorAll(".pane")].map((figure) => ({
      figure,
      canvas: figure.querySelector("canvas"),
      caption: figure.querySelector("figcaption"),
    }));
    this.sources = new Map();
    this.zoom = 1;
    this.centre = [data.width / 2, data.height / 2];
    this.probe = null;
    new ResizeObserver(() => this.redraw()).observe(element);
  }

  /* What is to be seen: view, exposure, false colour, layer, divider, which side a flip shows, outlines. */
  show(look) {
    this.look = look;
    this.sources.clear();
    this.redraw();
  }

  /* The picture that is looked at: the scene's own, or that of an observation. */
  get frame() {
    return this.data.pictures[this.look?.picture] ?? this.data;
  }

  name(side) {
    if (this.look.picture) return `${side}.close.${this.look.picture}`;
    return this.look.layer && this.data.layers[`${side}.${this.look.layer}`] ? `${side}.${this.look.layer}` : side;
  }

  /* A picture of one side in the size of the image, made once for each look. */
  source(key) {
    if (this.sources.has(key)) return this.sources.get(key);
    const { width, height } = this.frame;
    const canvas = Object.assign(document.createElement("canvas"), { width, height });
    const context = canvas.getContext("2d");
    const picture = context.createImageData(width, height);
    const filled = key === "difference" ? this.fillDifference(picture.data) : key === "error" ? this.fillError(picture.data) : this.fill(picture.data, key);
    if (!filled) return null;
    context.putImageData(picture, 0, 0);
    this.sources.set(key, canvas);
    return canvas;
  }

  fill(out, side) {
    const image = VITRAIL.image(this.name(side));
    if (!image) return false;
    const { srgb, luminance, between } = VITRAIL.colour;
    const gain = 2 ** this.look.stops;
    const values = image.values;
    for (let i = 0, at = 0; at < out.length; i += 3, at += 4) {
      if (this.look.falseColour) {
        /* Ten stops up to white: each station of the map is two stops. */
        const level = luminance(values[i], values[i + 1], values[i + 2]) * gain;
        between(this.data.maps.heat, level > 0 ? 1 + Math.log2(level) / 10 : 0, out, at);
      } else {
        for (let c = 0; c < 3; c++) out[at + c] = srgb(values[i + c] * gain);
      }
      out[at + 3] = 255;
    }
    return true;
  }

  /* Signed relative difference (a - b) / (|a| + |b|) * 2 of the mean channel; the exposure narrows the scale. */
  fillDifference(out) {
    const [a, b] = this.look.pair.map((side) => VITRAIL.image(this.name(side)));
    if (!a || !b) return false;
    const gain = 2 ** this.look.stops / 0.2;
    for (let i = 0, at = 0; at < out.length; i += 3, at += 4) {
      const x = a.values[i] + a.values[i + 1] + a.values[i + 2];
      const y = b.values[i] + b.values[i + 1] + b.values[i + 2];
      const size = (Math.abs(x) + Math.abs(y)) / 2;
      VITRAIL.colour.between(this.data.maps.signed, size > 0 ? 0.5 + ((x - y) / size) * gain * 0.5 : 0.5, out, at);
      out[at + 3] = 255;
    }
    return true;
  }

  fillError(out) {
    const image = VITRAIL.image("error");
    if (!image) return false;
    const gain = 2 ** this.look.stops;
    for (let i = 0, at = 0; at < out.length; i += 1, at += 4) {
      VITRAIL.colour.between(this.data.maps.heat, image.values[i] * gain, out, at);
      out[at + 3] = 255;
    }
    return true;
  }

  /* Which pictures lie on which panes in this view: [key, caption]. */
  layout() {
    const [a, b] = this.look.pair;
    const named = (side) => [side, this.data.names[side]];
    switch (this.look.view) {
      case "flip": return [[named(this.look.second ? b : a)], []];
      case "slider": return [[named(a), named(b)], []];
      case "difference": return [[["difference", `${this.data.names[a]} − ${this.data.names[b]}`]], []];
      case "error": return [[["error", "Visible error (HDR-FLIP)"]], []];
      default: return a === b ? [[named(a)], []] : [[named(a)], [named(b)]];
    }
  }

  redraw() {
    if (!this.look) return;
    const layout = this.layout();
    this.element.dataset.panes = layout.filter((pictures) => pictures.length).length;
    /* Give the panes their widths first: a pane is as wide as its hidden neighbours leave it. */
    this.panes.forEach((pane, index) => (pane.figure.hidden = layout[index].length === 0));
    this.panes.forEach((pane, index) => pane.figure.hidden || this.draw(pane, layout[index]));
  }

  /* Screen pixels per image pixel at zoom 1: the whole image fits. */
  scale(canvas) {
    return Math.min(canvas.width / this.frame.width, canvas.height / this.frame.height) * this.zoom;
  }

  draw(pane, pictures) {
    const { canvas, caption } = pane;
    const ratio = devicePixelRatio || 1;
    const box = pane.figure.getBoundingClientRect();
    canvas.width = Math.max(Math.round(box.width * ratio), 1);
    canvas.height = Math.max(Math.round(box.height * ratio), 1);
    const context = canvas.getContext("2d");
    const scale = this.scale(canvas);
    context.imageSmoothingEnabled = scale < 1;
    const x = canvas.width / 2 - this.centre[0] * scale;
    const y = canvas.height / 2 - this.centre[1] * scale;
    pictures.forEach(([key], index) => {
      const picture = this.source(key);
      if (!picture) return;
      context.save();
      if (index === 1) {
        const cut = x + this.look.divider * this.frame.width * scale;
        context.beginPath();
        context.rect(cut, 0, canvas.width - cut, canvas.height);
        context.clip();
      }
      context.drawImage(picture, x, y, this.frame.width * scale, this.frame.height * scale);
      context.restore();
    });
    this.drawMarks(context, pictures, x, y, scale, ratio);
    caption.textContent = pictures.map(([, name]) => name).join("  |  ");
  }

  drawMarks(context, pictures, x, y, scale, ratio) {
    context.lineWidth = ratio;
    if (pictures.length === 2) {
      const cut = x + this.look.divider * this.frame.width * scale;
      context.strokeStyle = "rgba(255,255,255,.9)";
      context.strokeRect(cut, 0, 0, context.canvas.height);
    }
    for (const [name, outline] of Object.entries(this.frame.outlines)) {
      if (!outline.length || !(this.look.outlines || this.look.patch === name)) continue;
      context.beginPath();
      outline.forEach(([px, py]) => context.lineTo(x + px * scale, y + py * scale));
      context.closePath();
      this.strokeTwice(context, ratio, this.look.patch === name ? "#ffd34d" : "#fff");
    }
    if (this.probe) {
      const [px, py] = this.probe;
      context.beginPath();
      context.rect(x + px * scale - ratio / 2, y + py * scale - ratio / 2, scale + ratio, scale + ratio);
      this.strokeTwice(context, ratio, "#fff");
    }
  }

  /* A light line inside a dark one is seen on any picture. */
  strokeTwice(context, ratio, colour) {
    context.lineWidth = 3 * ratio;
    context.strokeStyle = "rgba(0,0,0,.55)";
    context.stroke();
    context.lineWidth = 1.25 * ratio;
    context.strokeStyle = colour;
    context.stroke();
  }

  /* The image pixel under a pointer, or null beside the image. */
  pixelAt(event) {
    const pane = this.panes.find((candidate) => !candidate.figure.hidden && candidate.figure.contains(event.target)) ?? this.panes[0];
    const box = pane.canvas.getBoundingClientRect();
    const scale = this.scale(pane.canvas) * (box.width / pane.canvas.width);
    const x = this.centre[0] + (event.clientX - box.left - box.width / 2) / scale;
    const y = this.centre[1] + (event.clientY - box.top - box.height / 2) / scale;
    const inside = x >= 0 && y >= 0 && x < this.frame.width && y < this.frame.height;
    return { x, y, scale, pixel: inside ? [Math.floor(x), Math.floor(y)] : null };
  }
};
