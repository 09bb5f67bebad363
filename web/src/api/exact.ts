// JSON with numbers kept as text, so that the page shows the digits of the files.

/// A number as in the file: "152530.42507165897".
export type NumberText = string;

type WithSource = (this: unknown, key: string, value: unknown, context?: { source?: string }) => unknown;

export function parseExact<T>(text: string): T {
  const keep: WithSource = (_key, value, context) =>
    typeof value === 'number' ? (context?.source ?? String(value)) : value;
  return JSON.parse(text, keep as (key: string, value: unknown) => unknown) as T;
}
