// Which rocks are drawn as blocks.

/// As many as the server gives at once, and as a view draws smoothly.
export const mostBlocks = 1000;

/// The numbers of the rocks to draw as blocks: those that pass the filter (null: all), evenly chosen if they are many,
/// and the selected one.
export function blockRocks(rocks: ArrayLike<number>, passes: Uint8Array | null, chosen: number | null, most = mostBlocks): number[] {
  let all = Array.from(rocks);
  if (all.length > most && passes) all = all.filter((_, k) => passes[k]);
  const count = Math.min(most, all.length);
  const list = Array.from({ length: count }, (_, k) => all[Math.floor((k * all.length) / count)]!);
  if (chosen === null || list.includes(chosen)) return list;
  return [...list.slice(0, most - 1), chosen].toSorted((a, b) => a - b);
}
