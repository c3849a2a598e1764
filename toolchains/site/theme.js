// Before anything is painted: the theme that was chosen here, else the system's. A wide screen has the navigation open.
"use strict";
(() => {
  const root = document.documentElement;
  const system = matchMedia("(prefers-color-scheme: dark)");
  const kept = () => {
    try {
      return localStorage.getItem("theme");
    } catch {
      return null;  // a browser may keep nothing of file://
    }
  };
  const show = () => (root.dataset.theme = kept() ?? (system.matches ? "dark" : "light"));
  show();
  system.addEventListener("change", show);
  addEventListener("DOMContentLoaded", () => {
    document.getElementById("theme").addEventListener("click", () => {
      const other = root.dataset.theme === "dark" ? "light" : "dark";
      try {
        localStorage.setItem("theme", other);
      } catch {
        // only this page then
      }
      root.dataset.theme = other;
    });
    const menu = document.querySelector(".menu");
    const wide = matchMedia("(min-width: 52.01rem)");
    const open = () => (menu.open = wide.matches);
    open();
    wide.addEventListener("change", open);
    document.querySelector("nav.site [aria-current]")?.scrollIntoView({block: "nearest"});
  });
})();
