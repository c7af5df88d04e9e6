// What the tests use of node:assert, for browsers.
function fail(message) {
  throw new Error(message);
}

// BigInt is no JSON, and typed arrays are objects there.
const text = (value) => JSON.stringify(value, (_, v) => (typeof v === "bigint" ? `${v}n` : ArrayBuffer.isView(v) ? [...v] : v));

const isClass = (value) => typeof value === "function" && (value === Error || value.prototype instanceof Error);

/** Is it the error that is expected: a class, a pattern, properties, or what a function finds right? */
function check(error, expected) {
  const isRight = expected === undefined || (isClass(expected) ? error instanceof expected
    : expected instanceof RegExp ? expected.test(String(error))
    : typeof expected === "function" ? expected(error) === true
    : Object.entries(expected).every(([name, value]) => error[name] === value));
  if (!isRight) fail(`${error} is another error`);
}

export default {
  ok: (value, message) => value || fail(message ?? "not true"),
  equal: (a, b) => Object.is(a, b) || fail(`${text(a)} is not ${text(b)}`),
  deepEqual: (a, b) => text(a) === text(b) || fail(`${text(a)} is not ${text(b)}`),
  match: (value, pattern) => pattern.test(value) || fail(`${value} does not match ${pattern}`),
  throws(work, expected) {
    try {
      work();
    } catch (error) {
      return check(error, expected);
    }
    fail("nothing was thrown");
  },
  async rejects(promise, expected) {
    try {
      await promise;
    } catch (error) {
      return check(error, expected);
    }
    fail("nothing was thrown");
  },
};
