// Model of the graph as the file has it, valid or not: boxes with ports, and wires between them. The library gives the
// ports of known entities; connections give those of unknown ones.

/** {entity, port} of an address such as `leg[0].phase` or `pendulum.states.model_state`; null if it is invalid. */
export function endOf(text) {
  const parts = /^([^.[]+(?:\[[^\]]*\])?(?:\/[^.[]+(?:\[[^\]]*\])?)*)\.(.+)$/.exec(String(text ?? "").trim());
  if (!parts) return null;
  // Elements of an array are drawn at the array, and elements of a message at its port. A composite hides its content.
  return {entity: parts[1].replace(/\[[^\]]*\]/g, ""), port: parts[2].replace(/\[[^\]]*\]$/, "")};
}

/** Names in a list, or keys of a mapping. */
export function namesOf(value) {
  if (Array.isArray(value)) return value.filter((name) => typeof name === "string");
  return value && typeof value === "object" ? Object.keys(value) : [];
}

function portOf(entity, port, prefix = "") {
  return {...port, name: prefix + port.name, address: `${entity}.${prefix}${port.name}`};
}

function spaceOf(settings) {
  const space = settings && typeof settings === "object" ? settings.space : null;
  if (!space || typeof space !== "object") return {};
  const shape = Array.isArray(space.shape) ? space.shape.map(Number) : undefined;
  return {...space, ...(shape ? {shape} : {})};
}

/** Box of one end of the environment: actions on the left, or observations on the right. */
function endBox(section, declared) {
  const ports = namesOf(declared).map((name) => ({
                                        ...spaceOf(declared[name]),
                                        name,
                                        address: `${section}.${name}`,
                                      }));
  const isLeft = section === "actions";
  return {
    name: section,
    kind: "end",
    section,
    title: section,
    subtitle: isLeft ? "what the agent decides" : "what the agent sees",
    about: "",
    inputs: isLeft ? [] : ports,
    outputs: isLeft ? ports : []
  };
}

function subtitleOf(settings) {
  const count = settings.count ? ` × ${settings.count}` : "";
  const what = typeof settings.type === "string" ? settings.type : settings.policy ? "policy" : "no type yet";
  return what + count + (settings.rate ? ` · ${settings.rate} Hz` : "").replace(/ ?([kmM]?Hz) Hz$/, " $1");
}

const named = (names) => names.map((name) => ({name}));

function objectBox(name, settings, entity) {
  return {
    kind: "object",
    inputs: (entity?.actuators ?? named(namesOf(settings.actuators))).map((port) => portOf(name, port)),
    outputs: (entity?.sensors ?? named(namesOf(settings.sensors))).map((port) => portOf(name, port))
  };
}

function nodeBox(name, settings, entity) {
  const chosen = (ports, written) => {
    const names = namesOf(written);
    if (!ports) return named(names);
    return names.length ? ports.filter((port) => names.includes(port.name)) : ports;
  };
  const isReset = entity?.kind === "reset node";
  const outputs = chosen(entity?.outputs, settings.outputs);
  const inputs = chosen(entity?.inputs, settings.inputs);
  if (settings.policy && !outputs.length) outputs.push({name: "action"});
  return {
    kind: isReset ? "reset" : "node",
    inputs: [
      ...inputs.map((port) => portOf(name, port)),
      ...(isReset ? entity.targets ?? [] : []).map((port) => portOf(name, port, "targets.")),
      ...(isReset ? outputs : []).map((port) => portOf(name, port, "feedthroughs."))
    ],
    outputs: outputs.map((port) => portOf(name, port))
  };
}

function entityBox(section, name, written, library) {
  const settings = written && typeof written === "object" && !Array.isArray(written) ? written : {};
  const entity = library.get(settings.type);
  return {
    name,
    section,
    title: name,
    subtitle: subtitleOf(settings),
    about: entity?.summary ?? "",
    type: settings.type,
    settings,
    entity,
    ...(section === "objects" ? objectBox : nodeBox)(name, settings, entity)
  };
}

/** Index of a port in its box. Adds the port if it is not declared. */
function portNumber(box, side, {port}, entity) {
  const at = box[side].findIndex(({name}) => name === port);
  if (at >= 0) return at;
  return box[side].push({name: port, address: `${entity}.${port}`, unsaid: true}) - 1;
}

/** Index of the box that an end belongs to: that of its entity, or of the composite around the entity. */
function boxWith(end, numbers) {
  for (let name = end?.entity; name; name = name.slice(0, Math.max(0, name.lastIndexOf("/"))))
    if (numbers.has(name)) return numbers.get(name);
  return -1;
}

function wireOf(connection, number, boxes, numbers) {
  const from = endOf(connection?.from), to = endOf(connection?.to);
  const b = boxWith(from, numbers), t = boxWith(to, numbers);
  if (b < 0 || t < 0) return null;
  const output = portNumber(boxes[b], "outputs", from, from.entity);
  const input = portNumber(boxes[t], "inputs", to, to.entity);
  boxes[t].inputs[input].taken = true;
  boxes[b].outputs[output].used = true;
  return {number, connection, from: b, to: t, output, input};
}

/** Boxes and wires of `tree`, the file as strings, lists and mappings. `library`: entities by ID. */
export function modelOf(tree, library) {
  const top = tree && typeof tree === "object" && !Array.isArray(tree) ? tree : {};
  const boxes = [endBox("actions", top.actions)];
  for (const section of ["objects", "nodes"])
    for (const name of namesOf(top[section]))
      if (!Array.isArray(top[section])) boxes.push(entityBox(section, name, top[section][name], library));
  boxes.push(endBox("observations", top.observations));
  const connections = Array.isArray(top.connections) ? top.connections : [];
  const numbers = new Map(boxes.map(({name}, b) => [name, b]));
  const wires = connections.map((connection, number) => wireOf(connection, number, boxes, numbers)).filter(Boolean);
  const incoming = boxes.map(() => []);  // indices of the wires to each box
  wires.forEach(({to}, w) => incoming[to].push(w));
  return {top, boxes, wires, connections, incoming};
}

/** Names that are not available for another object or node. */
export function takenNames(model) {
  return new Set(model.boxes.map(({name}) => name).concat(["agent", "environment", "engine"]));
}

/** Element that shows a path of the file: {box}, {wire}, or null if there is none. */
export function drawnAs(model, path) {
  const [section, key] = path ?? [];
  if (section === "connections") {
    const wire = model.wires.findIndex(({number}) => number === Number(key));
    return wire < 0 ? null : {wire};
  }
  const isEnd = section === "actions" || section === "observations";
  const box = model.boxes.findIndex((one) => one.section === section && (isEnd || one.name === key));
  return box < 0 ? null : {box};
}
