// The package strata-csg for JavaScript as an engine of `strata verify`, called as `strata eval` is; results are exact.
//
// `strata verify --engine strata-node --memory 0` asks for it: WebAssembly reserves more address space than it uses. tools/web builds it.
// Exit status: 0 done; 4 refused; 6 out of memory.
import { readFileSync, writeFileSync } from "node:fs";
import { extname } from "node:path";
import * as strata from "../../web/package/strata.js";

if (process.argv[2] === "--check") {
  await strata.init().catch((error) => {
    console.error(`${error.message}; tools/web builds it`);
    process.exitCode = 4;
  });
  process.exit();
}
const [, , verb, expression, ...rest] = process.argv;
if (verb !== "eval") throw new Error(`no verb ${verb}`);
const options = {}, operands = {};
for (let i = 0; i < rest.length; ++i) {
  const binding = rest[i].match(/^(\w+)=(.*)$/);
  if (rest[i] === "-q") continue;
  if (binding) operands[binding[1]] = binding[2];
  else options[rest[i]] = rest[++i];
}

await strata.init();
try {
  const solids = {};
  for (const [name, path] of Object.entries(operands))
    solids[name] = strata.read(readFileSync(path), extname(path).slice(1), { input: options["--input"] });
  writeFileSync(options["-o"], strata.write(strata.evaluate(expression, solids), extname(options["-o"]).slice(1)));
} catch (error) {
  console.error(error.message);
  process.exitCode = error instanceof strata.InputError ? 4 : error instanceof strata.OutOfMemory ? 6 : 1;
}
