// A real VS Code workbench (code-server) in a headless Chromium, for one run; all that it writes is in a folder of its own.
import { execFileSync, spawn } from "node:child_process";
import fs from "node:fs";
import { createRequire } from "node:module";
import net from "node:net";
import os from "node:os";
import path from "node:path";

const { chromium } = createRequire(`${process.env.PLAYWRIGHT_DIR}/`)("playwright-core");
const { CODE_SERVER, NODE24, CHROMIUM } = process.env;

/** Waits until something is true; the first true value. */
export async function until(what, condition, milliseconds = 60_000) {
  for (const end = Date.now() + milliseconds; ; ) {
    const value = await condition();
    if (value) return value;
    if (Date.now() > end) throw new Error(`never: ${what}`);
    await new Promise(resolve => setTimeout(resolve, 50));
  }
}

function freePort() {
  return new Promise(resolve => {
    const server = net.createServer().listen(0, "127.0.0.1", () => {
      const { port } = server.address();
      server.close(() => resolve(port));
    });
  });
}

/** What the tests want to be the same everywhere, and nothing that asks the network. */
const SETTINGS = {
  "workbench.startupEditor": "none",
  "workbench.enableExperiments": false,
  "workbench.tips.enabled": false,
  "workbench.editor.useModal": "off",
  "workbench.reduceMotion": "on",
  "workbench.secondarySideBar.defaultVisibility": "hidden",
  "telemetry.telemetryLevel": "off",
  "extensions.autoUpdate": false,
  "extensions.autoCheckUpdates": false,
  "extensions.ignoreRecommendations": true,
  "update.mode": "none",
  "editor.minimap.enabled": false,
  "editor.lightbulb.enabled": "on",
  "files.autoSave": "off",
  "git.enabled": false,
  "chat.disableAIFeatures": true,
  "chat.commandCenter.enabled": false,
  "psdl.server.logLevel": "debug",
};

export class Workbench {
  /** @param {string} name of the run: what is left behind after a failure begins with it */
  constructor(name, { files, settings = {}, options = [], env = {} }) {
    this.name = name;
    this.out = process.env.PSDL_EDITORS_OUT ?? os.tmpdir();
    this.folder = fs.mkdtempSync(path.join(os.tmpdir(), "psdl-vscode-"));
    this.files = path.join(this.folder, "files");
    this.user = path.join(this.folder, "user");
    this.extensions = path.join(this.folder, "extensions");
    for (const folder of [this.files, path.join(this.user, "User"), this.extensions]) fs.mkdirSync(folder, { recursive: true });
    for (const [file, text] of Object.entries(files)) fs.writeFileSync(path.join(this.files, file), text);
    fs.writeFileSync(path.join(this.folder, "config.yaml"), "");
    fs.writeFileSync(path.join(this.user, "User", "settings.json"), JSON.stringify({ ...SETTINGS, ...settings }));
    this.options = options;
    this.env = { ...process.env, EXTENSIONS_GALLERY: '{"serviceUrl":""}', PATH: `${path.dirname(NODE24)}:${process.env.PATH}`, ...env };
    // Whoever ends this run means what it started as well.
    for (const signal of ["SIGTERM", "SIGINT"]) process.once(signal, () => void this.keep().finally(() => this.stop().finally(() => process.exit(1))));
    this.common = ["--config", path.join(this.folder, "config.yaml"), "--user-data-dir", this.user, "--extensions-dir", this.extensions];
  }

  /** Installs an extension from its package, as a user does. */
  install(vsix) {
    execFileSync(NODE24, [CODE_SERVER, ...this.common, "--install-extension", vsix], { env: this.env, stdio: "ignore" });
  }

  async start() {
    this.port = await freePort();
    this.log = path.join(this.folder, "code-server.log");
    const log = fs.openSync(this.log, "w");
    const options = ["--bind-addr", `127.0.0.1:${this.port}`, "--auth", "none", "--disable-telemetry", "--disable-update-check", "--disable-getting-started-override"];
    this.server = spawn(NODE24, [CODE_SERVER, ...this.common, ...options, ...this.options, this.files], { env: this.env, stdio: ["ignore", log, log], detached: true });
    await until("code-server", async () => {
      try {
        return (await fetch(`http://127.0.0.1:${this.port}/healthz`)).ok;
      } catch {
        return false;
      }
    });
    const switches = ["--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"];
    this.browser = await chromium.launch({ executablePath: CHROMIUM, headless: true, args: switches });
    this.page = await (await this.browser.newContext({ viewport: { width: 1400, height: 900 } })).newPage();
    this.page.setDefaultTimeout(60_000);
    this.console = [];
    this.page.on("console", message => this.console.push(`${message.type()} ${message.text()}`));
  }

  /** Opens the folder of the files; `query` goes into the address. */
  async open(query = "") {
    await this.page.goto(`http://127.0.0.1:${this.port}/?folder=${encodeURIComponent(this.files)}${query}`, { timeout: 90_000 });
    await this.page.waitForSelector(".monaco-workbench", { timeout: 60_000 });
  }

  /** Keeps what helps to understand a failure. */
  async keep() {
    fs.mkdirSync(this.out, { recursive: true });
    const at = file => path.join(this.out, `${this.name}-${file}`);
    await this.page?.screenshot({ path: at("screenshot.png") }).catch(() => undefined);
    fs.writeFileSync(at("console.log"), (this.console ?? []).join("\n"));
    if (this.log) fs.copyFileSync(this.log, at("code-server.log"));
    for (const file of fs.readdirSync(this.user, { recursive: true })) {
      if (/PSDL.*\.log$/.test(file)) fs.copyFileSync(path.join(this.user, file), at(path.basename(file).replace(/^\d+-/, "")));
    }
    console.log(`left behind: ${at("*")}`);
  }

  async stop() {
    await this.browser?.close().catch(() => undefined);
    if (this.server !== undefined) {
      const ended = new Promise(resolve => this.server.once("exit", resolve));
      const signal = name => {
        try {
          process.kill(-this.server.pid, name);
        } catch {
          // it has ended
        }
      };
      signal("SIGTERM");
      await Promise.race([ended, new Promise(resolve => setTimeout(resolve, 3000))]);
      signal("SIGKILL");
    }
    fs.rmSync(this.folder, { recursive: true, force: true, maxRetries: 5, retryDelay: 100 });
  }
}

/** Runs steps in order; a failed one ends the run, since those after it build on it. */
export async function steps(workbench, list) {
  let passed = 0;
  let failed = 0;
  const begun = Date.now();
  for (const [name, body] of list) {
    try {
      await body();
      passed++;
      console.log(`ok - ${name} (${((Date.now() - begun) / 1000).toFixed(1)} s)`);
    } catch (error) {
      failed++;
      console.log(`not ok - ${name} (${((Date.now() - begun) / 1000).toFixed(1)} s): ${error.stack ?? error}`);
      await workbench.keep();
      break;
    }
  }
  console.log(`${passed} passed, ${failed} failed`);
  return failed === 0 ? 0 : 1;
}
