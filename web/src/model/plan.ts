// Places on plan.

/// To a millimetre, or a centimetre where the ground is wide or there is none yet: finer than anyone points.
export function rounded(value: number, extent: number): number {
  const digits = extent > 200 || extent === 0 ? 2 : 3;
  return Number(value.toFixed(digits));
}
