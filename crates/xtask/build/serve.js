// A server of one folder, for this machine only. `cargo xtask serve` runs it, and so do the tests of the page, which
// control it by lines on its standard input:
//
//   serve FOLDER   serve another folder from now on
//   down, up       stop answering requests; answer them again
//
// The first line of output is the address; then each line of input is repeated after it is carried out. The server ends
// when its input ends, so that it does not outlive the program that started it.
import { existsSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import path from "node:path";
import { createInterface } from "node:readline";
import { parseArgs } from "node:util";
import sirv from "sirv";

/** Number of further ports that are tried if the wanted port is taken. */
const PORTS = 100;

const { positionals, values } = parseArgs({
  allowPositionals: true,
  options: { port: { type: "string", default: "0" }, below: { type: "string", default: "/" } },
});
const { below } = values;
const wished = Number(values.port);

let down = false;
let answer = folder(positionals[0]);

/**
 * @param {string} root
 * @returns {ReturnType<typeof sirv>} function that answers requests with the files of the folder, compressed if the
 * browser accepts that, and with the headers in its file `_headers`. Without that file, the headers forbid browsers to
 * store anything
 */
function folder(root) {
  const rules = path.join(root, "_headers");
  const asked = existsSync(rules) ? parseHeaders(readFileSync(rules, "utf8")) : [];
  return sirv(root, {
    dev: true,
    extensions: ["html"],
    brotli: true,
    gzip: true,
    setHeaders: (response, pathname) => {
      for (const { prefix, name, value } of asked) {
        if (!pathname.startsWith(prefix)) continue;
        if (value === null) response.removeHeader(name);
        else response.setHeader(name, value);
      }
    },
  });
}

/**
 * @param {string} text lines of paths, each followed by lines `  NAME: VALUE`, or `  ! NAME` to remove a header
 * @returns {{ prefix: string, name: string, value: string | null }[]}
 */
function parseHeaders(text) {
  let prefix = "";
  const rules = [];
  for (const line of text.split("\n")) {
    const [, removed] = /^\s+! (.*)$/.exec(line) ?? [];
    const [, name, value] = /^\s+([\w-]+): (.*)$/.exec(line) ?? [];
    if (line.startsWith("/")) prefix = line.replace(/\*$/, "");
    else if (removed) rules.push({ prefix, name: removed, value: null });
    else if (name) rules.push({ prefix, name, value });
  }
  return rules;
}

const server = createServer((request, response) => {
  const { method = "", url = "", socket } = request;
  const say = (/** @type {number} */ status, /** @type {string} */ words) => {
    response.writeHead(status, { "Content-Type": "text/plain", "Cache-Control": "no-store", Allow: "GET, HEAD" }).end(`${words}\n`);
  };
  if (down) return void socket.destroy();
  if (!["GET", "HEAD"].includes(method)) return say(405, "only GET and HEAD are answered");
  if (!url.startsWith(below)) return say(404, "not found");
  request.url = `/${url.slice(below.length)}`;
  answer(request, response, () => say(404, "not found"));
});

/** @param {number} port */
function listen(port) {
  server.once("error", () => {
    if (port > 0 && port < wished + PORTS) return listen(port + 1);
    console.error(`error: no port from ${wished} to ${wished + PORTS} is free, choose one by --port`);
    process.exit(1);
  });
  server.listen(port, "127.0.0.1");
}

server.once("listening", () => {
  const address = server.address();
  console.log(`http://127.0.0.1:${typeof address === "object" ? address?.port : ""}${below}`);
});
listen(wished);

const lines = createInterface({ input: process.stdin });
lines.on("line", (line) => {
  const [, word, root] = /^(\w+) ?(.*)$/.exec(line) ?? [];
  if (word === "serve") answer = folder(root);
  else down = word === "down";
  console.log(line);
});
lines.on("close", () => process.exit(0));
