// Between the protocol's values and those of VS Code. Both count lines and UTF-16 units from 0.
"use strict";
const vscode = require("vscode");

const position = (at) => new vscode.Position(at.line, at.character);
const range = (of) => new vscode.Range(position(of.start), position(of.end));
const plain = (at) => ({line: at.line, character: at.character});
const plainRange = (of) => ({start: plain(of.start), end: plain(of.end)});
const location = (one) => new vscode.Location(vscode.Uri.parse(one.uri), range(one.range));
const markdown = (text) => new vscode.MarkdownString(text);

function diagnostic(one) {
  // The protocol counts severities from 1, VS Code from 0.
  const result = new vscode.Diagnostic(range(one.range), one.message, (one.severity ?? 1) - 1);
  result.code = one.code;
  result.source = one.source;
  result.relatedInformation =
      (one.relatedInformation ??
       []).map((each) => new vscode.DiagnosticRelatedInformation(location(each.location), each.message));
  return result;
}

function completionItem(one) {
  const result = new vscode.CompletionItem(one.label, one.kind - 1);  // here, too
  result.documentation = markdown(one.documentation ?? "");
  result.sortText = one.sortText;
  result.filterText = one.filterText;
  result.insertText =
      one.insertTextFormat === 2 ? new vscode.SnippetString(one.textEdit.newText) : one.textEdit.newText;
  result.range = range(one.textEdit.range);
  return result;
}

function workspaceEdit(edit) {
  const result = new vscode.WorkspaceEdit();
  for (const [uri, edits] of Object.entries(edit.changes ?? {})) {
    for (const each of edits) result.replace(vscode.Uri.parse(uri), range(each.range), each.newText);
  }
  return result;
}

function codeAction(one) {
  const result = new vscode.CodeAction(one.title, vscode.CodeActionKind.QuickFix);
  result.diagnostics = one.diagnostics.map(diagnostic);
  result.edit = workspaceEdit(one.edit);
  result.isPreferred = one.isPreferred;
  return result;
}

function symbol(one) {
  const result =
      new vscode.DocumentSymbol(one.name, one.detail ?? "", one.kind - 1, range(one.range), range(one.selectionRange));
  result.children = (one.children ?? []).map(symbol);
  return result;
}

function fold(one) {
  const isComment = one.kind === "comment";
  return new vscode.FoldingRange(
      one.startLine, one.endLine, isComment ? vscode.FoldingRangeKind.Comment : vscode.FoldingRangeKind.Region);
}

function hint(one) {
  const result = new vscode.InlayHint(position(one.position), one.label);
  result.paddingLeft = one.paddingLeft;
  if (one.tooltip) result.tooltip = markdown(one.tooltip.value);
  return result;
}

module.exports = {
  position,
  range,
  plain,
  plainRange,
  location,
  markdown,
  diagnostic,
  completionItem,
  workspaceEdit,
  codeAction,
  symbol,
  fold,
  hint,
};
