// Keys of settings in words: "normal_velocity_cutoff_m_s" is shown as "Normal velocity cutoff", in m/s.

// Units by the ending of a setting's name, the longer endings first.
const unitsByEnding = [
  ['_m_s2', 'm/s²'],
  ['_kg_m3', 'kg/m³'],
  ['_kg_s', 'kg/s'],
  ['_deg_s', '°/s'],
  ['_rad_s', 'rad/s'],
  ['_m_s', 'm/s'],
  ['_per_s', '1/s'],
  ['_kJ', 'kJ'],
  ['_J', 'J'],
  ['_kg', 'kg'],
  ['_m3', 'm³'],
  ['_deg', '°'],
  ['_s', 's'],
  ['_m', 'm'],
] as const;
const endingOf = (key: string) => unitsByEnding.find(([ending]) => key.endsWith(ending));

export const unitOf = (key: string) => endingOf(key)?.[1] ?? '';

export function wordsOf(key: string): string {
  const ending = endingOf(key)?.[0] ?? '';
  const words = key.slice(0, key.length - ending.length).replace(/_/g, ' ');
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/// The number of a project that a study varies: "material.Scree.roughness_deg@North" is "Roughness, Scree, at North".
export function pathWords(path: string): string {
  const [setting = '', site] = path.split('@');
  const parts = setting.split('.');
  const [kind, key] = [parts[0] ?? '', parts.at(-1) ?? ''];
  const name = parts.slice(1, -1).join('.').replaceAll('"', '');
  const of = name === '*' ? `all ${kind}s` : name;
  return [wordsOf(key), of, site && `at ${site}`].filter(Boolean).join(', ');
}
