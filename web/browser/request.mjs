/** Evaluates a request by the package `strata`, in Node or in a page: { expression, operands: { name: { file, format } }, input, format },
 *  with files in Base64; the result is one. */
export async function evaluateRequest(strata, { expression, operands, input, format }) {
  await strata.init();
  const solids = {};
  for (const [name, operand] of Object.entries(operands))
    solids[name] = strata.read(bytesOf(operand.file), operand.format, { input });
  return textOf(strata.write(strata.evaluate(expression, solids), format));
}

const bytesOf = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));

function textOf(bytes) {
  let text = "";
  for (const byte of bytes) text += String.fromCharCode(byte);
  return btoa(text);
}
