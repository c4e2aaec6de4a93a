// Validates every .glb named in the arguments. One JSON line a file: its errors and warnings.
const fs = require("fs");
const validator = require("gltf-validator");

(async () => {
  for (const path of process.argv.slice(2)) {
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(path)), { maxIssues: 20 });
    const { numErrors, numWarnings, messages } = report.issues;
    const info = report.info || {};
    console.log(JSON.stringify({ path, errors: numErrors, warnings: numWarnings, messages, triangles: info.totalTriangleCount }));
  }
})();
