// Validates glTF files with the Khronos validator: node gltf_validate.mjs FILE... (npm packages: tests/browser).
// Exit status 1 if any file has an error, a warning or a hint worth a word; each is printed.
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';

const { validateBytes } = createRequire(new URL('../browser/package.json', import.meta.url))('gltf-validator');

let failed = 0;
for (const file of process.argv.slice(2)) {
  const report = await validateBytes(new Uint8Array(await readFile(file)), { uri: file, maxIssues: 20 });
  const { numErrors, numWarnings, numInfos, numHints, messages } = report.issues;
  const info = report.info ?? {};
  console.log(`${file}: ${numErrors} errors, ${numWarnings} warnings, ${numInfos} infos, ${numHints} hints; ` +
    `${info.totalTriangleCount} triangles, ${info.totalVertexCount} vertices, ${info.animationCount} animations`);
  for (const { severity, code, message, pointer } of messages)
    console.log(`  ${['error', 'warning', 'info', 'hint'][severity]} ${code} at ${pointer}: ${message}`);
  if (numErrors + numWarnings + numInfos + numHints > 0) failed++;
}
const checked = process.argv.length - 2;
console.log(`${checked - failed} passed, ${failed} failed`);
process.exit(failed === 0 && checked > 0 ? 0 : 1);
