// View that runs the WebAssembly module of the graph.
import {Simulation} from "../../targets/wasm/simulation.js";

import {onFrame} from "./canvas.mjs";
import {data} from "./data.mjs";
import {add, button, card, el, pairs, segment, tiles} from "./elements.mjs";
import {GrowingPlots} from "./growing_plots.mjs";
import {StepHistory} from "./history.mjs";

import {count, seconds, short} from "./numbers.mjs";
import {state} from "./selection.mjs";
import {ActionControls, StateControls} from "./simulation_controls.mjs";
import {SteeringKeys} from "./simulation_keys.mjs";
import {moreViews} from "./views.mjs";

const simulated = {
  simulation: null,
  playing: false,
  speed: 1,
  driver: "zero",
  drivers: new Set(),  // used in this run
  episode: 0,
  steps: 0,      // in this episode
  behind: 0,     // simulated seconds by which the picture lags
  before: null,  // time of the last frame, ms
  broken: ""     // why the simulation cannot continue
};
const kBudget_ms = 12;  // per frame

function stepLength_s() {
  const [num, den] = simulated.simulation.about.rate;
  return den / num;
}

/** Calls the module. If it traps, the simulation ends. */
function guarded(action) {
  if (simulated.broken) return 0;
  try {
    return action();
  } catch (problem) {
    simulated.broken = `The simulation has stopped: ${problem.message}. Load the page again.`;
    play(false);
    tell(simulated.broken);
    return 0;
  }
}

/** Begins a run, in the state of a program that has just started. */
const beginRun = () => guarded(() => {
  const text = simulated.seed.value.trim();
  const seed = /^\d{1,20}$/.test(text) ? BigInt(text) : 1n;
  simulated.seed.value = seed;
  simulated.simulation.begin(seed, {watched: true});
  simulated.episode = -1;
  simulated.drivers.clear();
  nextEpisode();
});

const nextEpisode = () => guarded(() => {
  if (!simulated.simulation.reset()) return tell("A state is outside of its space.");
  ++simulated.episode;
  simulated.steps = 0;
  simulated.behind = 0;
  simulated.plots.history = new StepHistory(simulated.simulation.about.messages, stepLength_s());
  simulated.plots.history.add(simulated.simulation.messages);
  simulated.states.show();
  // A slider that the user moved stays where it is.
  if (simulated.driver !== "hand")
    simulated.actions.show();
  else
    simulated.simulation.actions.set(simulated.hand);
  showSimulated();
});

/** Simulates at most `steps` steps until the time is over, and returns their number. */
const advance = (steps, until = Infinity) => guarded(() => {
  let done = 0;
  while (done < steps && performance.now() < until) {
    if (simulated.driver === "hand") simulated.simulation.actions.set(simulated.hand);
    if (simulated.simulation.step(simulated.driver) === 0) break;
    simulated.drivers.add(simulated.driver);
    simulated.plots.history.add(simulated.simulation.messages);
    ++done;
  }
  simulated.steps += done;
  if (simulated.simulation.ended) play(false);
  showSimulated();
  return done;
});

function play(playing) {
  if (playing && simulated.broken) return;
  if (playing && simulated.simulation.ended) nextEpisode();
  simulated.playing = playing;
  simulated.button.textContent = playing ? "Pause" : "Play";
  simulated.before = null;
  if (playing) requestAnimationFrame(simulationFrame);
}

function simulationFrame(now) {
  if (!simulated.playing) return;
  if (state.view.id === "simulation") {
    const step_s = stepLength_s(), until = performance.now() + kBudget_ms;
    if (simulated.before !== null)
      simulated.behind += Math.min(0.25, (now - simulated.before) * 1e-3) * simulated.speed;
    const wanted = simulated.speed === Infinity ? Infinity : Math.floor(simulated.behind / step_s + 1e-6);
    const done = wanted > 0 ? advance(wanted, until) : 0;
    // Drops the time that this machine is too slow to simulate.
    simulated.behind = done === wanted ? simulated.behind - done * step_s : 0;
  }
  simulated.before = now;
  requestAnimationFrame(simulationFrame);
}

// ---- Display --------------------------------------------------------------------------------------------------------
function tell(text) {
  simulated.message.textContent = text;
}

function drawPicture() {
  if (!simulated.canvas) return;
  const side = Math.floor(simulated.canvas.parentElement.getBoundingClientRect().width);
  const pixels = Math.min(1024, Math.round(side * (window.devicePixelRatio || 1)));
  if (pixels < 2) return;
  if (simulated.canvas.width !== pixels) simulated.canvas.width = simulated.canvas.height = pixels;
  const picture = simulated.simulation.picture(pixels, pixels);
  if (picture) simulated.canvas.getContext("2d").putImageData(new ImageData(picture, pixels, pixels), 0, 0);
}

