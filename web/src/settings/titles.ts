// Titles of settings and their units.

/// The key without its unit: "Forest height" for forest_height_m.
export function titleOf(key: string, unit = ''): string {
  const ending = `_${unit.replace('1/', 'per_').replaceAll('/', '_')}`;
  const bare = unit && key.endsWith(ending) ? key.slice(0, -ending.length) : key;
  return `${bare.charAt(0).toUpperCase()}${bare.slice(1).replaceAll('_', ' ')}`;
}

/// "m/s²" for m/s2, "°" for deg.
export function unitText(unit: string): string {
  return unit
    .replace('deg', '°')
    .replace(/([a-z])2\b/, '$1²')
    .replace(/([a-z])3\b/, '$1³');
}
