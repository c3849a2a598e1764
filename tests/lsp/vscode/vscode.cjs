// As much of VS Code's module as the extension uses, for tests in Node: editors, documents and what is registered.
"use strict";

class Position {
  constructor(line, character) { Object.assign(this, { line, character }); }
}
class Range {
  constructor(start, end) { Object.assign(this, { start, end }); }
}
class Uri {
  constructor(scheme, path) { Object.assign(this, { scheme, path, fsPath: path }); }
  static parse(text) {
    const [, scheme, path] = /^(\w+):(?:\/\/)?(.*)$/.exec(text);
    return new Uri(scheme, decodeURIComponent(path));
  }
  static file(path) { return new Uri("file", path); }
  static joinPath(uri, ...parts) { return new Uri(uri.scheme, require("node:path").posix.join(uri.path, ...parts)); }
  toString() { return this.scheme === "file" ? `file://${encodeURI(this.path)}` : `${this.scheme}:${this.path}`; }
}
class EventEmitter {
  constructor() {
    this.listeners = new Set();
    this.event = (listener) => {
      this.listeners.add(listener);
      return { dispose: () => this.listeners.delete(listener) };
    };
  }
  fire(value) { for (const listener of [...this.listeners]) listener(value); }
  dispose() { this.listeners.clear(); }
}
class TextDocument {
  constructor(uri, text, languageId = "yaml") { Object.assign(this, { uri, text, languageId, version: 1, isDirty: false }); }
  getText() { return this.text; }
  offset({ line, character }) { // as JavaScript counts: UTF-16
    const lines = this.text.split("\n").slice(0, line);
    return lines.reduce((sum, each) => sum + each.length + 1, 0) + character;
  }
  position(offset) {
    const before = this.text.slice(0, offset).split("\n");
    return new Position(before.length - 1, before.at(-1).length);
  }
  async save() {
    require("node:fs").writeFileSync(this.uri.fsPath, this.text);
    this.isDirty = false;
    events.saved.fire(this);
    return true;
  }
}

const plainClass = (...names) => class { constructor(...values) { names.forEach((name, i) => { this[name] = values[i]; }); } };
const events = Object.fromEntries(["opened", "changed", "closed", "saved", "configuration", "editor", "taskEnded"].map((name) => [name, new EventEmitter()]));
const registered = { providers: {}, commands: {}, context: {}, watchers: [], errors: [], shown: [], collection: new Map() };
const settings = {};
const provide = (kind) => (_selector, provider) => {
  registered.providers[kind] = provider;
  return { dispose: () => delete registered.providers[kind] };
};

class WorkspaceEdit {
  constructor() { this.edits = []; }
  replace(uri, range, text) { this.edits.push({ uri, range, text }); }
}

module.exports = {
  Position, Range, Uri, EventEmitter, WorkspaceEdit,
  Location: plainClass("uri", "range"),
  Diagnostic: plainClass("range", "message", "severity"),
  DiagnosticRelatedInformation: plainClass("location", "message"),
  MarkdownString: plainClass("value"),
  SnippetString: plainClass("value"),
  CompletionItem: plainClass("label", "kind"),
  CodeAction: plainClass("title", "kind"),
  CodeActionKind: { QuickFix: "quickfix" },
  DocumentSymbol: plainClass("name", "detail", "kind", "range", "selectionRange"),
  FoldingRange: plainClass("start", "end", "kind"),
  FoldingRangeKind: { Comment: 1, Region: 3 },
  InlayHint: plainClass("position", "label"),
  Hover: plainClass("contents", "range"),
  RelativePattern: plainClass("base", "pattern"),
  Task: plainClass("definition", "scope", "name", "source", "execution"),
  TaskScope: { Workspace: 2 },
  ProcessExecution: plainClass("process", "args", "options"),
  languages: {
    createDiagnosticCollection: () => ({
      set: (uri, list) => registered.collection.set(uri.toString(), list),
      clear: () => registered.collection.clear(),
      dispose: () => {},
    }),
    registerCompletionItemProvider: provide("completion"), registerHoverProvider: provide("hover"),
    registerDefinitionProvider: provide("definition"), registerReferenceProvider: provide("references"),
    registerRenameProvider: provide("rename"), registerCodeActionsProvider: provide("actions"),
    registerDocumentSymbolProvider: provide("symbols"), registerFoldingRangeProvider: provide("folds"),
    registerInlayHintsProvider: provide("hints"),
  },
  workspace: {
    textDocuments: [],
    workspaceFolders: undefined,
    getConfiguration: () => ({ get: (name) => settings[name] }),
    onDidOpenTextDocument: events.opened.event, onDidChangeTextDocument: events.changed.event,
    onDidCloseTextDocument: events.closed.event, onDidSaveTextDocument: events.saved.event,
    onDidChangeConfiguration: events.configuration.event,
    createFileSystemWatcher: (pattern) => {
      const watcher = { pattern, changed: new EventEmitter(), dispose: () => registered.watchers.splice(registered.watchers.indexOf(watcher), 1) };
      watcher.onDidCreate = watcher.onDidDelete = () => ({ dispose() {} });
      watcher.onDidChange = watcher.changed.event;
      registered.watchers.push(watcher);
      return watcher;
    },
  },
  window: {
    activeTextEditor: undefined,
    onDidChangeActiveTextEditor: events.editor.event,
    showErrorMessage: async (text) => { registered.errors.push(text); },
  },
  commands: {
    registerCommand: (name, run) => {
      registered.commands[name] = run;
      return { dispose: () => delete registered.commands[name] };
    },
    executeCommand: async (name, key, value) => { if (name === "setContext") registered.context[key] = value; },
  },
  tasks: {
    executeTask: async (task) => ({ task }),
    onDidEndTaskProcess: events.taskEnded.event,
  },
  env: { openExternal: async (uri) => registered.shown.push(uri.fsPath) },
  // For tests:
  registered, settings, events, TextDocument,
  /** A change as somebody types it: [from, to) of the text becomes `text`. */
  type(document, from, to, text) {
    const range = new Range(document.position(from), document.position(to));
    document.text = document.text.slice(0, from) + text + document.text.slice(to);
    ++document.version;
    document.isDirty = true;
    events.changed.fire({ document, contentChanges: [{ range, text }] });
  },
};
