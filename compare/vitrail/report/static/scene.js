"use strict";
/* The page of one scene: controls, keys and the readout around the stage. Everything chosen is in the address. */

(() => {
  const data = JSON.parse(document.getElementById("viewer-data").textContent);
  const element = document.getElementById("stage");
  const stage = new VITRAIL.Stage(element, data);
  const by = (id) => document.getElementById(id);
  const views = [...document.querySelectorAll(".views [data-view]")];
  const defaults = { against: data.sides[1], view: views[0].dataset.view, stops: data.stops, divider: 0.5, zoom: 1, get x() { return frame().width / 2; }, get y() { return frame().height / 2; } };
  /* The scene's own picture, or that of one observation. */
  const frame = () => data.pictures[VITRAIL.get("picture")] ?? data;
  const set = (changes) => VITRAIL.set(changes, defaults);
  const number = (key) => {
    const value = Number(VITRAIL.get(key, defaults[key]));
    return Number.isFinite(value) ? value : defaults[key];
  };
  const isOn = (key) => VITRAIL.get(key) === "on";
  const toggle = (key) => set({ [key]: isOn(key) ? null : "on" });

  /* In the views of errors the exposure starts at 0 stops: there it is the scale of the colours. */
  const isError = (view) => view === "difference" || view === "error";

  VITRAIL.onChange(() => {
    const picture = data.pictures[VITRAIL.get("picture")] ? VITRAIL.get("picture") : "";
    const asked = VITRAIL.get("view", defaults.view);
    /* Of a close-up there is no map of visible errors; its difference says the same. */
    const wanted = picture && asked === "error" ? "difference" : asked;
    const view = views.some((button) => button.dataset.view === wanted) ? wanted : defaults.view;
    const stops = isError(view) ? Number(VITRAIL.get("scale", 0)) : number("stops");
    const against = VITRAIL.get("against");
    const pair = [data.sides[0], data.sides.includes(against) ? against : (data.sides[1] ?? data.sides[0])];
    const look = {
      view, pair, stops, picture, divider: number("divider"), falseColour: isOn("colour"), second: isOn("second"),
      outlines: isOn("outlines"), patch: VITRAIL.get("patch"), layer: picture ? "" : VITRAIL.get("layer"),
    };
    if (picture) Object.values(data.pictures[picture].scripts).forEach((names) => VITRAIL.load(names));
    if (look.layer) data.sides.forEach((side) => VITRAIL.load(data.layers[`${side}.${look.layer}`]));
    stage.zoom = Math.min(Math.max(number("zoom"), 0.25), 256);
    stage.centre = [number("x"), number("y")];
    stage.probe = VITRAIL.get("pixel") ? VITRAIL.get("pixel").split(",").map(Number) : stage.hover ?? null;
    stage.show(look);
    showControls(look);
    showReadout();
  });
  VITRAIL.onTile = () => {
    stage.sources.clear();
    stage.redraw();
    showReadout();
  };

  function showControls(look) {
    views.forEach((button) => {
      button.setAttribute("aria-checked", String(button.dataset.view === look.view));
      button.tabIndex = button.dataset.view === look.view ? 0 : -1;
    });
    by("stops").value = look.stops;
    by("stops-value").textContent = `${look.stops > 0 ? "+" : ""}${String(look.stops).replace("-", "−")}`;
    by("false-colour").setAttribute("aria-pressed", String(look.falseColour));
    by("outlines").checked = look.outlines;
    if (by("layer")) Object.assign(by("layer"), { value: look.layer, disabled: look.picture !== "" });
    if (by("picture")) by("picture").value = look.picture;
    if (by("against")) by("against").value = look.pair[1];
    by("zoom-value").textContent = `${Math.round(stage.zoom * 100)} %`;
    by("slider").hidden = look.view !== "slider";
    by("slider").value = look.divider;
    showScale(look);
  }

  /* The colours of an error view or of false colour, with what their ends mean. */
  function showScale(look) {
    const bar = by("scale");
    bar.hidden = !(isError(look.view) || look.falseColour);
    if (bar.hidden) return;
    const signed = look.view === "difference";
    const reach = Number((0.2 / 2 ** look.stops * 100).toPrecision(3));
    const top = Number((1 / 2 ** look.stops).toPrecision(3));
    const ends = signed ? [`−${reach} %`, `+${reach} %`] : look.view === "error" ? ["0", `${top}`] : [`${Number((top / 1024).toPrecision(2))}`, `${top} W sr⁻¹ m⁻²`];
    bar.querySelectorAll("span").forEach((label, index) => (label.textContent = ends[index]));
    const context = bar.querySelector("canvas").getContext("2d");
    const row = context.createImageData(256, 1);
    for (let i = 0; i < 256; i++) {
      VITRAIL.colour.between(signed ? data.maps.signed : data.maps.heat, i / 255, row.data, 4 * i);
      row.data[4 * i + 3] = 255;
    }
    context.putImageData(row, 0, 0);
  }

  /* The radiance of the probed pixel on every side, as stored: six figures shown, all of them in the title. */
  function showReadout() {
    const pixel = stage.probe;
    by("probe").textContent = pixel ? `pixel ${pixel[0]}, ${pixel[1]}` : "pixel";
    document.querySelectorAll("#readout [data-side]").forEach((row) => {
      const image = VITRAIL.image(stage.look ? stage.name(row.dataset.side) : row.dataset.side);
      [...row.cells].slice(1, 4).forEach((cell, channel) => {
        const known = image && pixel;
        const value = known ? image.values[(pixel[1] * image.width + pixel[0]) * image.channels + channel] : null;
        cell.textContent = known ? written(value) : "";
        cell.title = known ? String(value) : "";
      });
    });
  }
  const written = (value) => (value === 0 ? "0" : Math.abs(value) >= 1e-3 && Math.abs(value) < 1e5 ? value.toPrecision(6) : value.toExponential(5)).replace("-", "−");

  function probe(pixel, keep) {
    stage.hover = pixel;
    if (keep || VITRAIL.get("pixel")) set({ pixel: keep && pixel ? pixel.join(",") : null });
    stage.probe = pixel;
    stage.redraw();
    showReadout();
  }

  /* Zoom about a point that stays where it is. */
  function zoom(factor, about = stage.centre) {
    const next = Math.min(Math.max(stage.zoom * factor, 0.25), 256);
    const kept = stage.zoom / next;
    const [x, y] = [0, 1].map((axis) => about[axis] + (stage.centre[axis] - about[axis]) * kept);
    set({ zoom: Number(next.toPrecision(4)), x: Number(x.toFixed(2)), y: Number(y.toFixed(2)) });
  }
  const fit = () => set({ zoom: null, x: null, y: null, patch: null });

  /* Another picture has its own pixels: what was zoomed and probed in the last one means nothing there. */
  const show = (picture) => set({ picture, zoom: null, x: null, y: null, patch: null, pixel: null });

  function showPatch(name) {
    if (VITRAIL.get("picture")) show("");
    const outline = data.outlines[name] ?? [];
    if (!outline.length) return;
    const [xs, ys] = [0, 1].map((axis) => outline.map((corner) => corner[axis]));
    const middle = (values) => (Math.min(...values) + Math.max(...values)) / 2;
    const extent = (values) => Math.max(Math.max(...values) - Math.min(...values), 1);
    const fitting = Math.min(data.width / extent(xs), data.height / extent(ys)) * 0.8;
    set({ patch: name, zoom: Number(Math.max(fitting, 1).toPrecision(3)), x: middle(xs), y: middle(ys) });
    element.scrollIntoView({ block: "center" });
  }

  /* Pointer: hover probes, drag moves, wheel zooms, click keeps the probe in the address. */
  let drag = null;
  element.addEventListener("pointermove", (event) => {
    const at = stage.pixelAt(event);
    if (drag) {
      drag.moved = true;
      const [x, y] = [drag.centre[0] - (event.clientX - drag.x) / at.scale, drag.centre[1] - (event.clientY - drag.y) / at.scale];
      set({ x: Number(x.toFixed(2)), y: Number(y.toFixed(2)) });
    } else if (!VITRAIL.get("pixel") && at.pixel) probe(at.pixel, false);
  });
  element.addEventListener("pointerdown", (event) => {
    if (event.target.closest("input, button") || event.button !== 0) return;
    drag = { x: event.clientX, y: event.clientY, centre: [...stage.centre], moved: false };
    element.setPointerCapture(event.pointerId);
  });
  element.addEventListener("pointerup", (event) => {
    if (drag && !drag.moved) probe(stage.pixelAt({ clientX: event.clientX, clientY: event.clientY, target: document.elementFromPoint(event.clientX, event.clientY) }).pixel, !VITRAIL.get("pixel"));
    drag = null;
  });
  element.addEventListener("wheel", (event) => {
    event.preventDefault();
    const at = stage.pixelAt(event);
    zoom(2 ** (-event.deltaY / 300), [at.x, at.y]);
  }, { passive: false });

  const move = (dx, dy) => (event) => {
    if (event.target.closest("[role=radiogroup], input[type=range]")) return;
    const step = event.shiftKey ? 10 : 1;
    const [x, y] = stage.probe ?? [Math.floor(frame().width / 2), Math.floor(frame().height / 2)];
    const hold = (value, size) => Math.min(Math.max(value, 0), size - 1);
    probe([hold(x + dx * step, frame().width), hold(y + dy * step, frame().height)], true);
  };
  const view = (index) => () => views[index] && set({ view: views[index].dataset.view });
  const expose = (by) => {
    const error = isError(stage.look.view);
    set(error ? { scale: Number(VITRAIL.get("scale", 0)) + by || null } : { stops: number("stops") + by });
  };
  const flip = () => set({ view: "flip", second: isOn("second") ? null : "on" });
  const slide = (by) => set({ view: "slider", divider: Math.min(Math.max(number("divider") + by, 0), 1).toFixed(3) });
  const go = (id) => () => by(id)?.click();

  views.forEach((button, index) => button.addEventListener("click", () => (button.dataset.view === "flip" && stage.look.view === "flip" ? flip() : view(index)())));
  document.querySelector(".views").addEventListener("keydown", (event) => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    const next = views[(views.findIndex((button) => button.tabIndex === 0) + step + views.length) % views.length];
    set({ view: next.dataset.view });
    next.focus();
  });
  by("stops").addEventListener("input", () => set(isError(stage.look.view) ? { scale: Number(by("stops").value) || null } : { stops: by("stops").value }));
  by("slider").addEventListener("input", () => set({ divider: by("slider").value }));
  by("false-colour").addEventListener("click", () => toggle("colour"));
  by("outlines").addEventListener("change", () => toggle("outlines"));
  by("against")?.addEventListener("change", () => set({ against: by("against").value }));
  by("layer")?.addEventListener("change", () => set({ layer: by("layer").value }));
  by("picture")?.addEventListener("change", () => show(by("picture").value));
  document.querySelectorAll("[data-picture]").forEach((button) => button.addEventListener("click", () => {
    show(button.dataset.picture);
    element.scrollIntoView({ block: "center" });
  }));
  by("zoom-in").addEventListener("click", () => zoom(1.5));
  by("zoom-out").addEventListener("click", () => zoom(1 / 1.5));
  by("fit").addEventListener("click", fit);
  document.querySelectorAll("[data-show]").forEach((button) => button.addEventListener("click", () => showPatch(button.dataset.show)));

  VITRAIL.onKey({
    1: view(0), 2: view(1), 3: view(2), 4: view(3), 5: view(4),
    f: flip, " ": flip, c: () => toggle("colour"), o: () => toggle("outlines"),
    e: () => expose(0.5), E: () => expose(-0.5), ",": () => slide(-0.02), ".": () => slide(0.02),
    ArrowLeft: move(-1, 0), ArrowRight: move(1, 0), ArrowUp: move(0, -1), ArrowDown: move(0, 1),
    "+": () => zoom(1.5), "=": () => zoom(1.5), "-": () => zoom(1 / 1.5), 0: fit,
    n: go("next"), p: go("previous"), u: go("up"),
  });
})();
