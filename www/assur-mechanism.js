// <assur-mechanism src="…">: a frame with the page, for slides and learning platforms (docs/embedding.md). This
// separate script runs in pages of other sites. It relies on nothing in those pages, and never inserts the element's
// attributes as markup.
(() => {
  /** Attributes of the element, each with the parameter that it sets in the address of the page. */
  const PARAMETERS = Object.freeze({ show: "embed", lesson: "lesson", step: "step", edit: "edit", bar: "bar", play: "play", lang: "lang" });

  /** `own`: address of this script. A `src` that begins with # refers to the page in the script's folder. */
  const script = document.currentScript;
  const own = script instanceof HTMLScriptElement ? script.src : location.href;

  /** Allowed protocols of `src`. An address such as `javascript:…` would run in the surrounding page. */
  const PROTOCOLS = Object.freeze(["https:", "http:", "file:"]);

  class AssurMechanism extends HTMLElement {
    static observedAttributes = ["src", "title", ...Object.keys(PARAMETERS)];

    #frame = document.createElement("iframe");

    constructor() {
      super();
      const frame = this.#frame;
      // The frame may run scripts, store data and offer downloads, but not redirect the surrounding page, open
      // windows or send forms. It keeps its origin, to load its own files even from a host without CORS headers.
      frame.setAttribute("sandbox", "allow-scripts allow-same-origin allow-downloads");
      frame.referrerPolicy = "no-referrer";
      frame.loading = "lazy";
      Object.assign(frame.style, { display: "block", width: "100%", height: "100%", border: "0", borderRadius: "inherit" });
      const sheet = new CSSStyleSheet();
      sheet.replaceSync(":host { display: block; width: 100%; aspect-ratio: 16 / 10; overflow: hidden; } :host([hidden]) { display: none; }");
      const shadow = this.attachShadow({ mode: "open" });
      shadow.adoptedStyleSheets = [sheet];
      shadow.append(frame);
    }

    connectedCallback() {
      this.#show();
    }

    attributeChangedCallback() {
      if (this.isConnected) this.#show();
    }

    #show() {
      const frame = this.#frame;
      frame.title = this.getAttribute("title") || "Assur";
      const url = this.#address();
      if (url === null) {
        frame.removeAttribute("src");
        this.dispatchEvent(new Event("error"));
      } else if (frame.src !== url.href) {
        frame.src = url.href;
      }
    }

    /** @returns {URL | null} address of the page with its parameters; null if invalid */
    #address() {
      const given = this.getAttribute("src") ?? "#";
      const base = given.startsWith("#") ? new URL(".", own).href : document.baseURI;
      if (!URL.canParse(given, base)) return null;
      const url = new URL(given, base);
      if (!PROTOCOLS.includes(url.protocol)) return null;
      for (const [name, parameter] of Object.entries(PARAMETERS)) {
        const value = this.getAttribute(name);
        if (value !== null) url.searchParams.set(parameter, value);
      }
      if (!url.searchParams.has("embed")) url.searchParams.set("embed", "stage");
      return url;
    }
  }

  if (!customElements.get("assur-mechanism")) customElements.define("assur-mechanism", AssurMechanism);
})();
