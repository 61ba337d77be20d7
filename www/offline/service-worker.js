// Keeps the hosted page for days without a network. The build puts before it what the page is made of: names of files hold the hash of
// what is in them, so a file that any version kept is the right one, and a page goes on with those that it began with.

/**
 * @typedef {Event & { waitUntil(done: Promise<unknown>): void }} Step of its life
 * @typedef {Event & { request: Request, respondWith(answer: Promise<Response>): void }} Asked
 * @typedef {Window & typeof globalThis & {
 *   version: string, registration: { scope: string }, clients: { claim(): Promise<void> }, skipWaiting(): Promise<void>
 * }} Keeper
 */

const worker = /** @type {Keeper} */ (self);

/** The build, then the files. */
const [BUILD, ...FILES] = worker.version.split(" ");
const { scope } = worker.registration;
const PREFIX = `assur ${scope} `;

/** Of a version before: a page of it that is still open may ask for more of its parts. */
const KEPT = 2;

/** Hosts answer differently to those who take packed files, which is all the same here. */
const ANY = Object.freeze({ ignoreVary: true });

addEventListener("install", (event) => {
  const step = /** @type {Step} */ (event);
  step.waitUntil(install());
});

addEventListener("activate", (event) => {
  const step = /** @type {Step} */ (event);
  step.waitUntil(activate());
});

addEventListener("fetch", (event) => {
  const asked = /** @type {Asked} */ (event);
  const { method, url } = asked.request;
  if (method === "GET" && url.startsWith(scope)) asked.respondWith(answer(asked.request));
});

/** All files or none: a version that is not whole never answers. */
async function install() {
  const own = PREFIX + BUILD;
  // One that is there already may be what the page lives on.
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
  // That it was missing once may have been kept as well.
  if (!response.ok) response = await fetch(url, { cache: "reload" });
  if (!response.ok) throw new Error(`${response.status} ${name}`);
  // While a version is being put in its place the page may be of another one.
  if (name === "./" && !(await response.clone().text()).includes(BUILD)) throw new Error(`not of ${BUILD}`);
  // Made anew: a page that was redirected would be refused.
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
