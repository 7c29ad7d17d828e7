"use strict";
/* Radiance of each side, decoded from the scripts that hold it: exactly the numbers of the EXR. */

(() => {
  const images = new Map();

  /* Half float to number; the table of all 65536 is made once. */
  let halves = null;
  const halfTable = () => {
    if (halves) return halves;
    halves = new Float32Array(65536);
    for (let bits = 0; bits < 65536; bits++) {
      const sign = bits & 0x8000 ? -1 : 1;
      const exponent = (bits >> 10) & 31;
      const fraction = bits & 1023;
      if (exponent === 31) halves[bits] = fraction ? NaN : sign * Infinity;
      else if (exponent === 0) halves[bits] = sign * fraction * 2 ** -24;
      else halves[bits] = sign * (1 + fraction / 1024) * 2 ** (exponent - 15);
    }
    return halves;
  };

  const decode = (head) => {
    const bytes = Uint8Array.from(atob(head.data), (letter) => letter.charCodeAt(0));
    if (head.type === "<f4") return new Float32Array(bytes.buffer);
    const table = halfTable();
    return Float32Array.from(new Uint16Array(bytes.buffer), (bits) => table[bits]);
  };

  /* Called by each script of pixels as it loads. */
  VITRAIL.tile = (side, head) => {
    if (!images.has(side)) {
      const values = new Float32Array(head.width * head.height * head.channels);
      images.set(side, { width: head.width, height: head.height, channels: head.channels, values, rows: 0 });
    }
    const image = images.get(side);
    image.values.set(decode(head), head.row * head.width * head.channels);
    image.rows += head.rows;
    VITRAIL.onTile?.(side);
  };

  VITRAIL.image = (side) => images.get(side);

  /* Load the scripts of a layer once; the stage draws again when they arrive. */
  const asked = new Set();
  VITRAIL.load = (names) => {
    for (const name of names ?? []) {
      if (asked.has(name)) continue;
      asked.add(name);
      const script = document.createElement("script");
      script.src = name;
      document.head.append(script);
    }
  };
})();
