// The package strata-csg for JavaScript as an engine of `strata verify`. tools/web builds it.
//
// `strata verify --engine strata-node --memory 0` asks for it: WebAssembly reserves more address space than it uses.
import * as strata from "../../web/package/strata.js";
import { evaluateRequest } from "../../web/browser/request.mjs";
import { main } from "./web_package.mjs";

await main({
  check: () => strata.init().catch((error) => { throw new Error(`${error.message}; tools/web builds it`); }),
  evaluate: (request) => evaluateRequest(strata, request),
});
