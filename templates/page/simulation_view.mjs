// The view that runs the graph's module of WebAssembly.
import {Simulation} from "../../targets/wasm/simulation.js";

import {onFrame} from "./canvas.mjs";
import {data} from "./data.mjs";
import {add, button, card, el, pairs, segment, tiles} from "./elements.mjs";
import {LivePlots} from "./growing_plots.mjs";
import {LiveHistory} from "./history.mjs";

import {count, seconds, short} from "./numbers.mjs";
import {state} from "./selection.mjs";
import {ActionControls, StateControls} from "./simulation_controls.mjs";
import {moreViews} from "./views.mjs";

const live = {
  simulation: null,
  playing: false,
  speed: 1,
  driver: "zero",
  drivers: new Set(),  // of this run
  episode: 0,
  steps: 0,      // of the episode
  behind: 0,     // simulated seconds that the picture is behind
  before: null,  // time of the last frame, ms
  broken: ""     // why it can run no more
};
const kBudget_ms = 12;  // of a frame

function stepLength_s() {
  const [num, den] = live.simulation.about.rate;
  return den / num;
}

/** What the module does when it traps is the end of it. */
function guarded(action) {
  if (live.broken) return 0;
  try {
    return action();
  } catch (problem) {
    live.broken = `The simulation has stopped: ${problem.message}. Load the page again.`;
    play(false);
    tell(live.broken);
    return 0;
  }
}

/** A run begins as a program that has just been started. */
const beginRun = () => guarded(() => {
  const text = live.seed.value.trim();
  const seed = /^\d{1,20}$/.test(text) ? BigInt(text) : 1n;
  live.seed.value = seed;
  live.simulation.begin(seed, {watched: true});
  live.episode = -1;
  live.drivers.clear();
  nextEpisode();
});

const nextEpisode = () => guarded(() => {
  if (!live.simulation.reset()) return tell("A state is outside of its space.");
  ++live.episode;
  live.steps = 0;
  live.behind = 0;
  live.plots.history = new LiveHistory(live.simulation.about.messages, stepLength_s());
  live.plots.history.add(live.simulation.messages);
  live.states.show();
  // A slider that was moved stays where it is.
  if (live.driver !== "hand")
    live.actions.show();
  else
    live.simulation.actions.set(live.hand);
  showLive();
});

/** At most `steps`, while there is time for it; how many it were. */
const advance = (steps, until = Infinity) => guarded(() => {
  let done = 0;
  while (done < steps && performance.now() < until) {
    if (live.driver === "hand") live.simulation.actions.set(live.hand);
    if (live.simulation.step(live.driver) === 0) break;
    live.drivers.add(live.driver);
    live.plots.history.add(live.simulation.messages);
    ++done;
  }
  live.steps += done;
  if (live.simulation.ended) play(false);
  showLive();
  return done;
});

function play(playing) {
  if (playing && live.broken) return;
  if (playing && live.simulation.ended) nextEpisode();
  live.playing = playing;
  live.button.textContent = playing ? "Pause" : "Play";
  live.before = null;
  if (playing) requestAnimationFrame(liveFrame);
}

function liveFrame(now) {
  if (!live.playing) return;
  if (state.view.id === "simulation") {
    const step_s = stepLength_s(), until = performance.now() + kBudget_ms;
    if (live.before !== null) live.behind += Math.min(0.25, (now - live.before) * 1e-3) * live.speed;
    const wanted = live.speed === Infinity ? Infinity : Math.floor(live.behind / step_s + 1e-6);
    const done = wanted > 0 ? advance(wanted, until) : 0;
    // What this machine is too slow for is left out.
    live.behind = done === wanted ? live.behind - done * step_s : 0;
  }
  live.before = now;
  requestAnimationFrame(liveFrame);
}

// ---- What is shown --------------------------------------------------------------------------------------------------
function tell(text) {
  live.message.textContent = text;
}

function drawPicture() {
  if (!live.canvas) return;
  const side = Math.floor(live.canvas.parentElement.getBoundingClientRect().width);
  const pixels = Math.min(1024, Math.round(side * (window.devicePixelRatio || 1)));
  if (pixels < 2) return;
  if (live.canvas.width !== pixels) live.canvas.width = live.canvas.height = pixels;
  const picture = live.simulation.picture(pixels, pixels);
  if (picture) live.canvas.getContext("2d").putImageData(new ImageData(picture, pixels, pixels), 0, 0);
}

