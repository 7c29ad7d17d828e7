"use strict";
/* Charts of studies: the numbers of the mark under the pointer or the focus, in a line below the chart. */

document.querySelectorAll("figure.chart").forEach((figure) => {
  const line = figure.querySelector(".readout");
  const usual = line.textContent;
  const show = (event) => {
    const mark = event.target.closest("[data-note]");
    line.textContent = mark ? mark.dataset.note : usual;
  };
  ["pointerover", "focusin"].forEach((name) => figure.addEventListener(name, show));
  ["pointerleave", "focusout"].forEach((name) => figure.addEventListener(name, () => (line.textContent = usual)));
});
