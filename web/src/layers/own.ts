// The settings of layers that belong to the browser, as it keeps them: by the layer's name.

export interface OwnSettings {
  visible: boolean;
  opacity: number;
}

export function ownOf(kept: string): Record<string, Partial<OwnSettings>> {
  if (kept === '') return {};
  try {
    return JSON.parse(kept) as Record<string, Partial<OwnSettings>>;
  } catch {
    return {};
  }
}

export function withOwn(kept: string, name: string, change: Partial<OwnSettings>): string {
  const own = ownOf(kept);
  return JSON.stringify({ ...own, [name]: { ...own[name], ...change } });
}