/** What gives the same hash on Linux; or why no command does. */
function sameOnLinux() {
  const [driver] = live.drivers;
  if (!live.drivers.size) return "";
  if (live.drivers.size > 1 || driver === "hand") return "no command: several, or a hand, have decided";
  if (live.episode > 0 || live.states.any) return "no command: more than one episode, or states were set";
  const file = /^[\w.-]+$/.test(data.source.name) ? data.source.name : "GRAPH";
  return `eagerx-gen run ${file} -- --seed ${live.seed.value} --steps ${live.steps} --agent ${driver} --hash` +
      live.states.tuned.map((option) => ` ${option}`).join("");
}

const showLive = onFrame(() => {
  if (live.broken) return;
  const {simulation} = live, {about} = simulation;
  drawPicture();
  live.plots.draw();
  if (live.driver !== "hand") live.actions.show();
  const counts = Object.entries(simulation.counts).map(([name, value]) => `${name}: ${count(value)}`);
  live.facts.replaceChildren(tiles([
    ["episode", count(live.episode)], ["step", count(live.steps)], ["time", seconds(live.steps * stepLength_s())],
    ...about.outcome.map((field) => [field.name, short(simulation.outcome[field.first])])
  ]));
  live.hash.textContent = simulation.hash;
  live.same.textContent = sameOnLinux();
  tell([simulation.ended ? "The episode has ended." : "", ...counts].filter(Boolean).join(" · "));
});

// ---- The view -------------------------------------------------------------------------------------------------------
function drive(driver) {
  live.driver = driver;
  if (driver === "hand") live.hand = live.simulation.actions.slice();
}

function driverChoices(about) {
  return [
    about.policy ? ["policy", "Policy"] : null, ["zero", "Zero"], ["random", "Random"],
    about.actions.length ? ["hand", "By hand"] : null
  ].filter(Boolean);
}

function liveToolbar(about) {
  live.button = button("Play", () => play(!live.playing), {id: "play"});
  live.seed = el("input", {type: "text", inputMode: "numeric", value: "1", size: 8, "aria-label": "Seed", id: "seed"});
  live.seed.addEventListener("keydown", (event) => {
    if (event.key === "Enter") beginRun();
  });
  const choices = driverChoices(about);
  drive((choices.find(([name]) => name === about.agent) || choices[0])[0]);
  live.driverChoice = segment("Who decides", choices, live.driver, drive);
  return el(
      "div.toolbar", {}, live.button, button("Step", () => advance(1), {id: "step"}),
      button("Next episode", nextEpisode, {id: "next"}),
      button("Reset", beginRun, {id: "reset", title: "From the first episode on"}), el("label", {}, "seed ", live.seed),
      live.driverChoice, segment("Speed", [[0.25, "¼×"], [1, "1×"], [4, "4×"], [Infinity, "Fastest"]], 1, (speed) => {
        live.speed = speed;
        live.behind = 0;
      }));
}

function showSimulation(panel, simulation) {
  live.simulation = simulation;
  const {about} = simulation;
  live.message = el("p.note", {role: "status"});
  live.facts = el("div");
  live.hash = el("code", {id: "hash"});
  live.same = el("code.same");
  live.plots = new LivePlots(about.messages);
  live.actions = new ActionControls(simulation, () => {
    live.hand = simulation.actions.slice();
    if (live.driver !== "hand") live.driverChoice.choose("hand");
  });
  live.states = new StateControls(simulation, () => live.episode < 0 || simulation.ended ? null : live.steps);
  live.canvas = about.render ? el("canvas", {role: "img", "aria-label": "What render: shows"}) : null;
  const toolbar = liveToolbar(about);
  panel.replaceChildren();
  add(panel, [
    toolbar,
    el("div.bench", {},
       el("div", {}, live.canvas ? el("div.picture", {}, live.canvas) : null, live.actions.element,
          live.states.element),
       el("div", {},
          card("", live.facts, pairs([["trace hash", live.hash], ["the same on Linux", live.same]]), live.message),
          live.plots.chooser, live.plots.stage))
  ]);
  beginRun();
}

function makeSimulationView(panel) {
  const said =
      el("p.note", {},
         "The simulation starts … If this stays here, its module does not come back from a call: close this page.");
  panel.append(said);
  const start = () => {
    const bytes = Uint8Array.from(atob(data.module), (c) => c.charCodeAt(0));
    Simulation.of(bytes).then((simulation) => showSimulation(panel, simulation)).catch((problem) => {
      said.textContent = `The simulation cannot run here: ${problem.message}`;
      panel.replaceChildren(said);
    });
  };
  // A call of the module cannot be interrupted, so what is said must have been painted before.
  requestAnimationFrame(() => setTimeout(start));
  const again = () => {
    if (live.plots) showLive();
  };
  return {shown: again, resized: again};
}
moreViews.set("simulation", makeSimulationView);