/** Command that gives the same hash on Linux, or the reason why there is none. */
function sameOnLinux() {
  const [driver] = simulated.drivers;
  if (!simulated.drivers.size) return "";
  if (simulated.drivers.size > 1 || driver === "hand") return "no command: several, or a hand, have decided";
  if (simulated.episode > 0 || simulated.states.any) return "no command: more than one episode, or states were set";
  const file = /^[\w.-]+$/.test(data.source.name) ? data.source.name : "GRAPH";
  return `eagerx-gen run ${file} -- --seed ${simulated.seed.value} --steps ${simulated.steps} --agent ${
             driver} --hash` +
      simulated.states.tuned.map((option) => ` ${option}`).join("");
}

const showSimulated = onFrame(() => {
  if (simulated.broken) return;
  const {simulation} = simulated, {about} = simulation;
  drawPicture();
  simulated.plots.draw();
  if (simulated.driver !== "hand") simulated.actions.show();
  const counts = Object.entries(simulation.counts).map(([name, value]) => `${name}: ${count(value)}`);
  simulated.facts.replaceChildren(tiles([
    ["episode", count(simulated.episode)], ["step", count(simulated.steps)],
    ["time", seconds(simulated.steps * stepLength_s())],
    ...about.outcome.map((field) => [field.name, short(simulation.outcome[field.first])])
  ]));
  simulated.hash.textContent = simulation.hash;
  simulated.same.textContent = sameOnLinux();
  tell([simulation.ended ? "The episode has ended." : "", ...counts].filter(Boolean).join(" · "));
});

// ---- View -----------------------------------------------------------------------------------------------------------
function drive(driver) {
  simulated.driver = driver;
  if (driver === "hand") simulated.hand = simulated.simulation.actions.slice();
}

function driverChoices(about) {
  return [
    about.policy ? ["policy", "Policy"] : null, ["zero", "Zero"], ["random", "Random"],
    about.actions.length ? ["hand", "By hand"] : null
  ].filter(Boolean);
}

function simulationToolbar(about) {
  simulated.button = button("Play", () => play(!simulated.playing), {id: "play"});
  simulated.seed =
      el("input", {type: "text", inputMode: "numeric", value: "1", size: 8, "aria-label": "Seed", id: "seed"});
  simulated.seed.addEventListener("keydown", (event) => {
    if (event.key === "Enter") beginRun();
  });
  const choices = driverChoices(about);
  drive((choices.find(([name]) => name === about.agent) || choices[0])[0]);
  simulated.driverChoice = segment("Who decides", choices, simulated.driver, drive);
  return el(
      "div.toolbar", {}, simulated.button, button("Step", () => advance(1), {id: "step"}),
      button("Next episode", nextEpisode, {id: "next"}),
      button("Reset", beginRun, {id: "reset", title: "From the first episode on"}),
      el("label", {}, "seed ", simulated.seed), simulated.driverChoice,
      segment("Speed", [[0.25, "¼×"], [1, "1×"], [4, "4×"], [Infinity, "Fastest"]], 1, (speed) => {
        simulated.speed = speed;
        simulated.behind = 0;
      }));
}

function showSimulation(panel, simulation) {
  simulated.simulation = simulation;
  const {about} = simulation;
  simulated.message = el("p.note", {role: "status"});
  simulated.facts = el("div");
  simulated.hash = el("code", {id: "hash"});
  simulated.same = el("code.same");
  simulated.plots = new GrowingPlots(about.messages);
  simulated.actions = new ActionControls(simulation, () => {
    simulated.hand = simulation.actions.slice();
    if (simulated.driver !== "hand") simulated.driverChoice.choose("hand");
  });
  simulated.states =
      new StateControls(simulation, () => simulated.episode < 0 || simulation.ended ? null : simulated.steps);
  simulated.keys = new SteeringKeys(
      data.keys || [], () => state.view?.id === "simulation" && !simulated.broken,
      (parameter, add) => guarded(() => simulated.states.steer(parameter, add)));
  simulated.canvas = about.render ? el("canvas", {role: "img", "aria-label": "What render: shows"}) : null;
  const toolbar = simulationToolbar(about);
  panel.replaceChildren();
  add(panel, [
    toolbar,
    el("div.bench", {},
       el("div", {}, simulated.canvas ? el("div.picture", {}, simulated.canvas) : null, simulated.keys.element,
          simulated.actions.element, simulated.states.element),
       el("div", {},
          card(
              "", simulated.facts, pairs([["trace hash", simulated.hash], ["the same on Linux", simulated.same]]),
              simulated.message),
          simulated.plots.chooser, simulated.plots.stage))
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
  // A call of the module cannot be interrupted, so the browser must paint the message before it.
  requestAnimationFrame(() => setTimeout(start));
  const again = () => {
    if (simulated.plots) showSimulated();
  };
  return {shown: again, resized: again};
}
moreViews.set("simulation", makeSimulationView);
