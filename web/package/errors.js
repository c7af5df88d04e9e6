// What the engine throws.

/** Of every error that the engine reports. */
export class StrataError extends Error {
  get name() {
    return this.constructor.name;
  }
}

/** A mesh is not what was declared: `defects` has every one, `operand` tells which mesh, from 0. */
export class InputError extends StrataError {}

/** A file does not hold what its format demands; `line` (from 1) or `byte` (from 0), where they are known. */
export class FileError extends StrataError {}

/** A model is no .csg text, or has what is not supported; `line` and `column`, from 1. */
export class ModelError extends StrataError {}

/** An expression does not follow the grammar; `position` is in bytes, from 0. */
export class ExpressionError extends StrataError {}

/** An argument means nothing. */
export class ArgumentError extends StrataError {}

/** A fault of the engine itself. */
export class EngineFault extends StrataError {}

/** The 4 GB that WebAssembly addresses, or those that the browser grants, are not enough. */
export class OutOfMemory extends StrataError {}

const kinds = {
  input: InputError,
  file: FileError,
  model: ModelError,
  expression: ExpressionError,
  argument: ArgumentError,
  fault: EngineFault,
  memory: OutOfMemory,
};

/** The error that a record of the engine, or of a worker, stands for. */
export function errorOf({ kind, message, ...fields }) {
  return Object.assign(new (kinds[kind] ?? StrataError)(message), fields);
}

/** The record of an error, which a worker can send. */
export function recordOf(error) {
  const kind = Object.keys(kinds).find((k) => kinds[k] === error.constructor);
  return { ...error, kind, message: error.message };
}
