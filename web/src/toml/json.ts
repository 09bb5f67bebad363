/// Values as JSON. Integers beyond double precision are rounded to numbers.
export const jsonText = (value: unknown): string =>
  JSON.stringify(value, (_key, part: unknown) => (typeof part === 'bigint' ? Number(part) : part));
