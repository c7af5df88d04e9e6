// The workbench: files become operands a, b, c, ...; an expression about them is evaluated exactly; the result is shown and saved.
import { Engine, Stopped } from "./engine_client.js";
import { markSize, marks, mixed, palette, pictureOf } from "./picture.js";

const element = (name) => document.getElementById(name);
const embedded = (name) => element(name).textContent;

function made(kind, text, properties) {
  return Object.assign(document.createElement(kind), text === undefined ? {} : { textContent: text }, properties);
}

const resultColor = [205, 210, 220], defectColor = [230, 30, 40], contactColor = [214, 90, 40];
const firstLayer = [44, 74, 124], lastLayer = [243, 210, 122];
const readable = ["stl", "obj", "off", "xoff", "ply", "3mf", "glb", "gltf", "amf", "vtk", "csg"];
const inputs = ["automatic", "overlapping", "repair", "soup"];

/** A file: {name, file, format, data, input, shown, isShown}; `shown` is what the engine answered, and `error` what it threw. */
const operands = [];
const result = { shown: null, expression: "", isShown: true };
/** What is shown: "solids", or "pieces", "layers" or "contacts" in their place, as parts with titles and colours. */
const view = { kind: "solids", parts: [] };

let engine = null;
let viewer = null;

// ---- the engine ----------------------------------------------------------------------------------------------------

async function unpacked(text) {
  const packed = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
  return new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
}

/** Runs one piece of work: says what it is, how far it is and how it ended, and offers to stop it. */
async function during(what, work) {
  say(what + " …");
  element("stop").hidden = false;
  element("evaluate").disabled = true;
  try {
    const seconds = await work((fraction) => say(`${what} … ${Math.round(100 * fraction)} %`));
    say(seconds === undefined ? "" : `${what}: ${seconds < 1 ? Math.round(1000 * seconds) + " ms" : seconds.toFixed(2) + " s"}`);
  } catch (error) {
    if (error instanceof Stopped) say(what + " was stopped.");
    else complain(error);
  } finally {
    element("stop").hidden = true;
    element("evaluate").disabled = false;
  }
}

/** Ends what the engine does, and starts another one that knows the same operands. */
async function stop() {
  engine.stop();
  result.shown = null;
  showSolids();
  await engine.start();
  for (const operand of operands) if (operand.shown) await add(operand);
  show();
}

const say = (text) => (element("status").textContent = text);

function complain(error) {
  element("status").replaceChildren(made("strong", error.message));
}

// ---- operands ------------------------------------------------------------------------------------------------------

/** The first letter that no operand has. */
function freeName() {
  const letters = [..."abcdefghijklmnopqrstuvwxyz"];
  return letters.find((letter) => operands.every((operand) => operand.name !== letter));
}

async function add(operand, onProgress) {
  const { name, format, data, input } = operand;
  operand.shown = operand.error = null;
  try {
    operand.shown = await engine.ask("add", { name, format, data, input }, onProgress);
  } catch (error) {
    if (error instanceof Stopped) throw error;
    operand.error = error.message;
  }
}

async function addFile(file, data, { name = freeName(), input = "automatic" } = {}) {
  const format = file.toLowerCase().match(/\.([a-z0-9]+)$/)?.[1] ?? "";
  if (name === undefined) return complain(new Error("there are 26 operands at most"));
  if (!readable.includes(format)) return complain(new Error(`${file} is none of ${readable.join(", ")}`));
  const operand = { name, file, format, data, input, isShown: true };
  operands.push(operand);
  await during(`reading ${file}`, (onProgress) => add(operand, onProgress));
  if (operands.length > 1 && element("expression").value === "") element("expression").value = "a - b";
  showSolids();
  show();
}

async function addFiles(files) {
  for (const file of files) await addFile(file.name, await file.arrayBuffer());
}

async function remove(operand) {
  operands.splice(operands.indexOf(operand), 1);
  await engine.ask("remove", { name: operand.name });
  showSolids();
  show();
}

// ---- the result ----------------------------------------------------------------------------------------------------

async function evaluate() {
  const expression = element("expression").value;
  await during(expression, async (onProgress) => {
    const answer = await engine.ask("evaluate", { expression }, onProgress);
    Object.assign(result, { shown: answer, expression, isShown: true });
    showSolids();
    for (const operand of operands) operand.isShown = false;
    show();
    return answer.seconds;
  });
}

async function save() {
  const format = element("format").value;
  await during(`writing ${format}`, async () => {
    const bytes = await engine.ask("save", { format });
    const link = made("a", undefined, { href: URL.createObjectURL(new Blob([bytes])), download: `result.${format}` });
    link.click();
    URL.revokeObjectURL(link.href);
  });
}

// ---- other views of solids -----------------------------------------------------------------------------------------

