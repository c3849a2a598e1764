// Colors of the page, and preparation of canvases.

export function isDark() {
  return document.documentElement.dataset.theme === "dark";
}
export function colour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim();
}
/** Color of an episode, a rate class or an element, by its number. */
export function shade(number) {
  return colour(`c${number % 8}`);
}

/**
 * Fits the canvas to its place on the screen and clears it. Returns its context, or null if it is too small to be seen.
 */
export function prepare(canvas, width, height) {
  if (width < 2 || height < 2) return null;
  const scale = window.devicePixelRatio || 1;
  const w = Math.round(width * scale), h = Math.round(height * scale);
  if (canvas.width !== w || canvas.height !== h) {
    canvas.width = w;
    canvas.height = h;
    canvas.style.width = `${width}px`;
    canvas.style.height = `${height}px`;
  }
  const context = canvas.getContext("2d");
  context.setTransform(scale, 0, 0, scale, 0, 0);
  context.clearRect(0, 0, width, height);
  context.font = "12px system-ui, 'Segoe UI', Roboto, 'Liberation Sans', Arial, sans-serif";
  context.textBaseline = "middle";
  return context;
}

/** Returns a function that calls `draw` once before the next frame, however often it is called. */
export function onFrame(draw) {
  let asked = false;
  return () => {
    if (asked) return;
    asked = true;
    requestAnimationFrame(() => {
      asked = false;
      draw();
    });
  };
}
