"use strict";
/* What a reader decides about each scene, kept by the browser, and exported as a file that `vitrail bless --from` applies. */

VITRAIL.decisions = (() => {
  const page = JSON.parse(document.getElementById("run-data").textContent);
  const folder = decodeURIComponent(location.pathname).replace(/\/[^/]*$/, "").replace(page.depth ? /\/[^/]*$/ : /$^/, "");
  const key = `vitrail ${folder} ${page.run}`;
  let memory = {};

  /* A browser may refuse storage to pages from disk; the page's own memory then has to do. */
  const all = () => {
    try {
      return JSON.parse(localStorage.getItem(key) ?? "{}");
    } catch {
      return memory;
    }
  };
  const keep = (decisions) => {
    memory = decisions;
    try {
      localStorage.setItem(key, JSON.stringify(decisions));
    } catch {
      /* The page's memory has it. */
    }
  };

  return {
    all,
    of: (scene) => all()[scene] ?? { decision: "", because: "" },
    set(scene, content, change) {
      const decisions = all();
      const next = { decision: "", because: "", ...decisions[scene], ...change, content };
      if (next.decision || next.because) decisions[scene] = next;
      else delete decisions[scene];
      keep(decisions);
    },
    clear: () => keep({}),
    exported() {
      const decisions = Object.entries(all())
        .filter(([, entry]) => entry.decision)
        .sort(([a], [b]) => (a < b ? -1 : 1))
        .map(([scene, entry]) => ({ scene, ...entry }));
      return { vitrail_decisions: 1, folder, run: page.run, decisions };
    },
  };
})();

(() => {
  /* On the page of a scene: accept or reject, with a reason. */
  const form = document.getElementById("decide");
  if (form) {
    const { scene, content } = form.dataset;
    const show = () => {
      const known = VITRAIL.decisions.of(scene);
      form.querySelectorAll("[data-decision]").forEach((button) => {
        button.setAttribute("aria-pressed", String(button.dataset.decision === known.decision));
      });
      const reason = document.getElementById("because");
      if (document.activeElement !== reason) reason.value = known.because;
    };
    form.addEventListener("submit", (event) => event.preventDefault());
    form.querySelectorAll("[data-decision]").forEach((button) =>
      button.addEventListener("click", () => {
        const same = VITRAIL.decisions.of(scene).decision === button.dataset.decision;
        VITRAIL.decisions.set(scene, content, { decision: same ? "" : button.dataset.decision });
        show();
      }),
    );
    document.getElementById("because").addEventListener("input", (event) =>
      VITRAIL.decisions.set(scene, content, { because: event.target.value }),
    );
    VITRAIL.onKey({ a: () => form.querySelector("[data-decision=accept]").click(), r: () => form.querySelector("[data-decision=reject]").click() });
    show();
  }

  /* On the index: how many there are, and the file. */
  const summary = document.getElementById("decisions");
  if (summary) {
    const { decisions } = VITRAIL.decisions.exported();
    const count = (word) => decisions.filter((entry) => entry.decision === word).length;
    summary.hidden = decisions.length === 0;
    document.getElementById("decisions-count").textContent = `${count("accept")} accepted, ${count("reject")} rejected`;
    document.getElementById("export").addEventListener("click", () => {
      const text = `${JSON.stringify(VITRAIL.decisions.exported(), null, 2)}\n`;
      const link = document.createElement("a");
      link.href = URL.createObjectURL(new Blob([text], { type: "application/json" }));
      link.download = "decisions.json";
      link.click();
      URL.revokeObjectURL(link.href);
    });
    document.getElementById("forget").addEventListener("click", () => {
      VITRAIL.decisions.clear();
      summary.hidden = true;
    });
  }
})();
