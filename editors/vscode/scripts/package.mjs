// Makes psdl-TARGET.vsix with the program in it.   node scripts/package.mjs [TARGET [PROGRAM [OUT]]]
//   TARGET   of vsce: linux-x64, linux-arm64, alpine-x64, darwin-x64, darwin-arm64, win32-x64, win32-arm64; this machine's, if it is left out
//   PROGRAM  a release build of psdl for it, by default that of `cargo build --release`; `none` makes a package without one, for any platform
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";

const [target = `${process.platform}-${process.arch}`, given, out] = process.argv.slice(2);
const windows = target.startsWith("win32");
const built = path.join(process.env.CARGO_TARGET_DIR ?? path.join("..", "..", "target"), "release", windows ? "psdl.exe" : "psdl");
const program = given ?? built;
if (program !== "none" && !fs.existsSync(program)) throw new Error(`there is no ${program}: build it with cargo build --release, or say where it is (package.mjs TARGET PROGRAM)`);
const file = out ?? `psdl-${target}.vsix`;

fs.rmSync("server", { recursive: true, force: true });
if (program !== "none") {
  const copy = path.join("server", windows ? "psdl.exe" : "psdl");
  fs.mkdirSync("server");
  fs.copyFileSync(program, copy);
  fs.chmodSync(copy, 0o755);
  // Lines of the program are of no use to those who run it. Only a strip for the target can take them out.
  if (process.platform === "linux" && target === `linux-${process.arch}`) execFileSync("strip", [copy]);
}
if (!fs.existsSync("LICENSE.txt")) fs.copyFileSync(path.join("..", "..", "LICENSE-MIT"), "LICENSE.txt");
execFileSync(process.execPath, ["scripts/build.mjs"], { stdio: "inherit" });
const vsce = path.join("node_modules", "@vscode", "vsce", "vsce");
const args = [vsce, "package", "--no-dependencies", "--allow-missing-repository", "--skip-license", "--out", file];
if (program !== "none") args.push("--target", target);
execFileSync(process.execPath, args, { stdio: ["ignore", "ignore", "inherit"] });
console.log(`${file}: ${(fs.statSync(file).size / 1e6).toFixed(2)} MB`);
