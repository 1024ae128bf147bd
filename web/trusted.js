// The one address of a script that the page makes itself: that of its worker. The content security policy takes it from
// this policy alone, so that no text which is read, opened or sent can become a script.

/** @typedef {{ createPolicy(name: string, rules: { createScriptURL(address: string): string }): { createScriptURL(address: string): string } }} Policies */

/**
 * A worker at an address of the page's own.
 * @param {string} address
 * @param {WorkerOptions} options
 */
export function trustedWorker(address, options) {
  policy ??= policies?.createPolicy('nctape', { createScriptURL: checked }) ?? { createScriptURL: checked };
  own = address;
  return new Worker(policy.createScriptURL(address), options);
}

/** Not to be had in every browser. */
const policies = /** @type {{ trustedTypes?: Policies }} */ (/** @type {unknown} */ (globalThis)).trustedTypes;
/** @type {{ createScriptURL(address: string): string } | null} */
let policy = null;
let own = '';

/** @param {string} address */
function checked(address) {
  if (address !== own) throw new TypeError(`${address} is no script of this page`);
  return address;
}
