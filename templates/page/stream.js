// What a run sends while it goes on: a client of Foxglove's WebSocket protocol, at the server that shows this page.
const kStreamProtocol = "foxglove.websocket.v1", kStreamAgain_ms = 1000;

class StreamClient {
  /** `told(topic, message, time_ns)` of each message; `changed(text)` when the connection is another one. */
  constructor(told, changed) {
    this.told = told;
    this.changed = changed;
    this.wanted = new Set();      // topics
    this.channels = new Map();    // topic: id
    this.topics = new Map();      // id: topic
    this.subscribed = new Set();  // ids
    this.connect();
  }

  connect() {
    // The key is the one of this page's own address.
    this.socket = new WebSocket(`ws://${location.host}/${location.search}`, [kStreamProtocol]);
    this.socket.binaryType = "arraybuffer";
    this.socket.onmessage = ({data: bytes}) => (typeof bytes === "string" ? this.read(bytes) : this.readBytes(bytes));
    this.socket.onopen = () => this.changed("");
    this.socket.onclose = () => {
      this.channels.clear();
      this.topics.clear();
      this.subscribed.clear();
      this.changed("no connection: eagerx-gen does not run any more, or has a new address");
    };
  }

  read(text) {
    const said = JSON.parse(text);
    if (said.op !== "advertise") return;
    for (const {id, topic} of said.channels) {
      this.channels.set(topic, id);
      this.topics.set(id, topic);
    }
    this.subscribe();
  }

  readBytes(bytes) {
    const view = new DataView(bytes);
    if (view.byteLength < 13 || view.getUint8(0) !== 1) return;
    const topic = this.topics.get(view.getUint32(1, true));
    if (topic === undefined) return;
    const message = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 13)));
    this.told(topic, message, Number(view.getBigUint64(5, true)));
  }

  /** From now on, these topics and no others. */
  want(topics) {
    this.wanted = new Set(topics);
    this.subscribe();
  }

  subscribe() {
    if (this.socket.readyState !== WebSocket.OPEN) return;
    const ids = new Set([...this.wanted].map((topic) => this.channels.get(topic)).filter((id) => id !== undefined));
    const more = [...ids].filter((id) => !this.subscribed.has(id)),
          less = [...this.subscribed].filter((id) => !ids.has(id));
    const say = (message) => this.socket.send(JSON.stringify(message));
    if (more.length) say({op: "subscribe", subscriptions: more.map((id) => ({id, channelId: id}))});
    if (less.length) say({op: "unsubscribe", subscriptionIds: less});
    this.subscribed = ids;
  }
}

/** What came of the channels that are plotted: points at their own rates, in seconds of the run. */
class StreamHistory {
  constructor(fields) {
    this.fields = fields;
    this.rows = fields.map(() => null);
    this.end_s = 0;
  }

  add(f, values, time_s) {
    const step = 1 / this.fields[f].rate_hz, place = Math.round(time_s / step);
    const shown = values.slice(0, kPlottedElements).map((value) => (value === null ? NaN : Number(value)));
    let row = this.rows[f];
    // What was missing leaves a gap, and what is far away, or earlier, begins anew.
    const gap = row ? place - row.first - row.elements[0].length : -1;
    if (gap < 0 || gap > kKeptSteps || row.elements.length !== shown.length)
      row = this.rows[f] = {first: place, step, elements: shown.map(() => [])};
    else
      for (let i = 0; i < gap; ++i) row.elements.forEach((element) => element.push(NaN));
    row.elements.forEach((element, i) => element.push(shown[i]));
    if (row.elements[0].length > 2 * kKeptSteps) {
      for (const element of row.elements) element.splice(0, kKeptSteps);
      row.first += kKeptSteps;
    }
    this.end_s = Math.max(this.end_s, time_s);
  }

  get kept_s() {
    return kShown_s;
  }

  points(f) {
    const row = this.rows[f];
    if (!row) return {begin: 0, step: 1, elements: []};
    return {begin: row.first * row.step, step: row.step, elements: row.elements.map((low) => ({low, high: null}))};
  }
}
