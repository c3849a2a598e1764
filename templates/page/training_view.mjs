// Record of a training: its curves, settings and result, and its best and worst episodes.
import {prepare} from "./canvas.mjs";
import {chartBox} from "./charts.mjs";
import {data} from "./data.mjs";
import {add, button, card, el, pairs, table, tiles} from "./elements.mjs";
import {Film} from "./film.mjs";
import {count, counted, seconds, short} from "./numbers.mjs";
import {runs} from "./runs.mjs";
import {paintScene} from "./scene.mjs";
import {plotRuns} from "./traces.mjs";
import {moreViews, showView} from "./views.mjs";

const kMoments = 5, kSide = 150;

const endings = {
  success: "the policy succeeds",
  steps: "the steps are used up",
  interrupted: "it was interrupted",
  failed: "a problem has ended it"
};
const endingOf = ({ended}) => endings[ended] ?? "it is running, or was killed";
const percent = (part, of) => (of ? `${short((100 * part) / of, 4)} %` : "–");

// Time that all threads spent on each kind of work, and the speed of each kind.
const kWork = ["simulation", "inference", "learning", "evaluation", "waiting"];
function timeFacts(time) {
  if (!time) return [];
  const all = kWork.reduce((sum, name) => sum + time[`${name}_s`], 0);
  const speeds = {
    simulation: [time.steps, "steps/s"],
    inference: [time.steps, "steps/s", time.inference_gflop],
    learning: [time.samples, "samples/s", time.learning_gflop]
  };
  return kWork.map((name) => {
    const spent = time[`${name}_s`];
    const [number, unit, gflop] = speeds[name] ?? [];
    const speed = number && spent ? `${count(Math.round(number / spent))} ${unit} a thread` : "";
    return [name, percent(spent, all), gflop && spent ? `${speed}, ${short(gflop / spent, 3)} Gflop/s` : speed];
  });
}

// ---- Result ---------------------------------------------------------------------------------------------------------
function trainingCard(training) {
  const best = training.trainings[training.best];
  if (!best) return card("Training", el("p.note", {}, "It has made no iteration yet."));
  const {evaluation} = best;
  const facts = [
    ["it ended", endingOf(best)], ["steps", count(best.steps), `of at most ${count(training.steps)}`],
    best.seconds === undefined ? null : ["time", `${short(best.seconds, 3)} s`], ...timeFacts(best.time),
    evaluation && training.has_success ?
        ["success", percent(evaluation.successes, evaluation.episodes), `of ${count(evaluation.episodes)} episodes`] :
        null,
    evaluation ? ["return", short(evaluation.return ), `${short(evaluation.lowest)} to ${short(evaluation.highest)}`] :
                 null
  ];
  const given = [
    ["algorithm", training.algorithm], ["seed", best.seed], ["until the return is", training.until_return],
    ["continues", training.resume], ["began with", training.from], ["failure replay", training.failure_replay],
    ["stages", training.stages?.join(", ")], ["learnt from logs", training.replay?.join(", ")], ["policy", best.policy],
    ["kernels", best.kernels]
  ];
  return card(
      training.trainings.length > 1 ? `Training: the best of ${counted(training.trainings.length, "seed")}` :
                                      "Training",
      tiles(facts.filter(Boolean)), best.problem ? el("p.problem", {}, best.problem) : null,
      best.help ? el("p.note", {}, best.help) : null, holdsIt(best), pairs(given));
}

/** Explanations that the trainer gave for a training that did not succeed. */
function holdsIt({signs}) {
  if (!signs || !signs.length) return null;
  return [el("h3", {}, "What holds it"), el("ul.signs", {}, signs.map((sign) => el("li", {}, sign)))];
}

