// Service worker that stores the hosted page for offline use. The build writes a list of the page's files before this
// script. File names contain hashes of the contents, so that an open page keeps the files of its own version.

/**
 * Types of the library `webworker`, as far as they are used here; that library cannot be checked together with `dom`.
 * @typedef {Event & { waitUntil(done: Promise<unknown>): void }} ExtendableEvent
 * @typedef {Event & { request: Request, respondWith(answer: Promise<Response>): void }} FetchEvent
 * @typedef {Window & typeof globalThis & {
 *   version: string, registration: { scope: string }, clients: { claim(): Promise<void> }, skipWaiting(): Promise<void>
 * }} ServiceWorkerGlobalScope `version`: written by the build
 */

const worker = /** @type {ServiceWorkerGlobalScope} */ (self);

/** Hash that identifies the build, then names of the files. */
const [BUILD, ...FILES] = worker.version.split(" ");
const { scope } = worker.registration;
const PREFIX = `assur ${scope} `;

/** Number of versions kept: an open page of the previous version may still request that version's files. */
const KEPT = 2;

/** Option that ignores the header `Vary`, because responses that differ only in compression are the same here. */
const ANY = Object.freeze({ ignoreVary: true });

addEventListener("install", (event) => {
  const extendable = /** @type {ExtendableEvent} */ (event);
  extendable.waitUntil(install());
});

addEventListener("activate", (event) => {
  const extendable = /** @type {ExtendableEvent} */ (event);
  extendable.waitUntil(activate());
});

addEventListener("fetch", (event) => {
  const fetched = /** @type {FetchEvent} */ (event);
  const { method, url } = fetched.request;
  if (method === "GET" && url.startsWith(scope)) fetched.respondWith(answer(fetched.request));
});

/** Stores all files of this version or none: an incomplete version never answers a request. */
async function install() {
  const own = PREFIX + BUILD;
  // An existing store may be in use by an open page, so it is not deleted after a failure.
  const begun = !(await caches.has(own));
  const cache = await caches.open(own);
  try {
    await Promise.all(FILES.map((name) => keep(cache, name)));
  } catch (thrown) {
    if (begun) await caches.delete(own);
    throw thrown;
  }
  await worker.skipWaiting();
}

/**
 * @param {Cache} cache
 * @param {string} name of a file; `./` is the page itself
 */
async function keep(cache, name) {
  const url = new URL(name, scope).href;
  const hashed = name.startsWith("files/");
  const before = hashed ? await caches.match(url, ANY) : undefined;
  let response = before ?? (await fetch(url, { cache: hashed ? "default" : "no-cache" }));
  // The browser's cache may hold an earlier failure.
  if (!response.ok) response = await fetch(url, { cache: "reload" });
  if (!response.ok) throw new Error(`${response.status} ${name}`);
  // During a deployment, the server may send the page of another version.
  if (name === "./" && !(await response.clone().text()).includes(BUILD)) throw new Error(`not of ${BUILD}`);
  // The response is copied, because browsers refuse a stored page that was redirected.
  const { headers, status, statusText } = response;
  await cache.put(url, new Response(response.body, { headers, status, statusText }));
}

async function activate() {
  const versions = (await caches.keys()).filter((name) => name.startsWith(PREFIX));
  await Promise.all(versions.slice(0, -KEPT).map((name) => caches.delete(name)));
  await worker.clients.claim();
}

/**
 * @param {Request} request
 * @returns {Promise<Response>}
 */
async function answer(request) {
  const [address] = request.url.split(/[?#]/);
  const url = address === `${scope}index.html` ? scope : address;
  const cache = await caches.open(PREFIX + BUILD);
  return (await cache.match(url, ANY)) ?? (await caches.match(url, ANY)) ?? fetch(request);
}
