/// Values as JSON, which has whole numbers of any size; its functions take none that a double cannot hold.
export const jsonText = (value: unknown): string =>
  JSON.stringify(value, (_key, part: unknown) => (typeof part === 'bigint' ? Number(part) : part));
