// What settings and their units are called on the page.

/// "Normal restitution" of normal_restitution, "Forest height" of forest_height_m: the key without its unit.
export function titleOf(key: string, unit = ''): string {
  const ending = `_${unit.replace('1/', 'per_').replaceAll('/', '_')}`;
  const bare = unit && key.endsWith(ending) ? key.slice(0, -ending.length) : key;
  return `${bare.charAt(0).toUpperCase()}${bare.slice(1).replaceAll('_', ' ')}`;
}

/// "m/s²" of m/s2, "°" of deg.
export function unitText(unit: string): string {
  return unit
    .replace('deg', '°')
    .replace(/([a-z])2\b/, '$1²')
    .replace(/([a-z])3\b/, '$1³');
}
