// The suite inside of VS Code's extension host: `suite.cjs`, with the whole API of VS Code.
import fs from "node:fs";
import path from "node:path";
import { until, Workbench } from "./workbench.mjs";

const here = import.meta.dirname;
const extension = process.env.EXTENSION;
const lamp = fs.readFileSync(path.join(here, "../../test/scenes/lamp.psdl"), "utf8");
const campsite = fs.readFileSync(path.join(here, "../../../examples/campsite.psdl"), "utf8");
const results = path.join(fs.mkdtempSync(path.join(process.env.PSDL_EDITORS_OUT, "host-")), "results.txt");
const workbench = new Workbench("host", {
  files: { "lamp.psdl": lamp, "second.psdl": lamp, "campsite.psdl": campsite, "broken.psdl": `\`\`\`python\n${lamp}\`\`\`\n`, "plain.py": "x = 1\n" },
  settings: { "security.workspace.trust.enabled": false },
  options: ["--disable-workspace-trust", "--vscode-option", "enable-smoke-test-driver"],
  env: { PSDL_TEST_RESULT: results },
});
let code = 1;
try {
  await workbench.start();
  let ended;
  await workbench.page.exposeFunction("codeAutomationExit", status => {
    ended = status;
  });
  await workbench.page.exposeFunction("codeAutomationLog", () => undefined);
  const remote = file => `vscode-remote://127.0.0.1:${workbench.port}${file}`;
  const payload = [
    ["extensionDevelopmentPath", remote(extension)],
    ["extensionTestsPath", remote(path.join(here, "suite.cjs"))],
  ];
  await workbench.open(`&payload=${encodeURIComponent(JSON.stringify(payload))}`);
  await until("the end of the suite", () => ended !== undefined || (fs.existsSync(results) && /\d+ passed/.test(fs.readFileSync(results, "utf8"))), 540_000);
  const text = fs.readFileSync(results, "utf8");
  process.stdout.write(text);
  code = / 0 failed\n$/.test(text) ? 0 : 1;
} catch (error) {
  console.log(error.stack ?? error);
  if (fs.existsSync(results)) process.stdout.write(fs.readFileSync(results, "utf8"));
  console.log("0 passed, 1 failed");
}
if (code !== 0) await workbench.keep();
await workbench.stop();
fs.rmSync(path.dirname(results), { recursive: true, force: true });
process.exit(code);
