// The drawing of a trace, played back in step with the cursor of the plots.
const playback = {
  playing: false,
  speed: 1,
  before: null,
  button: null,
  pictures: []
};

/** The scenes of an episode, of which only changes are in the page. */
class Film {
  constructor({rate_hz, every, scenes, changes}) {
    const raw = atob(changes);
    this.view = new DataView(Uint8Array.from(raw, (c) => c.charCodeAt(0)).buffer);
    this.rate_hz = rate_hz;
    this.every = every;
    this.kept = [];  // every 64th scene, so that going back is cheap
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

  /** The number of the scene that is shown at a time. */
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

function filmOf(run) {
  if (run.film === undefined) run.film = run.episode.drawing ? new Film(run.episode.drawing) : null;
  return run.film;
}

const kMostPictures = 4;
const playedRuns = () => chosenRuns().filter(filmOf).slice(0, kMostPictures);

/** One picture for each episode that is chosen. */
function layOutPictures() {
  if (!playback.stage) return;
  playback.pictures =
      playedRuns().map((run) => ({run, canvas: el("canvas", {role: "img", "aria-label": `Drawing of ${run.name}`})}));
  const several = playback.pictures.length > 1;
  playback.stage.replaceChildren(...playback.pictures.map(
      ({run, canvas}) => el("figure", {}, canvas, several ? el("figcaption", {}, run.name) : null)));
  playback.box.hidden = !playback.pictures.length;
}

function drawPictures() {
  for (const {run, canvas} of playback.pictures) {
    const side = Math.floor(canvas.parentElement.getBoundingClientRect().width);
    const context = prepare(canvas, side, side);
    if (!context) continue;
    const film = filmOf(run);
    paintScene(context, film.go(film.numberAt(plots.cursor ?? 0)), side, side);
  }
}

function playTrace(playing) {
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
    // The plots follow.
    const last = plots.begin + plots.span;
    if (plots.cursor < plots.begin || plots.cursor > last) placePlots(plots.cursor, plots.span);
    plots.draw();
  }
  playback.before = now;
  if (plots.cursor >= end || state.view.id !== "traces") return playTrace(false);
  requestAnimationFrame(playFrame);
}

/** What stands beside the plots; of a trace without scenes, how they get into it. */
function playbackCard() {
  if (!runs.some((run) => run.episode.drawing)) {
    if (data.shows !== "scene") return null;
    return el(
        "p.note", {},
        "The drawing can be played here when the trace has it: ", el("code", {}, "--trace FILE --trace-scenes"));
  }
  playback.button = button("Play", () => playTrace(!playback.playing), {id: "play-trace"});
  playback.stage = el("div.pictures");
  const every = Math.max(...runs.map((run) => (run.episode.drawing ? run.episode.drawing.every : 1)));
  const note = every > 1 ? el("small", {}, `one scene of ${count(every)}`) : null;
  const speed = segment("Speed", [[0.25, "¼×"], [1, "1×"], [4, "4×"]], 1, (factor) => {
    playback.speed = factor;
  });
  playback.box = el("div.playback", {}, el("div.toolbar", {}, playback.button, speed, note), playback.stage);
  return playback.box;
}
