// Guarding of an object's functions: one function makes all calls, and handles their failures.

/**
 * Guards the functions of an object.
 * @template {object} T
 * @param {() => T} owner of the functions
 * @param {(call: () => unknown) => unknown} ask makes a call
 * @returns {T} an object with the same functions, each called by `ask`
 */
export function guarded(owner, ask) {
  const of = () => /** @type {Record<string, unknown>} */ (owner());
  const call = (/** @type {string} */ name) => (/** @type {unknown[]} */ ...given) => ask(() => /** @type {any} */ (of())[name](...given));
  return new Proxy(/** @type {T} */ ({}), {
    get: (_, name) => (typeof of()[String(name)] === "function" ? call(String(name)) : undefined),
    set: () => false,
  });
}
