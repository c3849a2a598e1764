// Starts `eagerx-gen lsp` and brings what it says to VS Code; buttons that run a graph.
"use strict";
const vscode = require("vscode");
const {Client} = require("./client.js");
const convert = require("./convert.js");
const providers = require("./providers.js");

const MOST_STARTS = 4;  // of a server that ends by itself

const basename = (document) => document.uri.path.split("/").pop();
const isManifest = (document) => basename(document) === "manifest.yaml";
/** A graph has connections, or is only begun under its usual name. */
const isGraph = (document) => document.languageId === "yaml" && !isManifest(document) &&
    (/^(connections|engine|extends):/m.test(document.getText()) || /^graph.*\.yaml$/.test(basename(document)));
const isOurs = (document) => document.languageId === "yaml" && (isManifest(document) || isGraph(document));

const setting = (name) => vscode.workspace.getConfiguration("eagerx-gen").get(name);
const pathOptions = () => (setting("paths") ?? []).flatMap((path) => ["--path", path]);

class Session {
  constructor() {
    this.diagnostics = vscode.languages.createDiagnosticCollection("eagerx-gen");
    this.hintsChanged = new vscode.EventEmitter();
    this.open = new Set();  // URIs that the server knows
    this.watchers = [];
    this.starts = 0;
  }

  async start() {
    ++this.starts;
    const client = new Client(setting("command"), ["lsp", ...pathOptions()], {
      diagnostics: (params) =>
          this.diagnostics.set(vscode.Uri.parse(params.uri), params.diagnostics.map(convert.diagnostic)),
      request: (method, params) => this.asked(method, params),
      ended: (why) => this.ended(client, why),
    });
    this.client = client;
    this.ready = client
                     .ask("initialize", {
                       processId: process.pid,
                       rootUri: vscode.workspace.workspaceFolders?.[0]?.uri.toString() ?? null,
                       capabilities: {
                         textDocument: {completion: {completionItem: {snippetSupport: true}}},
                         workspace: {
                           didChangeWatchedFiles: {dynamicRegistration: true, relativePatternSupport: true},
                           inlayHint: {refreshSupport: true}
                         },
                       },
                     })
                     .then(() => {
                       client.tell("initialized", {});
                       vscode.workspace.textDocuments.forEach((document) => this.opened(document));
                     });
    await this.ready.catch(() => {});  // ended() tells of it
  }

  ended(client, why) {
    if (this.stopped || client !== this.client) return;
    this.forget();
    if (this.starts < MOST_STARTS && !/ENOENT/.test(why)) {
      this.start();
    } else {
      vscode.window.showErrorMessage(
          `eagerx-gen: \`${setting("command")} lsp\`: ${why}. The setting eagerx-gen.command names the program.`);
    }
  }
  forget() {
    this.open.clear();
    this.diagnostics.clear();
    this.watchers.splice(0).forEach((watcher) => watcher.dispose());
  }
  async stop() {
    this.stopped = true;
    this.forget();
    await this.client?.stop();
  }
  async restart() {
    await this.stop();
    this.stopped = false;
    this.starts = 0;
    await this.start();
  }

  /** What the server asks of the editor. */
  asked(method, params) {
    if (method === "workspace/inlayHint/refresh") this.hintsChanged.fire();
    if (method !== "client/registerCapability") return;
    for (const registration of params.registrations) {
      for (const {globPattern} of registration.registerOptions?.watchers ?? []) this.watch(globPattern);
    }
  }
  watch(glob) {
    const pattern =
        typeof glob === "string" ? glob : new vscode.RelativePattern(vscode.Uri.parse(glob.baseUri), glob.pattern);
    const watcher = vscode.workspace.createFileSystemWatcher(pattern);
    const tell = (type) => (uri) =>
        this.client.tell("workspace/didChangeWatchedFiles", {changes: [{uri: uri.toString(), type}]});
    watcher.onDidCreate(tell(1));
    watcher.onDidChange(tell(2));
    watcher.onDidDelete(tell(3));
    this.watchers.push(watcher);
  }

