// The extension of VS Code against the real server, with a module `vscode` of our own.
"use strict";
const assert = require("node:assert");
const { execFileSync } = require("node:child_process");
const fs = require("node:fs");
const Module = require("node:module");
const os = require("node:os");
const path = require("node:path");
const { test, before, after } = require("node:test");

const mock = require("./vscode.cjs");
const root = path.resolve(__dirname, "../../..");
const source = path.join(root, "generator/tools/lsp/vscode");
const load = Module._load;
Module._load = (name, ...rest) => (name === "vscode" ? mock : load(name, ...rest));
const extension = require(path.join(source, "extension.js"));

process.env.EAGERX_HOME = root;
const eagerxGen = path.join(process.env.EAGERX_BUILD ?? path.join(root, "build-release"), "eagerx-gen");
const folder = fs.mkdtempSync(path.join(os.tmpdir(), "vscode-"));
const robot = path.join(folder, "my robot");
const file = path.join(robot, "graph.yaml");
const context = { subscriptions: [] };
let session, document, text;

async function until(what, condition) {
  for (let i = 0; i < 1000; ++i) {
    if (await condition()) return;
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
  assert.fail(`never: ${what}`);
}
const problems = () => mock.registered.collection.get(document.uri.toString()) ?? [];
const at = (word, further = 1) => document.position(document.text.indexOf(word) + further);
const provider = (kind) => mock.registered.providers[kind];
const part = ({ start, end }) => document.text.slice(document.offset(start), document.offset(end));

before(async () => {
  fs.cpSync(path.join(root, "examples/pendulum_swing_up"), robot, { recursive: true });
  text = fs.readFileSync(file, "utf8");
  document = new mock.TextDocument(mock.Uri.file(file), text.replace("type: Pendulum", "type: Pendulm"));
  mock.settings.command = eagerxGen;
  mock.settings.paths = [];
  mock.workspace.textDocuments = [document, new mock.TextDocument(mock.Uri.file("/other.yaml"), "a: b\n")];
  mock.window.activeTextEditor = { document };
  session = await extension.activate(context);
});
after(async () => {
  for (const each of context.subscriptions) await each.dispose();
  fs.rmSync(folder, { recursive: true });
});

test("problems, and their help as a quick fix", async () => {
  await until("a problem", () => problems().some((each) => each.code === "E0303"));
  const [problem] = problems();
  assert.strictEqual(part(problem.range), "Pendulm");
  assert.strictEqual(problem.severity, 0); // DiagnosticSeverity.Error
  const actions = await provider("actions").provideCodeActions(document, problem.range);
  assert.strictEqual(actions[0].title, "Change to `Pendulum`");
  const [edit] = actions[0].edit.edits;
  assert.strictEqual(edit.uri.toString(), document.uri.toString());
  mock.type(document, document.offset(edit.range.start), document.offset(edit.range.end), edit.text);
  assert.strictEqual(document.text, text);
  await until("no problem", () => problems().length === 0);
  assert.ok(![...mock.registered.collection.keys()].some((uri) => uri.includes("other")), "a file that is none of ours");
});

test("completion with snippets, also behind an emoji", async () => {
  const line = "# \u{1f916} e\u0301\n";
  mock.type(document, 0, 0, line);
  const begin = document.text.length;
  mock.type(document, begin, begin, "nodes2: 0\n");
  mock.type(document, begin, document.text.length, "teleme");
  const items = await provider("completion").provideCompletionItems(document, document.position(document.text.length));
  assert.strictEqual(items[0].label, "telemetry");
  assert.strictEqual(part(items[0].range), "teleme");
  const name = document.text.indexOf("\n  smooth:") + 1;
  mock.type(document, name, name, "  butter\n");
  const snippets = (await provider("completion").provideCompletionItems(document, document.position(name + 8)))
    .filter((each) => each.insertText instanceof mock.SnippetString);
  assert.match(snippets[0].insertText.value, /^\$\{1:butterworth_filter\}: \{type: ButterworthFilter, rate: \$\{2:30\}/);
  mock.type(document, 0, document.text.length, text);
  await until("no problem", () => problems().length === 0);
});

test("hover, definition, references, renaming", async () => {
  const hover = await provider("hover").provideHover(document, at("to: pendulum.u", 6));
  assert.match(hover.contents.value, /1 a tick/);
  const there = await provider("definition").provideDefinition(document, at("type: Pendulum", 8));
  assert.match(there.uri.fsPath, /models\/objects\/pendulum\/manifest.yaml$/);
  const uses = await provider("references").provideReferences(document, at("  pendulum:", 3));
  assert.ok(uses.length >= 5, `${uses.length}`);
  const prepared = await provider("rename").prepareRename(document, at("  pendulum:", 3));
  assert.strictEqual(prepared.placeholder, "pendulum");
  const edit = await provider("rename").provideRenameEdits(document, at("  pendulum:", 3), "arm");
  assert.strictEqual(edit.edits.length, uses.length);
  await assert.rejects(provider("rename").provideRenameEdits(document, at("  pendulum:", 3), "smooth"), /taken/);
  await assert.rejects(provider("rename").prepareRename(document, at("rate:")), /named here/);
});

test("outline, folding, hints", async () => {
  const symbols = await provider("symbols").provideDocumentSymbols(document);
  const objects = symbols.find((each) => each.name === "objects");
  assert.strictEqual(objects.children[0].name, "pendulum");
  const folds = await provider("folds").provideFoldingRanges(document);
  assert.ok(folds.some((each) => each.kind === mock.FoldingRangeKind.Comment) && folds.length > 5);
  const all = new mock.Range(new mock.Position(0, 0), document.position(document.text.length));
  const hints = await provider("hints").provideInlayHints(document, all);
  assert.deepStrictEqual(hints.map((each) => /tick/.test(each.label)), [false, true, true, true, true]); // the object's rate, four connections
});

test("files that change", async () => {
  assert.strictEqual(mock.registered.watchers.length, 1);
  const weights = path.join(robot, "swing_up.onnx");
  const good = fs.readFileSync(weights);
  fs.writeFileSync(weights, "nothing");
  mock.registered.watchers[0].changed.fire(mock.Uri.file(weights));
  await until("a problem of the weights", () => problems().some((each) => each.code.startsWith("E06")));
  fs.writeFileSync(weights, good);
  mock.registered.watchers[0].changed.fire(mock.Uri.file(weights));
  await until("no problem", () => problems().length === 0);
});

test("buttons", async () => {
  assert.strictEqual(mock.registered.context["eagerx-gen.isGraph"], true);
  mock.type(document, 0, 0, "# saved first\n");
  const { task } = await mock.registered.commands["eagerx-gen.run"]();
  assert.deepStrictEqual(task.execution.args, ["run", file]);
  assert.strictEqual(task.execution.options.cwd.replace(/\/$/, ""), robot);
  assert.ok(fs.readFileSync(file, "utf8").startsWith("# saved first"));
  const execution = await mock.registered.commands["eagerx-gen.report"]();
  const { process: program, args, options } = execution.task.execution;
  execFileSync(program, args, { cwd: options.cwd, stdio: "ignore" });
  mock.events.taskEnded.fire({ execution, exitCode: 0 });
  assert.deepStrictEqual(mock.registered.shown, [path.join(robot, "graph.report.html")]);
  assert.match(fs.readFileSync(mock.registered.shown[0], "utf8"), /pendulum_swing_up/);
  const simulate = await mock.registered.commands["eagerx-gen.simulate"]();
  assert.ok(simulate.task.execution.args.includes("--simulate"));
  mock.window.activeTextEditor = undefined;
  await mock.registered.commands["eagerx-gen.run"]();
  assert.match(mock.registered.errors.pop(), /open a graph/);
  mock.events.editor.fire(undefined);
  assert.strictEqual(mock.registered.context["eagerx-gen.isGraph"], false);
});

test("a document that becomes a graph, one that is closed", async () => {
  const other = mock.workspace.textDocuments[1];
  mock.type(other, 0, other.text.length, "name: x\nconnections: 3\n");
  await until("problems", () => (mock.registered.collection.get(other.uri.toString()) ?? []).length > 0);
  mock.events.closed.fire(other);
  await until("none", () => mock.registered.collection.get(other.uri.toString()).length === 0);
  assert.deepStrictEqual(await provider("symbols").provideDocumentSymbols(other), []);
});

test("a server that ends is started again; a missing one is reported", async () => {
  session.client.process.kill();
  await until("a new server", () => session.client && !session.client.ended && session.open.size === 1);
  mock.type(document, 0, 0, "wrong: [\n");
  await until("a problem", () => problems().length > 0);
  mock.settings.command = path.join(folder, "nothing");
  mock.events.configuration.fire({ affectsConfiguration: () => true });
  await until("an error", () => mock.registered.errors.length > 0);
  assert.match(mock.registered.errors.pop(), /ENOENT/);
  mock.settings.command = eagerxGen;
  await mock.registered.commands["eagerx-gen.restart"]();
  await until("a problem", () => problems().length > 0);
});

test("what is registered is what the manifest declares", () => {
  const manifest = JSON.parse(fs.readFileSync(path.join(source, "package.json"), "utf8"));
  assert.deepStrictEqual(manifest.contributes.commands.map((each) => each.command).sort(), Object.keys(mock.registered.commands).sort());
  assert.strictEqual(manifest.dependencies, undefined);
  const version = [...fs.readFileSync(path.join(root, "runtime/eagerx/version.hpp"), "utf8").matchAll(/kVersion\w* = (\d+);/g)]
    .map((each) => each[1]).join(".");
  assert.strictEqual(manifest.version, version);
  for (const each of [...manifest.files, manifest.main]) assert.ok(fs.existsSync(path.join(source, each)), each);
});

test("the grammar finds references, units and functions", () => {
  const grammar = JSON.parse(fs.readFileSync(path.join(source, "expressions.json"), "utf8")).repository;
  const matches = (name, line) => [...line.matchAll(new RegExp(grammar[name].match, "g"))].map((each) => each[0].trim());
  assert.deepStrictEqual(matches("reference", "rate: $(sensors theta rate), config: {n: $(config size)}"), ["$(sensors theta rate)", "$(config size)"]);
  assert.deepStrictEqual(matches("quantity", "rate: 30 Hz, delay: 1.5ms, n: 3"), ["30 Hz", "1.5ms"]);
  assert.deepStrictEqual(matches("function", "value: cos(th) - clamp(x, 0, 1) + other(y)"), ["cos", "clamp"]);
  assert.deepStrictEqual(matches("port", "- {from: pendulum.theta, to: leg[*].torque}"), ["pendulum.theta", "leg[*].torque"]);
});

function filesOf(folder, above = "") {
  return fs.readdirSync(folder, { withFileTypes: true }).flatMap((each) => {
    const name = above + each.name;
    const there = path.join(folder, each.name);
    return each.isDirectory() ? filesOf(there, `${name}/`) : [[name, fs.readFileSync(there, "utf8")]];
  });
}

// Every file of the archive, as its name and text: the archive itself has times of access, too.
function unpacked(archive) {
  const to = `${archive}.unpacked`;
  fs.mkdirSync(to);
  execFileSync("cmake", ["-E", "tar", "xf", archive], { cwd: to, stdio: "pipe" });
  return filesOf(to).sort();
}

test("packed without a network, twice the same", () => {
  const made = ["a.vsix", "b.vsix"].map((name) => {
    const archive = path.join(folder, name);
    execFileSync("cmake", ["-D", `OUTPUT=${archive}`, "-P", path.join(source, "pack.cmake")], { stdio: "pipe" });
    return unpacked(archive);
  });
  assert.deepEqual(made[0], made[1]);
  const names = made[0].map(([name]) => name);
  for (const each of ["extension/extension.js", "extension/package.json", "extension.vsixmanifest", "[Content_Types].xml"])
    assert.ok(names.includes(each), each);
  assert.ok(!names.some((name) => name.includes("node_modules")));
});
