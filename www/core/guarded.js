// Proxy of an object: one function makes all calls of the object's functions, so that it can handle their failures.

/**
 * Makes a proxy of an object. The functions of the proxy are called by `ask`; everything else is undefined, and nothing can be set.
 * @template {object} T
 * @param {() => T} owner returns the object, at each call anew
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
