// Runs, each of which is an episode of a trace, and the choice of what to plot over which time.
import {data, nodes, outputName} from "./data.mjs";
import {floats} from "./numbers.mjs";

export const runs =
    data.logs.flatMap((log, l) => log.episodes.map((episode) => ({
                                                     log,
                                                     episode,
                                                     name: log.title          ? log.title :
                                                         data.logs.length > 1 ? `${l + 1}: episode ${episode.number}` :
                                                                                `episode ${episode.number}`
                                                   })));
runs.forEach((run, number) => {
  run.number = number;
});
export const plots = {
  runs: new Set(),
  series: new Set(),
  sideBySide: false,
  begin: 0,
  span: 1,
  cursor: null,
  rows: [],
  draw: null,
  stage: null
};
export const seriesList = [];

/** Series that can be plotted: channels, and the lateness of their messages. */
export function makeSeries() {
  const names = new Map();
  for (const log of data.logs)
    for (const channel of log.channels)
      if (!names.has(channel.name)) names.set(channel.name, channel);
  for (const [name, channel] of names) {
    const known = data.channels.find((other) => other.name === name);
    const output = known && nodes[known.node].outputs[known.output];
    const title = known ? outputName(known.node, known.output) : name;
    seriesList.push({
      name,
      title,
      unit: output ? output.unit : "",
      node: known ? known.node : null,
      size: channel.size,
      late: false
    });
  }
  if (data.logs.some((log) => log.paced))
    for (const {name, title} of [...seriesList])
      seriesList.push({name, title: `late: ${title}`, unit: "s", node: null, size: 1, late: true});
  seriesList.forEach((series, number) => {
    series.number = number;
  });
}

/** Points of a series in a run; null if there are none. */
export function pointsOf(series, run) {
  const key = `points${series.number}`;
  if (run[key] !== undefined) return run[key];
  const number = run.log.channels.findIndex((channel) => channel.name === series.name);
  const channel = number < 0 ? null : run.episode.channels[number];
  const elements = !channel || !channel.messages ? [] :
      series.late                                ? [channel.lateness].filter(Boolean) :
                                                   channel.elements;
  if (!elements.length) return (run[key] = null);
  const {rate_hz} = run.log.channels[number];
  return (run[key] = {
    begin: channel.first / rate_hz,
    step: channel.per / rate_hz,
    messages: channel.messages,
    thinned: channel.per > 1 ? channel.per : 0,
    elements: elements.map((element) => ({
                             low: floats(element.low),
                             high: element.high ? floats(element.high) : null,
                             notFinite: element.not_finite || 0
                           }))
  });
}

export function defaultSeries() {
  const important = new Set();
  nodes[0].outputs.forEach((_, o) => important.add(`0/${o}`));
  nodes[0].inputs.forEach((input) => important.add(input.source.join("/")));
  const names = new Set(data.channels.filter((channel) => important.has(`${channel.node}/${channel.output}`))
                            .map((channel) => channel.name));
  return seriesList.filter((series) => !series.late && names.has(series.name)).slice(0, 6);
}

export const chosenRuns = () => runs.filter((run) => plots.runs.has(run.number));

function wholeSpan() {
  let end = 0;
  for (const run of chosenRuns())
    for (const [c, channel] of run.episode.channels.entries())
      end = Math.max(end, (channel.first + channel.messages) / run.log.channels[c].rate_hz);
  return end || 1;
}

export function placePlots(begin, span) {
  const whole = wholeSpan();
  plots.span = Math.min(Math.max(span, whole * 1e-5), whole * 1.02);
  plots.begin = Math.min(Math.max(begin, -0.01 * whole), whole * 1.01 - plots.span);
  plots.draw();
}
export const fitPlots = () => placePlots(0, wholeSpan());
export function zoomPlots(factor, time = null) {
  const at = time ?? plots.cursor ?? plots.begin + plots.span / 2;
  placePlots(at - (at - plots.begin) * factor, plots.span * factor);
}
