"use strict";
/* From radiance to screen colour: the project's display transform and its two colour maps. For looking, not measuring. */

VITRAIL.colour = (() => {
  /* sRGB curve of a linear value in 0..1, as 0..255 [IEC 61966-2-1]; tabulated, because it runs for every pixel. */
  const STEPS = 4096;
  const curve = new Uint8ClampedArray(STEPS + 1);
  for (let i = 0; i <= STEPS; i++) {
    const x = i / STEPS;
    curve[i] = 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * Math.pow(x, 1 / 2.4) - 0.055);
  }
  const srgb = (x) => {
    if (!(x > 0)) return 0;
    if (x >= 1) return 255;
    if (x < 0.01) return 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * Math.pow(x, 1 / 2.4) - 0.055);
    return curve[Math.round(x * STEPS)];
  };

  const luminance = (r, g, b) => 0.2126 * r + 0.7152 * g + 0.0722 * b;

  /* A colour at `position` in 0..1 between evenly spaced stations, written as three bytes. */
  const between = (stations, position, out, at) => {
    const x = Math.min(Math.max(position, 0), 1) * (stations.length - 1);
    const i = Math.min(Math.floor(x), stations.length - 2);
    for (let c = 0; c < 3; c++) out[at + c] = 255 * (stations[i][c] + (x - i) * (stations[i + 1][c] - stations[i][c]));
  };

  return { srgb, luminance, between };
})();