function seedsCard(training) {
  if (training.trainings.length < 2 || training.kind !== "record") return null;
  return card(
      "Seeds",
      table(
          [
            {name: "seed", number: true, cell: (row) => row.seed},
            {name: "it ended", cell: (row) => row.problem ?? endingOf(row)},
            {name: "steps", number: true, cell: (row) => count(row.steps)}, {
              name: "success",
              number: true,
              cell: (row) => (row.evaluation ? `${row.evaluation.successes} of ${row.evaluation.episodes}` : "–")
            },
            {name: "return", number: true, cell: (row) => short(row.evaluation?.return )},
            {name: "policy", cell: (row) => row.policy ?? "–"}
          ],
          training.trainings));
}

// ---- Last evaluation ------------------------------------------------------------------------------------------------
function evaluationCard(training) {
  const evaluation = training.trainings[training.best]?.evaluation;
  if (!evaluation) return null;
  const all = evaluation.terms.reduce((sum, term) => sum + Math.abs(term), 0);
  const rows = training.terms.map((name, i) => ({name, value: evaluation.terms[i]}));
  return card(
      `The last evaluation: ${counted(evaluation.episodes, "episode")} that neither trained nor chose the policy`,
      tiles([
        ["return", short(evaluation.return ), `${short(evaluation.lowest)} to ${short(evaluation.highest)}`],
        ["steps of an episode", short(evaluation.steps)], ["actions at their bounds", percent(evaluation.saturated, 1)]
      ]),
      table(
          [
            {name: "term of the reward", cell: (row) => row.name},
            {name: "sum over an episode, mean", number: true, cell: (row) => short(row.value, 5)},
            {name: "share of the sizes", number: true, cell: (row) => percent(Math.abs(row.value), all)}
          ],
          rows),
      returnsChart(training));
}

/** Returns of all episodes, in ascending order. */
function returnsChart({returns, has_success}) {
  if (!returns) return null;
  const of = (good) => {
    const own = returns.map(([value, success], i) => [i, value, success === 1]).filter(([, , s]) => s === good);
    return {x: own.map(([i]) => i), y: own.map(([, value]) => value), dots: true, shade: good ? 2 : 5};
  };
  const lines = has_success ? [{name: "success", ...of(true)}, {name: "none", ...of(false)}] :
                              [{name: "", ...of(false), shade: 0}];
  const box = chartBox(
      {name: "Return of each episode, sorted", unit: "", lines: lines.filter((line) => line.x.length)}, "episode");
  trainingCharts.push(box);
  return box.element;
}
const trainingCharts = [];

// ---- Episodes -------------------------------------------------------------------------------------------------------
/** Run in the traces that is this episode; undefined if there is none. */
const runOf = (what) => runs.find((run) => run.log.title?.startsWith(`${what} `));

function moments(run) {
  if (!run?.episode.film) return null;
  const film = new Film(run.episode.film), last = film.ticks.length - 1;
  return el("div.moments", {}, Array.from({length: kMoments}, (_, i) => {
    const number = Math.round((last * i) / (kMoments - 1)), canvas = el("canvas");
    const context = prepare(canvas, kSide, kSide);
    if (context) paintScene(context, film.go(number), kSide, kSide);
    return el("figure", {}, canvas, el("figcaption", {}, seconds(film.ticks[number] / film.rate_hz)));
  }));
}

function episodeBox(training, episode) {
  const run = runOf(episode.what);
  const text = [
    `return ${short(episode.return, 6)}`, counted(episode.steps, "step"),
    training.has_success ? (episode.success ? "success" : "no success") : ""
  ].filter(Boolean);
  return el(
      "div.episode", {}, el("h3", {}, `The ${episode.what}`), el("p", {}, text.join(" · ")), moments(run),
      run ? el("p", {}, button(run.episode.film ? "Play it next to its plots" : "Its plots", () => plotRuns([run]))) :
            null,
      el("pre.lines", {}, `${training.run} ${episode.command}`));
}

