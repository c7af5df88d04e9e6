// What the engines strata-node and strata-chromium share: the package strata-csg, called as `strata eval` is, with exact results.
//
// Exit status: 0 done; 1 any other error; 4 refused, or the package is missing; 6 out of memory.
import { readFileSync, writeFileSync } from "node:fs";
import { extname } from "node:path";

const exitCodes = { InputError: 4, OutOfMemory: 6 };

/** Does what the command line asks. `check` rejects where the engine is missing; `evaluate` is given a request as below, and resolves
 *  to the file of the result, in Base64. Errors are told by their `name`. */
export async function main({ check, evaluate }) {
  const [, , verb, expression, ...rest] = process.argv;
  try {
    if (verb === "--check") return await check();
    if (verb !== "eval") throw new Error(`no verb ${verb}`);
    const options = {}, operands = {};
    for (let i = 0; i < rest.length; ++i) {
      const binding = rest[i].match(/^(\w+)=(.*)$/);
      if (rest[i] === "-q") continue;
      if (binding) operands[binding[1]] = { file: readFileSync(binding[2], "base64"), format: extname(binding[2]).slice(1) };
      else options[rest[i]] = rest[++i];
    }
    const out = options["-o"];
    const request = { expression, operands, input: options["--input"], format: extname(out).slice(1) };
    writeFileSync(out, await evaluate(request), "base64");
  } catch (error) {
    console.error(error.message);
    process.exitCode = verb === "--check" ? 4 : exitCodes[error.name] ?? 1;
  }
}
