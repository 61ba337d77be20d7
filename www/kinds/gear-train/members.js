// Tools on the satellite (7) and on the carrier (8), such as stirrers or fans: kinds, uses in the paper, torques.
import { NumberRow } from "assur/controls/number-row.js";
import { section } from "assur/controls/section.js";
import { make, write } from "assur/core/dom.js";
import { Seen } from "assur/core/seen.js";
import { Choice } from "assur/kinds/gear-train/choice.js";
import { edited } from "assur/state/state.js";

/** @typedef {NonNullable<NonNullable<import("assur/kinds/gear-train/drives.js").Document["members"]>["carrier"]>} Member */

const KINDS = Object.freeze(["none", "fan", "brush", "stirrer", "scraper", "blade", "propeller", "road_wheel"]);

/** For each tool, the symbol of its torque and the role of its colour. */
const LINKS = Object.freeze({ satellite: Object.freeze({ symbol: "T₇", role: "coupler" }), carrier: Object.freeze({ symbol: "T₈", role: "rocker" }) });

export class MembersView {
  #rows;
  #shown = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor({ store, drafts }) {
    const put = (/** @type {"satellite" | "carrier"} */ link, /** @type {(member: Member | null) => Member | null} */ change) =>
      store.update((state) => edited(state, "gear-train", ({ members }) => ({ members: { ...members, [link]: change(members?.[link] ?? null) } })));
    this.#rows = /** @type {("satellite" | "carrier")[]} */ (Object.keys(LINKS)).map((link) => {
      const choice = new Choice(`members.${link}`, KINDS, (kind) => `member.${kind}`, (kind) => put(link, (member) => (
        kind === "none" ? null : { kind: /** @type {Member["kind"]} */ (kind), torque: member?.torque ?? 0 })));
      const field = `members.${link}.torque`;
      const row = new NumberRow({ field, id: `torque-${link}`, ...LINKS[link] }, drafts, (torque) => put(link, (member) => member && { ...member, torque }));
      return { link, choice, row, use: make("p", { class: "note member-use" }) };
    });
    section("gear-train", "members.heading", "members", [
      ...this.#rows.flatMap(({ choice, use, row }) => [choice.element, use, row.element]),
      make("p", { class: "note", "data-t": "members.claims" }),
    ]);
  }

  /** @param {import("assur/kinds/gear-train/drives.js").Snapshot} snapshot */
  render({ state: { document }, words, problems }) {
    const wrong = new Set(problems.map(({ field }) => field));
    if (this.#shown.same(document.members, words, ...wrong)) return;
    for (const { link, choice, use, row } of this.#rows) {
      const member = document.members?.[link];
      choice.show(member?.kind ?? "none");
      row.element.hidden = use.hidden = !member;
      if (member) write(use, words.text("members.use", { use: words.text(`use.${member.kind}`) }));
      if (member) row.show(member.torque ?? 0, words, wrong.has(row.field));
    }
  }
}
