// Values as TOML text.

export type TomlValue = string | number | bigint | boolean | TomlValue[] | TomlTable;
export interface TomlTable {
  [key: string]: TomlValue;
}

const longestLine = 110;

export function keyText(key: string): string {
  return /^[A-Za-z0-9_-]+$/.test(key) ? key : stringText(key);
}

export function stringText(text: string): string {
  // TOML's basic strings have the escapes of JSON; TOML also requires DEL to be escaped.
  return JSON.stringify(text).replaceAll('\u007f', '\\u007f');
}

function numberText(value: number): string {
  if (Number.isNaN(value)) return 'nan';
  if (!Number.isFinite(value)) return value > 0 ? 'inf' : '-inf';
  if (Number.isInteger(value) && Math.abs(value) < 1e15) return Object.is(value, -0) ? '0' : value.toFixed(0);
  return String(value);
}

/// The value on one line; long lists of lists have one row per line.
export function inlineText(value: TomlValue): string {
  if (typeof value === 'string') return stringText(value);
  if (typeof value === 'number') return numberText(value);
  if (typeof value === 'bigint' || typeof value === 'boolean') return String(value);
  if (Array.isArray(value)) {
    const parts = value.map(inlineText);
    const line = `[${parts.join(', ')}]`;
    if (line.length <= longestLine || !value.some((part) => Array.isArray(part))) return line;
    return `[\n${parts.map((part) => `  ${part},\n`).join('')}]`;
  }
  const parts = Object.entries(value).map(([key, part]) => pairText(key, part));
  return parts.length > 0 ? `{ ${parts.join(', ')} }` : '{}';
}

export function pairText(key: string, value: TomlValue): string {
  return `${keyText(key)} = ${inlineText(value)}`;
}

/// A table of an array of tables, with its header.
export function tableText(path: readonly string[], value: TomlTable): string {
  const pairs = Object.entries(value).map(([key, part]) => pairText(key, part));
  return [`[[${path.map(keyText).join('.')}]]`, ...pairs].join('\n');
}