function episodesCard(training) {
  if (!training.shown.length) return null;
  const both = training.shown.map((episode) => runOf(episode.what)).filter(Boolean);
  return card(
      "Best and worst episode of the last evaluation",
      el("p.note", {},
         training.why_not ? `They are not shown: ${training.why_not}.` :
                            "Run again by the graph's program: their returns are those of the training, to the bit."),
      training.shown.map((episode) => episodeBox(training, episode)),
      both.length > 1 ? button("Both side by side", () => plotRuns(both)) : null);
}

// ---- Settings, policy -----------------------------------------------------------------------------------------------
function settingsTable(rows) {
  return table(
      [
        {name: "setting", cell: (row) => row.name}, {name: "value", number: true, cell: (row) => row.value},
        {name: "default", number: true, cell: (row) => row.default ?? "not known here"},
        {name: "", cell: (row) => row.about}
      ],
      rows);
}

function settingsCard({settings}) {
  if (!settings) return null;
  const other = settings.filter((row) => row.differs), same = settings.filter((row) => !row.differs);
  return card(
      "Settings", other.length ? settingsTable(other) : el("p.note", {}, "All settings have their defaults."),
      same.length ? el("details", {}, el("summary", {}, `${counted(same.length, "setting")} with the default`),
                       settingsTable(same)) :
                    null);
}

function policyFacts() {
  const policy = data.policies.find((one) => one.name === "agent");
  if (!policy) return null;
  const sum = (of) => policy.layers.reduce((all, layer) => all + of(layer), 0);
  return [
    tiles([
      ["numbers in", count(policy.inputs)], ["numbers out", count(policy.outputs)],
      ["parameters", count(sum((layer) => layer.parameters))], ["flash", `${count(sum((layer) => layer.bytes))} B`],
      ["multiply-adds a step", count(sum((layer) => layer.multiply_adds))]
    ]),
    button("All of it", () => showView("policy"))
  ];
}

function nextCard({next}) {
  const facts = policyFacts();
  if (!next.length && !facts) return null;
  return card(
      "The policy, and what to type next", facts,
      next.map(({about, command}) => [el("p.note", {}, about), el("pre.lines", {}, command)]));
}

// ---- Sweep ----------------------------------------------------------------------------------------------------------
function sweepCard({names, cases}) {
  return card(
      "Settings, the best first",
      table(
          [
            ...names.map((name, i) => ({name, number: true, cell: (row) => row.values[i]})),
            {name: "seeds", number: true, cell: (row) => `${row.succeed} of ${row.seeds}`},
            {name: "success", number: true, cell: (row) => percent(row.successes, row.episodes)},
            {name: "return", number: true, cell: (row) => short(row.return )},
            {name: "steps", number: true, cell: (row) => count(Math.round(row.steps))},
            {name: "processor", number: true, cell: (row) => seconds(row.processor_s)},
            {name: "", cell: (row) => row.problems.join("; ")}
          ],
          cases));
}

function makeTrainingView(panel) {
  const {training} = data, over = training.kind === "sweep" ? "setting" : "step";
  const boxes = training.charts.map((chart) => chartBox(chart, over));
  trainingCharts.push(...boxes);
  const charts = el("div.charts", {}, boxes.map((box) => box.element));
  const source = el("p.note", {}, training.name);
  if (training.kind === "record")
    add(panel, [
      source, trainingCard(training), charts, evaluationCard(training), episodesCard(training), seedsCard(training),
      settingsCard(training), nextCard(training)
    ]);
  else if (training.kind === "sweep")
    add(panel, [source, sweepCard(training), charts]);
  else
    add(panel, [
      source,
      el("p.note", {}, "This table has the curve alone. ", el("code", {}, "train --record FILE"),
         " keeps settings, the last evaluation and its episodes, too."),
      charts, nextCard(training)
    ]);
  const draw = () => trainingCharts.forEach((box) => box.draw());
  return {shown: draw, resized: draw};
}
moreViews.set("training", makeTrainingView);
