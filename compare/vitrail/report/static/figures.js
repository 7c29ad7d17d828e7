"use strict";
/* The paper's figures: a walk with keys from one to the next. */

(() => {
  const plates = [...document.querySelectorAll(".plate")];
  const step = (by) => {
    const here = plates.indexOf(document.activeElement.closest(".plate"));
    const next = plates[here < 0 ? 0 : Math.min(Math.max(here + by, 0), plates.length - 1)];
    next.focus({ preventScroll: true });
    next.scrollIntoView();
  };
  VITRAIL.onKey({ j: () => step(1), k: () => step(-1), u: () => document.querySelector("[rel=up]").click() });
})();
