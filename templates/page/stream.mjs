// Messages of a running program: client of Foxglove's WebSocket protocol on the server of this page.

const kStreamProtocol = "foxglove.websocket.v1";

export class StreamClient {
  /** `onMessage(topic, message, time_ns)` is called for each message, `changed(text)` when the connection changes. */
  constructor(onMessage, changed) {
    this.onMessage = onMessage;
    this.changed = changed;
    this.wanted = new Set();      // topics
    this.channels = new Map();    // topic: id
    this.topics = new Map();      // id: topic
    this.subscribed = new Set();  // ids
    this.connect();
  }

  connect() {
    // The key is part of the address of this page.
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
    this.onMessage(topic, message, Number(view.getBigUint64(5, true)));
  }

  /** Subscribes to these topics and no others. */
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
