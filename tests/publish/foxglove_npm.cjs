// foxglove_npm runs this next to the packages: node client.cjs PORT STEPS. Prints what it had as JSON.
const { FoxgloveClient } = require("@foxglove/ws-protocol");
const { SceneUpdate } = require("@foxglove/schemas/jsonschema");
const { WebSocket } = require("ws");

const [port, steps] = process.argv.slice(2).map(Number);
const client = new FoxgloveClient({ ws: new WebSocket(`ws://127.0.0.1:${port}`, [FoxgloveClient.SUPPORTED_SUBPROTOCOL]) });
const topics = new Map();
const messages = {};
const services = {};
const decoder = new TextDecoder();
let calls = 0;

function once(name, is) {
  return new Promise((resolve) => {
    const listener = (event) => {
      if (is(event)) {
        client.off(name, listener);
        resolve(event);
      }
    };
    client.on(name, listener);
  });
}
async function call(name, request) {
  const callId = ++calls;
  const answer = once("serviceCallResponse", (response) => response.callId === callId);
  const data = new TextEncoder().encode(JSON.stringify(request));
  client.sendServiceCallRequest({ serviceId: services[name], callId, encoding: "json", data: new DataView(data.buffer) });
  return JSON.parse(decoder.decode((await answer).data));
}
async function parameters(send, id) {
  const values = once("parameterValues", (event) => event.id === id);
  send(id);
  return (await values).parameters;
}

client.on("error", (error) => { throw error; });
client.on("serviceCallFailure", (failure) => { throw new Error(failure.message); });
client.on("status", (status) => { throw new Error(status.message); });
client.on("advertise", (channels) => {
  for (const channel of channels) {
    topics.set(client.subscribe(channel.id), channel.topic);
    messages[channel.topic] = [];
    JSON.parse(channel.schema);
  }
});
client.on("message", ({ subscriptionId, data }) => messages[topics.get(subscriptionId)].push(JSON.parse(decoder.decode(data))));
client.on("advertiseServices", async (list) => {
  for (const { id, name } of list) services[name] = id;
  await call("/pause", {});
  for (const topic of Object.keys(messages)) messages[topic] = [];
  await call("/reset", {});
  const place = await call("/step", { steps });
  if (place.step !== steps && place.episode < 2) throw new Error(JSON.stringify(place));
  const all = await parameters((id) => client.getParameters([], id), "all");
  const state = all.find((each) => !each.name.startsWith("environment/") && each.value != undefined);
  let parameter = "no parameters";
  if (state) {
    const wanted = { name: state.name, value: state.value };
    await parameters((id) => client.setParameters([wanted], id), "set");
    await call("/reset", {});
    const [now] = await parameters((id) => client.getParameters([state.name], id), "again");
    if (JSON.stringify(now.value) !== JSON.stringify(state.value)) throw new Error(JSON.stringify([now, state]));
    parameter = `${state.name} set to ${JSON.stringify(state.value)}`;
  }
  process.stdout.write(JSON.stringify({ messages, parameter, schema: SceneUpdate }), () => process.exit(0));
});
