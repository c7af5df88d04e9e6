// What the tests use of node:test, for browsers.
const all = [];

export function test(name, work) {
  all.push({ name, work });
}

/** Runs what was registered, one after the other. */
export async function results() {
  const found = [];
  for (const { name, work } of all)
    try {
      await work();
      found.push({ name });
    } catch (error) {
      found.push({ name, error: String(error?.stack ?? error) });
    }
  return found;
}
