// The package strata-csg in Chromium as an engine of `strata verify`; web/browser/suite starts the browser, and tells its address.
import { main } from "./web_package.mjs";

const address = process.env.STRATA_CHROMIUM;

await main({
  check: async () => {
    if (!address) throw new Error("there is no browser: web/browser/suite starts one");
  },
  evaluate: async (request) => {
    const response = await fetch(address, { method: "POST", body: JSON.stringify(request) });
    const { result, error } = await response.json();
    if (error) throw Object.assign(new Error(error.message), { name: error.name });
    return result;
  },
});
