// The tab of a loop, of a graph that is linear: its program does what the linear model says.
import assert from "node:assert/strict";
import test from "node:test";
import vm from "node:vm";

import {browserWith, passFrames} from "./dom.mjs";
import {pageOf} from "./generator.mjs";

test("the tab of a loop shows its margins, and the step response that the program simulates", () => {
  const {data, script} = pageOf("tests/linear/first_order.yaml", "--open", "controller.y");
  const [{step, simulated, margins}] = data.loops;
  assert.equal(simulated.size, 1, "the port has no range");
  assert.equal(simulated.step.length, step.length);
  simulated.step.forEach(([at, returned, sent], i) => {
    assert.equal(at, step[i][0]);
    assert.ok(Math.abs(returned - step[i][1]) < 1e-5 && Math.abs(sent - step[i][2]) < 1e-5, `at ${at} s`);
  });
  assert.ok(simulated.difference < 1e-9);

  const browser = browserWith(data);
  const context = vm.createContext(
      {...browser.globals, atob, performance, TextDecoder, setTimeout: (call) => browser.timers.push(call)});
  context.window = context;
  vm.runInContext(script, context);
  passFrames(browser.frames);
  vm.runInContext("showView('loop')", context);
  passFrames(browser.frames);
  const panel = browser.document.getElementById("view-loop"), text = panel.textContent;
  assert.doesNotMatch(text, /undefined|\bNaN\b|\[object|\bnull\b/);
  assert.ok(text.includes(`${Number(margins.phase_deg.toPrecision(4))}°`), text);
  assert.match(text, /simulated step ?within .* %/);
  assert.match(text, /dashed: as the program simulates it/);
  for (const name of ["Nyquist plot", "poles"]) {
    const plot = panel.querySelectorAll("svg").find((each) => each.getAttribute("aria-label") === name);
    const grid =
        plot.querySelectorAll("path").filter((path) => path.classes.has("grid")).map((path) => path.getAttribute("d"));
    const [, left, right] = grid.map((d) => /^M(\S+) \S+H(\S+)$/.exec(d)).find(Boolean);
    const [, top, bottom] = grid.map((d) => /^M\S+ (\S+)V(\S+)$/.exec(d)).find(Boolean);
    assert.equal(right - left, bottom - top, `${name}: circles are round`);
  }
  const curves = panel.querySelectorAll("path").filter((path) => path.classes.has("simulated"));
  assert.equal(curves.length, 2, "T and S");
});
