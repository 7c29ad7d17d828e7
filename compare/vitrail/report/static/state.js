"use strict";
/* The state of a page lives in its address (#view=flip&stops=1), so that a link shows what its sender saw. */

const VITRAIL = {
  state: new Map(),
  listeners: [],

  read() {
    this.state = new Map(new URLSearchParams(location.hash.slice(1)));
    this.listeners.forEach((listener) => listener(this.state));
  },

  get(key, otherwise = "") {
    return this.state.has(key) ? this.state.get(key) : otherwise;
  },

  /* Set several keys at once; the value that `defaults` names is left out of the address. */
  set(changes, defaults = {}) {
    for (const [key, value] of Object.entries(changes)) {
      if (value === null || value === "" || String(value) === String(defaults[key] ?? "")) this.state.delete(key);
      else this.state.set(key, String(value));
    }
    const text = new URLSearchParams([...this.state]).toString();
    history.replaceState(null, "", text ? `#${text}` : location.pathname + location.search);
    this.listeners.forEach((listener) => listener(this.state));
  },

  onChange(listener) {
    this.listeners.push(listener);
    listener(this.state);
  },

  /* Keys act on the page unless somebody is typing or holds a modifier of the browser. */
  onKey(actions) {
    document.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
      const typing = event.target.closest("input[type=search], input[type=text], textarea, select, dialog");
      const action = typing ? null : actions[event.key];
      if (!action) return;
      if (event.key === " " && event.target.closest("button, summary, a")) return;
      event.preventDefault();
      action(event);
    });
  },
};

VITRAIL.read();
addEventListener("hashchange", () => VITRAIL.read());
