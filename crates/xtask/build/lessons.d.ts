// `assur/lessons/index.js`, which the build makes from the folders of `www/lessons` (folders.js).
type Lesson = import("assur/lesson/offer.js").Entry;
type Steps = readonly import("assur/lesson/folder.js").Step[];
export const LESSONS: readonly Lesson[];
export const SCRIPTS: Readonly<Record<string, () => Promise<{ LESSON: { kind: import("assur/state/state.js").Kind; steps: Steps } }>>>;
