// Pointer input: a tooltip next to the pointer, and drags.
import {el} from "./elements.mjs";

const tip = document.getElementById("tip");
export function showTip(event, lines) {
  tip.replaceChildren(...lines.filter(Boolean).map((line, i) => el(i ? "div" : "b", {}, line)));
  tip.hidden = false;
  const box = tip.getBoundingClientRect();
  tip.style.left = `${Math.min(event.clientX + 14, innerWidth - box.width - 8)}px`;
  tip.style.top = `${Math.min(event.clientY + 16, innerHeight - box.height - 8)}px`;
}
export function hideTip() {
  tip.hidden = true;
}

/** Handles drags: calls `moved(dx, dy, event)` during a drag, or `clicked(event)` if the pointer did not move. */
export function draggable(element, moved, clicked) {
  let from = null, far = false;
  element.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    from = [event.clientX, event.clientY];
    far = false;
  });
  element.addEventListener("pointermove", (event) => {
    if (!from) return;
    const [dx, dy] = [event.clientX - from[0], event.clientY - from[1]];
    if (!far && Math.hypot(dx, dy) < 4) return;
    if (!far) element.setPointerCapture(event.pointerId);
    far = true;
    from = [event.clientX, event.clientY];
    moved(dx, dy, event);
  });
  const end = (event) => {
    if (from && !far && event.type === "pointerup") clicked(event);
    from = null;
  };
  element.addEventListener("pointerup", end);
  element.addEventListener("pointercancel", end);
}
