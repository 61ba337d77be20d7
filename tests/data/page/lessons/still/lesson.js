// A lesson about what does not move, with a step that shows the same in motion.

/** @type {import("assur/lesson/folder.js").Lesson<"scheme">} */
export const LESSON = Object.freeze({ kind: "scheme", steps: [
  {
    id: "count",
    formula: "W = 3n − 2p₁",
    shows: [{ preset: "drawn" }],
    question: { within: 0, answer: ({ mobility }) => mobility },
  },
  {
    id: "moved",
    kind: "linkage",
    formula: "W = 3n − 2p₁",
    shows: [{ preset: "watt-1" }],
    question: { within: 0, answer: ({ counts }) => counts.links },
  },
] });
