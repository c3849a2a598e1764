// The client of the live page, with a socket that the test moves.
import assert from "node:assert/strict";
import test from "node:test";

import {StreamClient} from "../../templates/page/stream.mjs";

import {become, Element, smallData} from "./dom.mjs";

become(smallData());
class Socket {
  static OPEN = 1;
  readyState = 0;
  sent = [];
  constructor(address, protocols) {
    Object.assign(this, {address, protocols});
  }
  send(text) {
    this.sent.push(JSON.parse(text));
  }
  open() {
    this.readyState = 1;
    this.onopen();
  }
  say(message) {
    this.onmessage({data: JSON.stringify(message)});
  }
}
globalThis.WebSocket = Socket;

function opened() {
  const received = [], changes = [];
  const client = new StreamClient((...words) => received.push(words), (text) => changes.push(text));
  client.socket.open();
  return {client, socket: client.socket, received, changes};
}
const kChannels = [{id: 3, topic: "/a"}, {id: 9, topic: "/b"}];

function message(id, text, time = 7n, opcode = 1) {
  const body = new TextEncoder().encode(text), bytes = new ArrayBuffer(13 + body.length), view = new DataView(bytes);
  view.setUint8(0, opcode);
  view.setUint32(1, id, true);
  view.setBigUint64(5, time, true);
  new Uint8Array(bytes, 13).set(body);
  return bytes;
}

test("the key of the page's own address goes along", () => {
  const {socket, changes} = opened();
  assert.deepEqual(
      [socket.address, socket.protocols, changes], ["ws://127.0.0.1:1/?key=0", ["foxglove.websocket.v1"], [""]]);
});

test("it subscribes to what is wanted and there, and leaves what is not wanted any more", () => {
  const {client, socket} = opened();
  client.want(["/a", "/none"]);
  assert.deepEqual(socket.sent, []);
  socket.say({op: "advertise", channels: kChannels});
  client.want(["/b"]);
  client.want(["/b"]);
  assert.deepEqual(socket.sent, [
    {op: "subscribe", subscriptions: [{id: 3, channelId: 3}]},
    {op: "subscribe", subscriptions: [{id: 9, channelId: 9}]}, {op: "unsubscribe", subscriptionIds: [3]}
  ]);
});

test("messages arrive by topic, and other data do not", () => {
  const {socket, received} = opened();
  socket.say({op: "advertise", channels: kChannels});
  socket.onmessage({data: message(9, "{\"value\":[1]}")});
  socket.onmessage({data: message(4, "{}")});
  socket.onmessage({data: message(9, "{}", 7n, 2)});
  socket.onmessage({data: Uint8Array.of(1, 9, 0, 0, 0).buffer});
  socket.say({op: "status", level: 1});
  assert.deepEqual(received, [["/b", {value: [1]}, 7]]);
});

test("the live view shows what the monitor says, and subscribes to what it plots", async () => {
  const {moreViews} = await import("../../templates/page/views.mjs");
  const {state} = await import("../../templates/page/selection.mjs");
  const {timetable} = await import("../../templates/page/timetable_canvas.mjs");
  let socket;
  globalThis.WebSocket = class extends Socket {
    constructor(...words) {
      super(...words);
      socket = this;
    }
  };
  await import("../../templates/page/stream_view.mjs");
  const panel = new Element("section");
  state.view = {id: "live"};
  moreViews.get("live")(panel);
  socket.open();
  const topics = ["/monitor", "/drawing", "/environment/u", "/filter/y"];
  socket.say({op: "advertise", channels: topics.map((topic, id) => ({id, topic}))});
  assert.deepEqual(socket.sent[0].subscriptions.map(({id}) => id), [0, 1, 2]);
  const channel =
      {name: "filter/y", rate_hz: 19.9, planned_hz: 20, late_s: 0.001, worst_s: null, left: 0.25, state: "silent"};
  const said =
      {channels: [channel], episode: 3, step: null, time_s: 1.5, steps_hz: 10, speed: 1, late_s: 0, worst_s: 0};
  socket.onmessage({data: message(0, JSON.stringify({...said, faults: {"lost frames": 2}, note: "<b>slow</b>"}))});
  for (const word of ["silent", "25 %", "lost frames", "<b>slow</b>", "unknown"])
    assert.ok(panel.textContent.includes(word), `${word}: ${panel.textContent}`);
  timetable.stream.choose(true);
  socket.onmessage({
    data: message(
        0,
        JSON.stringify({...said, channels: [{...channel, first: 4, came_late_s: [0.01, 0.02]}], faults: {}, note: ""}))
  });
  assert.deepEqual(timetable.measured.get(1), {first: 4, late: [0.01, 0.02]});
  timetable.stream.choose(false);
  assert.equal(timetable.measured, null);
});

test("after the end it says so, and sends nothing", () => {
  const {client, socket, changes} = opened();
  socket.say({op: "advertise", channels: kChannels});
  socket.readyState = 3;
  socket.onclose();
  client.want(["/a"]);
  assert.equal(socket.sent.length, 0);
  assert.match(changes.at(-1), /no connection/);
});
