// The frame of a web page: what it may load, and from where.

import { randomBytes } from "node:crypto";
import * as vscode from "vscode";

/** Says what a page may load, and nothing else: its own script and style. */
export function page(webview: vscode.Webview, extension: vscode.Uri, name: "picture" | "sliders", title: string): string {
  const nonce = randomBytes(18).toString("base64");
  const script = webview.asWebviewUri(vscode.Uri.joinPath(extension, "dist", `${name}.js`)).toString();
  const style = webview.asWebviewUri(vscode.Uri.joinPath(extension, "media", `${name}.css`)).toString();
  const policy = `default-src 'none'; style-src ${webview.cspSource}; script-src 'nonce-${nonce}'`;
  return `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<link rel="stylesheet" href="${style}">
<title>${title}</title>
</head>
<body>
<script nonce="${nonce}" src="${script}"></script>
</body>
</html>`;
}

/** What a page may load: only what is built for it. */
export function resources(extension: vscode.Uri): vscode.Uri[] {
  return ["dist", "media"].map(folder => vscode.Uri.joinPath(extension, folder));
}
