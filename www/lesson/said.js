// Texts of a lesson's panel: progress through the lesson, and the verdict on an answer with its reason.

/** @typedef {import("assur/core/words.js").Words} Words */

/**
 * @param {number | null} number of the step, from 1; null at the end of the lesson
 * @param {number} steps
 * @param {import("assur/lesson/progress.js").Progress} progress
 * @param {Words} words
 */
export function progressSaid(number, steps, { solved, shown }, words) {
  const { numbers } = words;
  const progress = number === null ? words.text("lesson.end") : words.text("lesson.progress", { number: numbers.exact(number), count: numbers.exact(steps) });
  const done = solved > 0 ? `, ${words.counted("lesson.solved", solved)}` : "";
  const given = shown > 0 ? `, ${words.text("lesson.shown", { count: numbers.exact(shown) })}` : "";
  return progress + done + given;
}

/**
 * @param {import("assur/lesson/panel.js").Question | null} question
 * @param {import("assur/lesson/panel.js").Judged} judged
 * @param {import("assur/state/model.js").AnySnapshot | null} snapshot
 * @param {Words} words
 */
export function verdictSaid(question, { verdict, brought }, snapshot, words) {
  const back = brought ? [words.text("lesson.brought_back")] : [];
  if (!question || !snapshot) return back.join(" ");
  const said = verdict === "shown" ? words.text("lesson.answer", { answer: question.answer(snapshot) ?? "" }) : words.text(`lesson.${verdict}`);
  const reason = verdict === "not_yet" ? question.hint() : verdict === "right" || verdict === "shown" ? question.right(snapshot) : "";
  return [...back, said, reason].join(" ");
}
