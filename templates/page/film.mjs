// Scenes of a trace in sequence.
import {kColumns} from "./scene.mjs";

/** Scenes of an episode. The page stores only the changes between them. */
export class Film {
  constructor({rate_hz, every, scenes, changes}) {
    const raw = atob(changes);
    this.view = new DataView(Uint8Array.from(raw, (c) => c.charCodeAt(0)).buffer);
    this.rate_hz = rate_hz;
    this.every = every;
    this.kept = [];  // every 64th scene, so that seeking backward is fast
    this.places = new Float64Array(scenes);
    this.ticks = new Float64Array(scenes);
    let at = 0, rows = 0;
    for (let i = 0; i < scenes; ++i) {
      this.ticks[i] = this.view.getUint32(at, true);
      this.places[i] = at;
      rows = Math.max(rows, this.view.getUint16(at + 4, true));
      at += 8 + 6 * this.view.getUint16(at + 6, true);
    }
    this.scene = new Float32Array(rows * kColumns);
    this.current = -1;
  }

  get end_s() {
    return (this.ticks[this.ticks.length - 1] + this.every) / this.rate_hz;
  }

  /** Index of the scene that is visible at a given time. */
  numberAt(time_s) {
    let [low, high] = [0, this.ticks.length - 1];
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.ticks[middle] <= time_s * this.rate_hz + 1e-6)
        low = middle;
      else
        high = middle - 1;
    }
    return low;
  }

  go(number) {
    if (number < this.current || number > this.current + 64) {
      const known = Math.min(number >> 6, this.kept.length - 1);
      if (known >= 0 && (number < this.current || 64 * known > this.current)) {
        this.scene.set(this.kept[known]);
        this.current = 64 * known;
      }
    }
    while (this.current < number) this.next();
    const rows = this.view.getUint16(this.places[number] + 4, true);
    return this.scene.subarray(0, rows * kColumns);
  }

  next() {
    const at = this.places[++this.current], count = this.view.getUint16(at + 6, true);
    for (let i = 0; i < count; ++i) {
      const place = at + 8 + 6 * i;
      this.scene[this.view.getUint16(place, true)] = this.view.getFloat32(place + 2, true);
    }
    if (this.current % 64 === 0 && this.kept.length === this.current >> 6) this.kept.push(this.scene.slice());
  }
}
