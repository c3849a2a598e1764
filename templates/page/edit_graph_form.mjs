// Form of the graph itself: name, rate, engine, agent, task, and all other top-level keys.
import {field, parameterFields} from "./edit_forms.mjs";
import {keyField, mapFields, part, setOrRemove} from "./edit_map_form.mjs";
import {change, editing} from "./edit_store.mjs";
import {flowText, isName, yamlText} from "./edit_values.mjs";
import {el} from "./elements.mjs";

const kDrawnKeys = new Set(["objects", "nodes", "actions", "observations", "connections"]);
const kOwnForms = new Set(["name", "rate", "engine", "agent", "render", "task"]);

const aboutKey = (section, name) => (editing.sections[section] ?? []).find((key) => key.name === name) ?? {};

function topField(name, properties) {
  const key = aboutKey("top", name);
  return field({
    key: name,
    label: name,
    about: key.about,
    value: editing.model.top[name] ?? "",
    changed: (text) => setOrRemove([name], text),
    ...properties
  });
}

function engineParts() {
  const given = editing.model.top.engine ?? {}, type = typeof given.type === "string" ? given.type : "";
  const entity = editing.library.get(type);
  const engines = [...editing.library.values()].filter(({kind}) => kind === "engine");
  const choose = (id) =>
      (id && !given.type ?
           change([{kind: "set", path: ["engine"], value: `{type: ${id}, rate: ${editing.model.top.rate ?? 30}}`}]) :
           setOrRemove(id ? ["engine", "type"] : ["engine"], id));
  const choice = field({
    key: "engine.type",
    label: "type",
    about: entity?.summary ?? aboutKey("top", "engine").about,
    value: type,
    empty: "none",
    choices: engines.map(({id}) => [id, id]),
    changed: choose
  });
  if (!type) return part("engine", "none", [choice], true);
  const others = (editing.sections.engine ?? []).filter(({name}) => !["type", "config"].includes(name));
  return part(
      "engine", type,
      [
        choice, others.map((key) => keyField(["engine", key.name], given[key.name], key)),
        parameterFields(entity, given.config ?? {}, (name, value) => setOrRemove(["engine", "config", name], value))
      ],
      true);
}

const kAgents = [
  ["zero", "zero: every action is 0"], ["random", "random"], ["policy", "a trained policy"],
  ["csv", "a file of actions"]
];

const kIsFile = new Set(["policy", "csv"]);

/** Kind of agent: "zero", "random", "policy" or "csv". */
export function kindOfAgent(agent) {
  if (agent && typeof agent === "object") return agent.policy !== undefined ? "policy" : "csv";
  return agent ?? "";
}

/** Field for the agent's file: a policy, or recorded actions. */
function agentFile(kind, agent) {
  const write = (text) => {
    const value = yamlText(text.trim());
    if (!text.trim()) return;
    change(
        [kindOfAgent(agent) === file.kind ? {kind: "set", path: ["agent", file.kind], value} :
                                            {kind: "set", path: ["agent"], value: `{${file.kind}: ${value}}`}]);
  };
  const file = field({
    key: "agent.file",
    label: "file",
    about: "its path from the folder of the graph",
    value: agent?.[kind] ?? "",
    empty: "required",
    changed: write
  });
  file.kind = kind;
  file.hidden = !kIsFile.has(kind);
  return file;
}

function agentParts() {
  const {agent} = editing.model.top, kind = kindOfAgent(agent), file = agentFile(kind, agent);
  const choose = (chosen) => {
    file.hidden = !kIsFile.has(chosen);
    file.kind = chosen;
    if (file.hidden) return setOrRemove(["agent"], chosen);
    file.input.value = "";
    return file.input.focus();
  };
  const choice = field({
    key: "agent.kind",
    label: "who decides",
    value: kind,
    empty: "zero (default)",
    choices: kAgents,
    changed: choose
  });
  const settings = kind === "policy" ? (editing.sections.agent ?? []).filter(({name}) => !kIsFile.has(name)) : [];
  const fieldOf = (key) => keyField(["agent", key.name], agent[key.name], key);
  return part(
      "agent", kIsFile.has(kind) ? flowText(agent[kind]) : kind || "zero",
      [
        choice, file, settings.filter(({name}) => name in agent).map(fieldOf),
        settings.length ? part("more of the policy", "", settings.filter(({name}) => !(name in agent)).map(fieldOf)) :
                          null
      ],
      true);
}

function renderParts() {
  const {render} = editing.model.top;
  const outputs = editing.model.boxes.flatMap((box) => (box.kind === "end" ? [] : box.outputs));
  const pictures = outputs.filter(({shape}) => shape?.length >= 2).map(({address}) => address);
  const source = field({
    key: "render.source",
    label: "source",
    about: aboutKey("render", "source").about,
    value: render?.source ?? "",
    empty: "nothing is shown",
    choices: [...new Set([...pictures, ...outputs.map(({address}) => address)])].map((address) => [address, address]),
    changed: (text) =>
        (text ? render ? setOrRemove(["render", "source"], text) :
                         change([{kind: "set", path: ["render"], value: `{source: ${text}}`}]) :
                setOrRemove(["render"], ""))
  });
  return part(
      "render", render?.source ?? "none",
      [source, render ? keyField(["render", "rate"], render.rate, aboutKey("render", "rate")) : null]);
}

function otherPart(key) {
  const value = editing.model.top[key.name],
        isMap = value !== null && typeof value === "object" && !Array.isArray(value);
  if (isMap || key.kind === "map")
    return part(
        key.name, value === undefined ? "none" : "",
        [el("small.block", {}, key.about), mapFields([key.name], value, editing.sections[key.name] ?? [])]);
  return keyField([key.name], value, key);
}

export function graphForm() {
  const {top} = editing.model;
  const others = (editing.sections.top ?? []).filter(({name}) => !kDrawnKeys.has(name) && !kOwnForms.has(name));
  const task = {name: "task", kind: "map", ...aboutKey("top", "task")};
  const isGroup = (key) => key.kind === "map" || typeof top[key.name] === "object";
  return [
    el("p.kind", {}, "graph"), el("h2", {}, top.name || editing.client.state.file || "a new graph"),
    topField(
        "name", {fault: (text) => (isName(text) ? "" : "letters, digits and _, a letter first"), empty: "required"}),
    topField("rate", {limits: "Hz", empty: "required"}), engineParts(), agentParts(), otherPart(task), renderParts(),
    part(
        "more", "every other key of the graph",
        [others.filter((key) => !isGroup(key)).map(otherPart), others.filter(isGroup).map(otherPart)])
  ];
}
