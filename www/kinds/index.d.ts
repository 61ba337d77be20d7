// The build makes the module of these names from the folders beside it.
type Make = import("assur/app/views.js").Make;
export const HERE: ReadonlyMap<string, Make>;
export const LATER: ReadonlyMap<string, () => Promise<{ views: Make }>>;
