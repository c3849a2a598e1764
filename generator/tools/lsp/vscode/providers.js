// VS Code's requests about a language, passed to the server.
"use strict";
const vscode = require("vscode");
const convert = require("./convert.js");

const of = (document) => ({textDocument: {uri: document.uri.toString()}});
const at = (document, position) => ({...of(document), position: convert.plain(position)});

/** `ask(document, method, params)`: a promise of the answer; null for a document that is none of eagerx-gen's. */
function register(ask) {
  const selector = {language: "yaml"};
  const list = async (answer, convertOne) => ((await answer) ?? []).map(convertOne);
  const orNothing = async (answer, convertIt) => {
    const result = await answer;
    return result ? convertIt(result) : undefined;
  };
  return [
    vscode.languages.registerCompletionItemProvider(
        selector, {
          provideCompletionItems: (document, position) => orNothing(
              ask(document, "completion", at(document, position)),
              (answer) => answer.items.map(convert.completionItem)),
        },
        ":", ".", " ", "{", "[", ","),
    vscode.languages.registerHoverProvider(selector, {
      provideHover: (document, position) => orNothing(
          ask(document, "hover", at(document, position)),
          (answer) => new vscode.Hover(convert.markdown(answer.contents.value), convert.range(answer.range))),
    }),
    vscode.languages.registerDefinitionProvider(selector, {
      provideDefinition: (document, position) =>
          orNothing(ask(document, "definition", at(document, position)), convert.location),
    }),
    vscode.languages.registerReferenceProvider(selector, {
      provideReferences: (document, position) => list(
          ask(document, "references", {...at(document, position), context: {includeDeclaration: true}}),
          convert.location),
    }),
    vscode.languages.registerRenameProvider(selector, {
      prepareRename: async (document, position) => {
        const answer = await ask(document, "prepareRename", at(document, position));
        if (!answer) throw new Error("no object, no node and no port of your own is named here");
        return {range: convert.range(answer.range), placeholder: answer.placeholder};
      },
      provideRenameEdits: (document, position, newName) =>
          orNothing(ask(document, "rename", {...at(document, position), newName}), convert.workspaceEdit),
    }),
    vscode.languages.registerCodeActionsProvider(
        selector, {
          provideCodeActions: (document, range) => list(
              ask(document, "codeAction",
                  {...of(document), range: convert.plainRange(range), context: {diagnostics: []}}),
              convert.codeAction),
        },
        {providedCodeActionKinds: [vscode.CodeActionKind.QuickFix]}),
    vscode.languages.registerDocumentSymbolProvider(selector, {
      provideDocumentSymbols: (document) => list(ask(document, "documentSymbol", of(document)), convert.symbol),
    }),
    vscode.languages.registerFoldingRangeProvider(selector, {
      // VS Code folds YAML by its indentation unless a provider answers.
      provideFoldingRanges: (document) =>
          orNothing(ask(document, "foldingRange", of(document)), (answer) => answer.map(convert.fold)),
    }),
  ];
}

/** `changed`: an event after which hints are asked for again. */
function registerHints(ask, changed) {
  return vscode.languages.registerInlayHintsProvider({language: "yaml"}, {
    onDidChangeInlayHints: changed,
    provideInlayHints: async (document, range) =>
        ((await ask(document, "inlayHint", {...of(document), range: convert.plainRange(range)})) ??
         []).map(convert.hint),
  });
}

module.exports = {
  register,
  registerHints
};