/** The names of all solids that are shown, and what they are called; the result has none. */
function shownSolids() {
  const all = operands.filter((operand) => operand.isShown && operand.shown && !operand.shown.defects).map(({ name }) => name);
  return result.shown && result.isShown ? [...all, ""] : all;
}

/** Three numbers, or nothing where the field is empty. */
function chosenOrigin() {
  const text = element("origin").value.trim();
  if (text === "") return undefined;
  const numbers = text.split(/[\s,]+/).map(Number);
  if (numbers.length !== 3 || numbers.some(Number.isNaN)) throw new Error("an origin is x, y, z");
  return numbers;
}

const views = {
  solids: async () => [],

  async pieces() {
    if (!result.shown) throw new Error("there is no result yet");
    const pieces = await engine.ask("pieces");
    return pieces.map((piece, n) => ({ ...piece, title: `piece ${n + 1}`, color: palette[n % palette.length] }));
  },

  async layers(onProgress) {
    const layers = await engine.ask("layers", { names: shownSolids(), origin: chosenOrigin() }, onProgress);
    return layers.map((layer, n) =>
      ({ ...layer, title: `layer ${n + 1}`, color: mixed(firstLayer, lastLayer, n / Math.max(1, layers.length - 1)) }));
  },

  async contacts(onProgress) {
    const names = operands.filter((operand) => operand.shown && !operand.shown.defects).map(({ name }) => name);
    const found = await engine.ask("contacts", { names }, onProgress);
    return found.map(({ a, b, ...contact }) => ({
      ...contact, title: `${names[a]} and ${names[b]}: ${contact.relation === "contact" ? "in contact" : "they interfere"}`, color: contactColor, isMark: true,
    }));
  },
};

function showSolids() {
  Object.assign(view, { kind: "solids", parts: [] });
  element("view").value = "solids";
}

async function chooseView() {
  const kind = element("view").value;
  element("origins").hidden = kind !== "layers";
  let parts = null;
  await during(kind, async (onProgress) => void (parts = await views[kind](onProgress)));
  if (parts === null) showSolids();
  else Object.assign(view, { kind, parts: parts.map((part) => ({ ...part, source: { isShown: true } })) });
  if (kind === "contacts") for (const operand of operands) operand.isShown = false;
  element("slider").max = kind === "layers" ? Math.max(1, view.parts.length) : 100;
  element("slider").value = kind === "layers" ? view.parts.length : 0;
  show();
  element("slider").dispatchEvent(new Event("input"));
}

// ---- what is shown -------------------------------------------------------------------------------------------------

const number = (x) => String(Number(x.toPrecision(8)));

/** Exact volumes of many digits are cut short; the whole is in the title. */
function exact(text) {
  const most = 48;
  return made("span", text.length <= most ? text : `${text.slice(0, most)}… (${text.length} characters)`, { title: text });
}

function factsOf({ triangles, volume, exactVolume, area, seconds }) {
  const facts = [["triangles", String(triangles.length / 3)]];
  if (exactVolume === undefined) return area === undefined ? facts : [["area", number(area)]];
  facts.push(["volume", number(volume)], ["exactly", exact(exactVolume)], ["area", number(area)]);
  if (seconds !== undefined) facts.push(["time", `${Math.round(1000 * seconds)} ms`]);
  return facts;
}

function listOf(facts) {
  const list = made("dl");
  for (const [name, value] of facts) {
    const content = made("dd");
    content.append(value);
    list.append(made("dt", name), content);
  }
  return list;
}

/** The parts of the picture, in the order of the list. */
function allParts() {
  if (view.kind === "layers") return view.parts;
  const parts = operands.map((operand, n) => ({
    title: `${operand.name}: ${operand.file}`, color: palette[n % palette.length], source: operand, operand, ...operand.shown,
  }));
  if (result.shown && view.kind === "solids")
    parts.push({ title: result.expression, color: resultColor, source: result, ...result.shown });
  return [...parts, ...view.parts];
}

function defectMarks(parts) {
  const places = parts.flatMap((part) => (part.operand?.isShown && part.defects) || []).map((defect) => defect.where).filter(Boolean);
  if (places.length === 0) return [];
  const size = Math.max(...parts.filter((part) => part.defects).map((part) => markSize(part.vertices)));
  return [{ ...marks(places.slice(0, 1000), size), title: "defects", color: defectColor, isMark: true, source: { isShown: true } }];
}

