// Makes psdl-TARGET.vsix with the program in it.   node scripts/package.mjs TARGET PROGRAM [OUT]
//   TARGET   of vsce: linux-x64, linux-arm64, alpine-x64, darwin-x64, darwin-arm64, win32-x64, win32-arm64
//   PROGRAM  a release build of psdl for it; `none` makes a package without one, for any platform
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";

const [target, program, out] = process.argv.slice(2);
if (target === undefined || program === undefined) throw new Error("usage: package.mjs TARGET PROGRAM [OUT]");
const file = out ?? `psdl-${target}.vsix`;
const windows = target.startsWith("win32");

fs.rmSync("server", { recursive: true, force: true });
if (program !== "none") {
  const copy = path.join("server", windows ? "psdl.exe" : "psdl");
  fs.mkdirSync("server");
  fs.copyFileSync(program, copy);
  fs.chmodSync(copy, 0o755);
  // Lines of the program are of no use to those who run it. Only a strip for the target can take them out.
  if (process.platform === "linux" && target === `linux-${process.arch}`) execFileSync("strip", [copy]);
}
execFileSync(process.execPath, ["scripts/build.mjs"], { stdio: "inherit" });
const vsce = path.join("node_modules", "@vscode", "vsce", "vsce");
const args = [vsce, "package", "--no-dependencies", "--allow-missing-repository", "--skip-license", "--out", file];
if (program !== "none") args.push("--target", target);
execFileSync(process.execPath, args, { stdio: ["ignore", "ignore", "inherit"] });
console.log(`${file}: ${(fs.statSync(file).size / 1e6).toFixed(2)} MB`);
