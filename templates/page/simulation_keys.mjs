// Keys of the keyboard that steer the simulation: `keys:` under `render:` of the graph.
import {el} from "./elements.mjs";
import {short} from "./numbers.mjs";

/** Keys are those of browsers; letters without regard to Shift. */
const keyName = (key) => key.length === 1 ? key.toLowerCase() : key;

/**
 * Each of `keys` ({key, parameter, add}) adds to a parameter while it is held: set(parameter, sum of what is held) is
 * called at each change. `active()`: whether the keyboard belongs to the simulation now.
 */
export class SteeringKeys {
  constructor(keys, active, set) {
    this.keys = new Map(keys.map((key) => [keyName(key.key), {...key, add: key.add.map(Number)}]));
    this.held = new Set();
    this.active = active;
    this.set = set;
    const list = [...this.keys.values()].map(
        ({key, parameter, add}) => [el("kbd", {}, key), ` ${parameter} ${add.map((x) => short(x)).join(", ")}  `]);
    this.element = this.keys.size ? el("p.note", {}, "While it is held, a key adds: ", list) : null;
    if (!this.keys.size) return;
    document.addEventListener("keydown", (event) => this.press(event), true);
    document.addEventListener("keyup", (event) => this.release(keyName(event.key)), true);
    window.addEventListener("blur", () => this.releaseAll());
  }

  press(event) {
    const name = keyName(event.key);
    if (!this.keys.has(name) || !this.active()) return;
    if (event.ctrlKey || event.metaKey || event.altKey || event.target.matches("input, select, textarea")) return;
    event.preventDefault();  // the page does not scroll
    event.stopImmediatePropagation();
    if (this.held.has(name)) return;  // repeated while it is held
    this.held.add(name);
    this.change(this.keys.get(name).parameter);
  }

  release(name) {
    if (this.held.delete(name)) this.change(this.keys.get(name).parameter);
  }
  releaseAll() {
    for (const name of [...this.held]) this.release(name);
  }

  /** Sums up the keys held for a parameter. */
  change(parameter) {
    const own = [...this.keys].filter(([, key]) => key.parameter === parameter);
    const sum = own[0][1].add.map(() => 0);
    for (const [name, {add}] of own) {
      if (this.held.has(name)) add.forEach((x, i) => sum[i] += x);
    }
    this.set(parameter, sum);
  }
}
