"use strict";
/* Light or dark, the dialog of keys, and the copy buttons: what both kinds of page share. */

(() => {
  const root = document.documentElement;
  const system = matchMedia("(prefers-color-scheme: dark)");

  /* Show the theme of the address, or else that of the system. */
  const show = () => {
    const theme = VITRAIL.get("theme");
    if (theme === "light" || theme === "dark") root.dataset.theme = theme;
    else delete root.dataset.theme;
  };
  const isDark = () => VITRAIL.get("theme", system.matches ? "dark" : "light") === "dark";
  const flip = () => VITRAIL.set({ theme: isDark() ? "light" : "dark" }, { theme: system.matches ? "dark" : "light" });

  VITRAIL.onChange(show);
  VITRAIL.isDark = isDark;

  document.addEventListener("DOMContentLoaded", () => {
    const help = document.getElementById("help");
    const open = () => (help.open ? help.close() : help.showModal());
    document.getElementById("theme").addEventListener("click", flip);
    document.getElementById("keys").addEventListener("click", open);
    VITRAIL.onKey({ t: flip, "?": open });

    /* A link between pages carries the theme along. */
    document.addEventListener("click", (event) => {
      const link = event.target.closest("a[href$='.html']");
      if (link && VITRAIL.get("theme")) link.hash = `theme=${VITRAIL.get("theme")}`;
    });

    document.querySelectorAll("[data-copy]").forEach((button) => {
      button.addEventListener("click", async () => {
        try {
          await navigator.clipboard.writeText(button.dataset.copy);
          button.textContent = "Copied";
        } catch {
          getSelection().selectAllChildren(button.previousElementSibling);
          button.textContent = "Selected";
        }
        setTimeout(() => (button.textContent = "Copy"), 1500);
      });
    });
  });
})();
