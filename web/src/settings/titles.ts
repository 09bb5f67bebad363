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

/// The number of a project that a study varies: "material.Scree.roughness_deg@North" in degrees is "Scree: roughness, at
/// North".
export function pathTitle(path: string, unit = ''): string {
  const [setting = '', site] = path.split('@');
  const parts = setting.split('.');
  const [kind = '', key = ''] = [parts[0], parts.at(-1)];
  const name = parts.slice(1, -1).join('.').replaceAll('"', '');
  const title = titleOf(key, unit);
  const of = name === '*' ? `All ${kind}s` : name;
  return `${of ? `${of}: ${title.toLowerCase()}` : title}${site ? `, at ${site}` : ''}`;
}
/// A parameter of a study with its title, and its unit as shown.
export const titled = <Parameter extends { name: string; unit: string }>(parameter: Parameter) => ({
  ...parameter,
  title: pathTitle(parameter.name, parameter.unit),
  unit: unitText(parameter.unit),
});
