// Playback of the pictures of a trace, synchronized with the cursor of the plots.
import {prepare} from "./canvas.mjs";
import {data} from "./data.mjs";
import {button, el, segment} from "./elements.mjs";
import {Film} from "./film.mjs";
import {count} from "./numbers.mjs";
import {chosenRuns, placePlots, plots, runs} from "./runs.mjs";
import {paintScene} from "./scene.mjs";
import {state} from "./selection.mjs";

export const playback = {
  playing: false,
  speed: 1,
  before: null,
  button: null,
  pictures: []
};

function filmOf(run) {
  if (run.film === undefined) run.film = run.episode.film ? new Film(run.episode.film) : null;
  return run.film;
}

const kMostPictures = 4;
const playedRuns = () => chosenRuns().filter(filmOf).slice(0, kMostPictures);

/** Creates one picture for each selected episode that has scenes. */
export function layOutPictures() {
  if (!playback.stage) return;
  playback.pictures =
      playedRuns().map((run) => ({run, canvas: el("canvas", {role: "img", "aria-label": `Picture of ${run.name}`})}));
  const several = playback.pictures.length > 1;
  playback.stage.replaceChildren(...playback.pictures.map(
      ({run, canvas}) => el("figure", {}, canvas, several ? el("figcaption", {}, run.name) : null)));
  playback.box.hidden = !playback.pictures.length;
}

export function drawPictures() {
  for (const {run, canvas} of playback.pictures) {
    const side = Math.floor(canvas.parentElement.getBoundingClientRect().width);
    const context = prepare(canvas, side, side);
    if (!context) continue;
    const film = filmOf(run);
    paintScene(context, film.go(film.numberAt(plots.cursor ?? 0)), side, side);
  }
}

export function playTrace(playing) {
  playback.playing = playing;
  playback.before = null;
  playback.button.textContent = playing ? "Pause" : "Play";
  if (!playing) return;
  const end = Math.max(...playback.pictures.map(({run}) => filmOf(run).end_s));
  if ((plots.cursor ?? 0) >= end - 1e-9) plots.cursor = 0;
  requestAnimationFrame(playFrame);
}

function playFrame(now) {
  if (!playback.playing) return;
  const end = Math.max(0, ...playback.pictures.map(({run}) => filmOf(run).end_s));
  if (playback.before !== null) {
    plots.cursor = Math.min(end, (plots.cursor ?? 0) + Math.min(0.25, (now - playback.before) * 1e-3) * playback.speed);
    // The plots follow the cursor.
    const last = plots.begin + plots.span;
    if (plots.cursor < plots.begin || plots.cursor > last) placePlots(plots.cursor, plots.span);
    plots.draw();
  }
  playback.before = now;
  if (plots.cursor >= end || state.view.id !== "traces") return playTrace(false);
  requestAnimationFrame(playFrame);
}

/** Card next to the plots. For a trace without scenes, it explains how to record them. */
export function playbackCard() {
  if (!runs.some((run) => run.episode.film)) {
    if (data.shows !== "scene") return null;
    return el(
        "p.note", {},
        "The picture can be played here when the trace has it: ", el("code", {}, "--trace FILE --trace-scenes"));
  }
  playback.button = button("Play", () => playTrace(!playback.playing), {id: "play-trace"});
  playback.stage = el("div.pictures");
  const every = Math.max(...runs.map((run) => (run.episode.film ? run.episode.film.every : 1)));
  const note = every > 1 ? el("small", {}, `one scene of ${count(every)}`) : null;
  const speed = segment("Speed", [[0.25, "¼×"], [1, "1×"], [4, "4×"]], 1, (factor) => {
    playback.speed = factor;
  });
  playback.box = el("div.playback", {}, el("div.toolbar", {}, playback.button, speed, note), playback.stage);
  return playback.box;
}
