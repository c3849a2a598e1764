// View of a running program.
import {onFrame, prepare} from "./canvas.mjs";
import {data, nodes} from "./data.mjs";
import {add, breakable, card, el, table, tiles} from "./elements.mjs";
import {GrowingPlots} from "./growing_plots.mjs";
import {StreamHistory} from "./history.mjs";
import {count, seconds, short} from "./numbers.mjs";
import {paintScene} from "./scene.mjs";
import {state} from "./selection.mjs";
import {StreamClient} from "./stream.mjs";
import {showOnWires, streamTimes} from "./stream_shown.mjs";
import {moreViews} from "./views.mjs";

const stream = {
  latest: new Map(),  // data of /monitor by channel
  scene: null,
  said: null
};

const streamFields = data.channels.map((channel) => {
  const node = nodes[channel.node], {numbers} = node.outputs[channel.output].space;
  return {name: channel.name, numbers, rate_hz: node.rate_hz};
});
const fieldOfTopic = new Map(streamFields.map((field, f) => [`/${field.name}`, f]));

function drawStreamScene() {
  if (!stream.canvas || !stream.scene) return;
  const side = Math.floor(stream.canvas.parentElement.getBoundingClientRect().width);
  const context = prepare(stream.canvas, side, side);
  if (context) paintScene(context, stream.scene, side, side);
}

const showStream = onFrame(() => {
  if (!stream.plots) return;
  drawStreamScene();
  stream.plots.draw();
});

function streamTopics() {
  const plotted = stream.plots ? [...stream.plots.chosen].map((f) => `/${streamFields[f].name}`) : [];
  return ["/monitor", "/drawing", ...plotted];
}

function streamTable(channels) {
  return table(
      [
        {name: "channel", cell: (row) => breakable(row.name)},
        {name: "rate", number: true, cell: (row) => (row.rate_hz === null ? "–" : `${short(row.rate_hz, 3)} Hz`)},
        {
          name: "planned",
          number: true,
          cell: (row) => (row.planned_hz === null ? "–" : `${short(row.planned_hz, 3)} Hz`)
        },
        {name: "late", number: true, cell: (row) => seconds(row.late_s)},
        {name: "worst", number: true, cell: (row) => seconds(row.worst_s)},
        {
          name: "to its limit",
          number: true,
          cell: (row) => (row.left === null ? "–" : `${short(row.left * 100, 2)} %`)
        },
        {name: "state", cell: (row) => row.state},
      ],
      channels);
}

/** Handles /monitor, which arrives five times per second. */
function takeMonitor(said) {
  stream.said = said;
  stream.latest = new Map(said.channels.map((channel) => [channel.name, channel]));
  showOnWires(stream.latest);
  streamTimes.show(said.channels);
  if (state.view.id !== "live" || !stream.facts) return;
  const faults = Object.entries(said.faults).map(([name, number]) => [name, count(number)]);
  stream.facts.replaceChildren(tiles([
    ["episode", count(said.episode)], ["step", said.step === null ? "–" : count(said.step)],
    ["time", seconds(said.time_s)], ["steps a second", said.steps_hz === null ? "–" : short(said.steps_hz, 3)],
    ["speed", said.speed === null ? "–" : `×${short(said.speed, 3)}`], ["late", seconds(said.late_s)],
    ["worst", seconds(said.worst_s)], ...faults
  ]));
  stream.table.replaceChildren(streamTable(said.channels.slice(0, 200)));
  stream.note.textContent = said.note;
}

const streamHistory = new StreamHistory(streamFields);
const streamClient = new StreamClient(
    (topic, message, time_ns) => {
      if (topic === "/monitor") return takeMonitor(message);
      if (topic === "/drawing")
        stream.scene = Float32Array.from(message.rows, (number) => (number === null ? NaN : number));
      else
        streamHistory.add(
            fieldOfTopic.get(topic), Array.isArray(message.value) ? message.value : [message.value], time_ns * 1e-9);
      showStream();
    },
    (text) => {
      stream.problem = text;
      if (stream.note) stream.note.textContent = text;
    });
streamClient.want(streamTopics());

function makeStreamView(panel) {
  stream.plots = new GrowingPlots(streamFields, () => streamClient.want(streamTopics()));
  stream.plots.history = streamHistory;
  stream.canvas = data.shows === "scene" ? el("canvas", {role: "img", "aria-label": "What render: shows"}) : null;
  stream.note = el("p.note", {role: "status"}, stream.problem || "");
  stream.facts = el("div");
  stream.table = el("div.measured");
  add(panel, [
    el("div.bench", {},
       el("div", {}, stream.canvas ? el("div.picture", {}, stream.canvas) : null, card("", stream.facts, stream.note)),
       el("div", {}, stream.plots.chooser, stream.plots.stage)),
    el("details", {open: true}, el("summary", {}, "Channels as measured"), stream.table)
  ]);
  streamClient.want(streamTopics());
  return {shown: showStream, resized: showStream};
}
moreViews.set("live", makeStreamView);
