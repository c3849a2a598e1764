// The view of a simulation says what an endless call looks like before it calls the module.
import assert from "node:assert/strict";
import test from "node:test";

import {become, Element, smallData} from "./dom.mjs";

const {frames} = become({...smallData(), module: Buffer.from("<b>bad</b>").toString("base64")});
const timers = [];
let compiled = 0;
globalThis.setTimeout = (call) => timers.push(call);
await import("../../templates/page/simulation_view.mjs");
const {moreViews} = await import("../../templates/page/views.mjs");
const compile = WebAssembly.compile;  // Node itself compiles a module when it imports simulation.js
WebAssembly.compile = (bytes) => (++compiled, compile(bytes));

test("it is said and painted, then the module is called, and a problem is text", async () => {
  const panel = new Element("section");
  const {shown} = moreViews.get("simulation")(panel);
  assert.match(panel.textContent, /does not come back/);
  assert.deepEqual([compiled, frames.length], [0, 1]);
  frames.shift()();
  assert.deepEqual([compiled, timers.length], [0, 1]);
  shown();  // somebody comes back to it meanwhile
  timers.shift()();
  assert.equal(compiled, 1);
  for (let i = 0; i < 100000 && !panel.textContent.startsWith("The simulation cannot"); ++i)
    await new Promise(setImmediate);
  assert.match(panel.textContent, /^The simulation cannot run here: .*magic/s);
});