function defectsOf({ defects }, operand) {
  const box = made("div", undefined, { className: "defects" });
  box.append(made("p", `No solid: ${defects.length} kinds or places of defects, marked in red.`));
  const list = made("ul");
  for (const { message, remedy } of defects.slice(0, 5)) list.append(made("li", remedy ? `${message} (${remedy})` : message));
  const choice = made("select", undefined, { ariaLabel: `what ${operand.file} is taken as` });
  for (const input of inputs) choice.append(made("option", input, { selected: input === operand.input }));
  choice.addEventListener("change", async () => {
    operand.input = choice.value;
    await during(`reading ${operand.file}`, (onProgress) => add(operand, onProgress));
    show();
  });
  const label = made("label", "take it as ");
  label.append(choice);
  box.append(list, label);
  return box;
}

function itemOf(part, n) {
  const item = made("li"), label = made("label");
  const box = made("input", undefined, { type: "checkbox", id: `part-${n}`, checked: part.source.isShown !== false });
  box.addEventListener("change", () => (part.source.isShown = box.checked));
  label.append(box, made("span", undefined, { className: "swatch", style: `background: rgb(${part.color})` }), made("span", part.title));
  item.append(label);
  if (part.operand) {
    const button = made("button", "remove", { type: "button", ariaLabel: `remove ${part.title}` });
    button.addEventListener("click", () => remove(part.operand));
    label.append(button);
  }
  if (part.operand?.error) item.append(made("p", part.operand.error, { className: "defects" }));
  if (part.triangles) item.append(listOf(factsOf(part)));
  if (part.defects) item.append(defectsOf(part, part.operand));
  return item;
}

function show() {
  const listed = allParts(), parts = [...listed, ...defectMarks(listed)];
  const nothing = { vertices: new Float64Array(), triangles: new Uint32Array(), edges: { vertices: new Float64Array(), edges: new Uint32Array() } };
  element("list").replaceChildren(...(view.kind === "layers" ? [made("li", `${parts.length} layers, from back to front`)] : parts.map(itemOf)));
  element("empty").hidden = operands.length > 0;
  element("saving").hidden = result.shown === null;
  element("sliding").hidden = view.kind !== "pieces" && view.kind !== "layers";
  element("stage").ariaLabel = parts.map((part) => part.title).join("; ") + ". Arrow keys turn.";
  const slider = { pieces: "explode", layers: "layers" }[view.kind] ?? "one";
  const picture = pictureOf(parts.map((part) => ({ ...nothing, ...part })), slider);
  if (viewer === null) viewer = strataViewer(picture);
  else viewer.show(picture);
}

// ---- links ---------------------------------------------------------------------------------------------------------

/** What a link asks behind its #: files and their texts, an expression about their names, what they are taken as. For instance
 *  `#expression=a-b&input=soup&a.off=...&b.off=...`; `strata verify --workbench` writes such links. */
async function follow(fragment) {
  const asked = new URLSearchParams(fragment.slice(1));
  const input = inputs.find((one) => one === asked.get("input"));
  for (const [file, text] of asked) {
    const name = file.match(/^([A-Za-z_]\w*)\.\w+$/)?.[1];
    if (name && operands.every((operand) => operand.name !== name)) await addFile(file, new TextEncoder().encode(text), { name, input });
  }
  if (!asked.has("expression")) return;
  element("expression").value = asked.get("expression");
  await evaluate();
}

// ---- the page ------------------------------------------------------------------------------------------------------

function listen() {
  element("files").addEventListener("change", async () => {
    await addFiles(element("files").files);
    element("files").value = "";
  });
  element("examples").addEventListener("click", async () => {
    for (const { file, text } of JSON.parse(embedded("example-files"))) await addFile(file, new TextEncoder().encode(text));
    element("expression").value = "a - b";
    await evaluate();
  });
  element("question").addEventListener("submit", (event) => {
    event.preventDefault();
    evaluate();
  });
  element("stop").addEventListener("click", stop);
  element("view").addEventListener("change", chooseView);
  element("origin").addEventListener("change", chooseView);
  element("save").addEventListener("click", save);
  const page = document.documentElement;
  page.addEventListener("dragover", (event) => {
    event.preventDefault();
    document.body.classList.add("dragging");
  });
  page.addEventListener("dragleave", () => document.body.classList.remove("dragging"));
  page.addEventListener("drop", (event) => {
    event.preventDefault();
    document.body.classList.remove("dragging");
    addFiles(event.dataTransfer.files);
  });
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target.matches("input, select")) return;
    element(`part-${Number(event.key) - 1}`)?.click();
  });
}

async function begin() {
  if (typeof DecompressionStream === "undefined" || typeof WebAssembly === "undefined")
    return complain(new Error("This browser is too old: it needs WebAssembly with exceptions, and DecompressionStream."));
  show();
  listen();
  await during("starting", async () => {
    engine = new Engine(embedded("engine"), await unpacked(embedded("module")));
    await engine.start();
  });
  addEventListener("hashchange", () => location.reload());
  await follow(location.hash);
}

begin();
