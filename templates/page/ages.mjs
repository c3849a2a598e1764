// Ages of sensor data at actuators, and the paths that the data take.
import {ageWay, data, inputOf, nodes} from "./data.mjs";
import {add, bar, button, card, el, pairs, table} from "./elements.mjs";
import {showInGraph} from "./graph.mjs";
import {inputLink, settingsText} from "./inspector.mjs";
import {count, seconds, short} from "./numbers.mjs";
import {select} from "./selection.mjs";

const ages = data.info.ages;

function wayChart(age) {
  const total = age.way.reduce((sum, hop) => sum + hop.newest.seconds, 0);
  const least = 0.004 * (total || 1);
  let before = 0;
  const steps = age.way.map((hop, i) => {
    const input = inputOf.get(hop.input), own = hop.newest.seconds;
    const row =
        el("li", {},
           el("div.hop", {}, el("b", {}, String(i + 1)),
              input ? inputLink(input, `${input.from} → ${hop.input}`) : hop.input,
              el("small", {},
                 input ? [`${nodes[input.source[0]].rate} Hz → ${nodes[input.node].rate} Hz`, settingsText(input)]
                             .filter(Boolean)
                             .join(", ") :
                         "")),
           el("div.waterfall", {}, el("i")), el("span.number", {}, own ? `+ ${seconds(own)}` : "at once"));
    const piece = row.querySelector("i");
    piece.style.left = `${total ? (before / total) * 100 : 0}%`;
    piece.style.width = `${(Math.max(own, least) / (total || 1)) * 100}%`;
    before += own;
    return row;
  });
  return el("ol.way", {}, steps);
}

function showWay(age, box) {
  const way = ageWay(age), sum = age.way.reduce((all, hop) => all + hop.newest.seconds, 0);
  const follow = () => {
    select({way: age});
    showInGraph();
  };
  box.replaceChildren();
  add(box, [
    el("h2", {}, `From ${age.sensor} to ${age.actuator}`), pairs([
      ["newest data, at most", `${seconds(age.newest.seconds)} (${age.newest.exact} s)`],
      [
        "oldest data in a window, at most",
        age.oldest ? `${seconds(age.oldest.seconds)} (${age.oldest.exact} s)` : "unknown"
      ],
      ["bound", age.reached ? "is reached: some tick is as bad" : "a sum over the connections: no tick is worse"]
    ]),
    wayChart(age),
    sum > age.newest.seconds * 1.000001 ?
        el("p.note", {},
           `The connections alone add up to ${seconds(sum)}. Their worst ticks never meet, so the whole way is ${
               seconds(age.newest.seconds)} at most.`) :
        null,
    el("p.actions", {}, way.length ? button("Follow it in the graph", follow) : null)
  ]);
}

export function makeAgesView(panel) {
  const detail = el("section.card");
  if (!ages.length)
    panel.append(card(
        "Ages",
        el("p", {},
           data.info.engine === "none" ? "No action's data reach an observation." :
                                         "No sensor's data reach an actuator.")));
  else {
    const most = Math.max(...ages.map((age) => (age.oldest || age.newest).seconds)) || 1;
    panel.append(card(
        data.info.engine === "none" ? "Age of an action's data in the observation of a step, at most" :
                                      "Age of data at the ticks of an actuator, at most",
        el("p.note", {},
           "Dark: the newest data. Light: the oldest message in a window on any way. Select a pair to follow its way."),
        table(
            [
              {name: "from", cell: (age) => age.sensor},
              {name: "to", cell: (age) => age.actuator},
              {name: "newest", number: true, cell: (age) => seconds(age.newest.seconds)},
              {name: "oldest", number: true, cell: (age) => (age.oldest ? seconds(age.oldest.seconds) : "unknown")},
              {name: "", cell: (age) => bar(age.newest.seconds / most, age.oldest ? age.oldest.seconds / most : null)},
            ],
            ages, 100, (age) => showWay(age, detail))));
    showWay(ages[0], detail);
    panel.append(detail);
  }
  if (data.info.budget_ages.length)
    panel.append(card(
        "Budget",
        table(
            [
              {name: "from", cell: (age) => age.from},
              {name: "to", cell: (age) => age.to},
              {name: "ways", cell: (age) => (age.agent ? "all" : "without the agent")},
              {name: "newest", number: true, cell: (age) => seconds(age.newest.seconds)},
              {name: "at most", number: true, cell: (age) => seconds(age.at_most.seconds)},
              {name: "", cell: (age) => (age.kept ? "kept" : "too old")},
            ],
            data.info.budget_ages, 100)));
  if (data.info.ages_unknown.length)
    panel.append(card(
        "Unknown",
        el("p", {},
           "The age of data over these connections is unknown: they are too slow, or their delay is too long."),
        el("ul", {}, data.info.ages_unknown.map((name) => el("li", {}, name)))));
  const {link} = data.info;
  if (link.messages.length)
    panel.append(card(
        "What a serial link to the engine would carry",
        table(
            [
              {name: "direction", cell: (row) => row[0]},
              {name: "frames/s", number: true, cell: (row) => short(row[1].frames_per_s)},
              {name: "bytes/s", number: true, cell: (row) => short(row[1].bytes_per_s, 6)},
              {name: "largest frame, B", number: true, cell: (row) => count(row[1].largest_frame)},
              {name: "baud", number: true, cell: (row) => count(row[1].baud)},
            ],
            [["from sensors", link.sensors], ["to actuators", link.actuators]])));
  return {shown() {}, resized() {}};
}
