"use strict";
/* The index: filters, order and keyboard walk over the cards. All of it is in the address. */

(() => {
  const gallery = document.getElementById("gallery");
  const cards = [...gallery.querySelectorAll(".card")];
  const filters = [...document.querySelectorAll(".filter")];
  const find = document.getElementById("find");
  const sort = document.getElementById("sort");
  const none = document.getElementById("none");
  const defaults = { sort: "worst" };

  const shown = () => cards.filter((card) => !card.hidden).sort((a, b) => a.style.order - b.style.order);

  const passes = (card, state) =>
    (!state.get("verdict") || card.dataset.verdict === state.get("verdict")) &&
    (!state.get("phenomenon") || card.dataset.phenomena.split(" ").includes(state.get("phenomenon"))) &&
    card.dataset.text.includes((state.get("find") ?? "").toLowerCase());

  VITRAIL.onChange((state) => {
    const byName = (state.get("sort") ?? "worst") === "name";
    const names = cards.map((card) => card.dataset.name).sort();
    for (const card of cards) {
      card.hidden = !passes(card, state);
      card.style.order = byName ? names.indexOf(card.dataset.name) : card.dataset.rank;
    }
    for (const button of filters) {
      button.setAttribute("aria-pressed", String(state.get(button.dataset.filter) === button.dataset.value));
    }
    if (document.activeElement !== find) find.value = state.get("find") ?? "";
    sort.value = byName ? "name" : "worst";
    none.hidden = shown().length > 0;
  });

  const toggle = (key, value) => VITRAIL.set({ [key]: VITRAIL.get(key) === value ? null : value });
  const showAll = () => VITRAIL.set({ verdict: null, phenomenon: null, find: null });
  filters.forEach((button) => button.addEventListener("click", () => toggle(button.dataset.filter, button.dataset.value)));
  find.addEventListener("input", () => VITRAIL.set({ find: find.value }));
  find.addEventListener("keydown", (event) => event.key === "Escape" && (showAll(), find.blur()));
  sort.addEventListener("change", () => VITRAIL.set({ sort: sort.value }, defaults));
  document.getElementById("clear").addEventListener("click", showAll);

  /* Walk over the cards that are shown; the focus is the link, so Enter opens it. */
  const step = (by) => {
    const walk = shown();
    const here = walk.indexOf(document.activeElement.closest(".card"));
    const next = walk[here < 0 ? 0 : Math.min(Math.max(here + by, 0), walk.length - 1)];
    next?.querySelector("h2 a").focus();
  };
  VITRAIL.onKey({
    j: () => step(1),
    k: () => step(-1),
    d: () => toggle("verdict", "deviates"),
    i: () => toggle("verdict", "inconclusive"),
    a: () => toggle("verdict", "agrees"),
    p: () => document.querySelector(".also a")?.click(),
    "/": () => find.focus(),
    Escape: showAll,
  });
})();
