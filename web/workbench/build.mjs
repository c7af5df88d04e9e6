// Makes the workbench: one page with everything inside. Usage: node build.mjs ESBUILD OUT.html
// ESBUILD is the folder of the package esbuild. web/package/strata.wasm must have been built.
import { readFile, writeFile } from "node:fs/promises";
import { pathToFileURL } from "node:url";
import { gzipSync } from "node:zlib";

const [folder, out] = process.argv.slice(2);
const { build } = await import(pathToFileURL(folder + "/lib/main.js"));
const here = (path) => new URL(path, import.meta.url);
const text = (path) => readFile(here(path), "utf8");

async function bundled(path) {
  const { outputFiles } = await build({
    entryPoints: [here(path).pathname], bundle: true, write: false, format: "iife", minify: true, target: "es2022", charset: "ascii",
    external: ["node:fs/promises"], define: { "import.meta.url": "''" },
  });
  return outputFiles[0].text;
}

/** A program that may stand in a page. */
const inert = (program) => program.replaceAll("</script", "<\\/script");

const style = (await text("../viewer/page.html")).match(/<style>\n([^]*?)<\/style>/)[1];
const examples = [];
for (const file of ["bracket.off", "drill.off"]) examples.push({ file, text: await text("../../data/" + file) });
const inside = {
  STYLE: style.trimEnd(),
  EXAMPLES: JSON.stringify(examples),
  ENGINE: inert(await bundled("engine.js")),
  MODULE: gzipSync(await readFile(here("../package/strata.wasm")), { level: 9 }).toString("base64"),
  SCRIPT: inert(await text("../../python/strata_csg/_viewer.js")) + inert(await bundled("workbench.js")),
};
const page = (await text("index.html")).replace(/@([A-Z]+)@/g, (_, name) => inside[name]);
await writeFile(out, page);
