// `assur/kinds/index.js`, which the build makes from the folders of `www/kinds` (folders.js).
type Make = import("assur/app/views.js").Make;
export const HERE: ReadonlyMap<string, Make>;
export const LATER: ReadonlyMap<string, () => Promise<{ views: Make, words?: string }>>;