  opened(document) {
    const uri = document.uri.toString();
    if (!isOurs(document) || this.open.has(uri)) return;
    this.open.add(uri);
    this.client.tell(
        "textDocument/didOpen",
        {textDocument: {uri, languageId: "yaml", version: document.version, text: document.getText()}});
  }
  changed({document, contentChanges}) {
    const uri = document.uri.toString();
    if (!this.open.has(uri)) return this.opened(document);  // it has become a graph
    this.client.tell("textDocument/didChange", {
      textDocument: {uri, version: document.version},
      contentChanges: contentChanges.map((each) => ({range: convert.plainRange(each.range), text: each.text})),
    });
  }
  closed(document) {
    const uri = document.uri.toString();
    if (this.open.delete(uri)) this.client.tell("textDocument/didClose", {textDocument: {uri}});
  }
  saved(document) {
    const uri = document.uri.toString();
    if (this.open.has(uri)) this.client.tell("textDocument/didSave", {textDocument: {uri}});
  }

  async ask(document, method, params) {
    await this.ready;
    return this.open.has(document.uri.toString()) ? this.client.ask(`textDocument/${method}`, params) : null;
  }
}

/** Runs eagerx-gen with the graph of the editor in the terminal of a task; true if it went well. */
async function perform(words, after) {
  const document = vscode.window.activeTextEditor?.document;
  if (!document || !isGraph(document)) return vscode.window.showErrorMessage("eagerx-gen: open a graph first");
  if (document.isDirty && !(await document.save())) return undefined;
  const file = document.uri.fsPath;
  const options = [...words(file), ...pathOptions()];
  const folder = vscode.Uri.joinPath(document.uri, "..").fsPath;
  const task = new vscode.Task(
      {type: "eagerx-gen"}, vscode.TaskScope.Workspace, `${options[0]} ${basename(document)}`, "eagerx-gen",
      new vscode.ProcessExecution(setting("command"), options, {cwd: folder}));
  const execution = await vscode.tasks.executeTask(task);
  if (after) {
    const listener = vscode.tasks.onDidEndTaskProcess((event) => {
      if (event.execution !== execution) return;
      listener.dispose();
      if (event.exitCode === 0) after(file);
    });
  }
  return execution;
}
const page = (file) => file.replace(/\.yaml$/, "") + ".report.html";
const show = (file) => vscode.env.openExternal(vscode.Uri.file(page(file)));

async function activate(context) {
  const session = new Session();
  const ask = (document, method, params) => session.ask(document, method, params);
  const setContext = (editor) =>
      vscode.commands.executeCommand("setContext", "eagerx-gen.isGraph", Boolean(editor && isGraph(editor.document)));
  context.subscriptions.push(
      session.diagnostics, session.hintsChanged, ...providers.register(ask),
      providers.registerHints(ask, session.hintsChanged.event),
      vscode.workspace.onDidOpenTextDocument((document) => session.opened(document)),
      vscode.workspace.onDidChangeTextDocument((event) => session.changed(event)),
      vscode.workspace.onDidCloseTextDocument((document) => session.closed(document)),
      vscode.workspace.onDidSaveTextDocument((document) => session.saved(document)),
      vscode.workspace.onDidChangeConfiguration(
          (event) => event.affectsConfiguration("eagerx-gen") && session.restart()),
      vscode.window.onDidChangeActiveTextEditor(setContext),
      vscode.commands.registerCommand("eagerx-gen.run", () => perform((file) => ["run", file])),
      vscode.commands.registerCommand(
          "eagerx-gen.report", () => perform((file) => ["report", file, "-o", page(file)], show)),
      vscode.commands.registerCommand(
          "eagerx-gen.simulate", () => perform((file) => ["report", file, "--simulate", "-o", page(file)], show)),
      vscode.commands.registerCommand("eagerx-gen.restart", () => session.restart()), {dispose: () => session.stop()});
  setContext(vscode.window.activeTextEditor);
  await session.start();
  return session;
}

module.exports = {
  activate,
  deactivate : () => undefined
};
