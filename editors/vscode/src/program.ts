// Which program commands and views are about.

import * as vscode from "vscode";

/** The program of the editor in front, else the last one that was: a picture, a view or the walkthrough may have the focus. */
export class Current implements vscode.Disposable {
  private last: vscode.Uri | undefined;
  private readonly listening: vscode.Disposable;

  constructor() {
    const note = (editor: vscode.TextEditor | undefined): void => {
      if (editor?.document.languageId === "psdl") this.last = editor.document.uri;
    };
    note(vscode.window.activeTextEditor ?? vscode.window.visibleTextEditors.find(({ document }) => document.languageId === "psdl"));
    this.listening = vscode.window.onDidChangeActiveTextEditor(note);
  }

  /** Its document, if it is still open. */
  get document(): vscode.TextDocument | undefined {
    const active = vscode.window.activeTextEditor?.document;
    if (active?.languageId === "psdl") return active;
    const known = vscode.workspace.textDocuments.filter(({ languageId, isClosed }) => languageId === "psdl" && !isClosed);
    return known.find(({ uri }) => uri.toString() === this.last?.toString()) ?? known[0];
  }

  /** An editor of it, which is brought to the front if none can be seen; the user is told if there is no program. */
  async editor(): Promise<vscode.TextEditor | undefined> {
    const { document } = this;
    if (document === undefined) {
      void vscode.window.showInformationMessage("Open a .psdl file first.");
      return undefined;
    }
    const active = vscode.window.activeTextEditor;
    if (active?.document === document) return active;
    return vscode.window.visibleTextEditors.find(editor => editor.document === document) ?? vscode.window.showTextDocument(document, { preview: false });
  }

  dispose(): void {
    this.listening.dispose();
  }
}
