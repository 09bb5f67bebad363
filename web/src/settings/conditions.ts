// Whether a setting has an effect, given the other values of the project: by the conditions of its declaration
// (x-applies-when in the schema). Shared by the forms and the report.

/// A condition on another setting of the same row, or of a table that occurs once ("terrain.raster").
export interface Condition {
  key: string;
  /// Whether the setting is given.
  given?: boolean;
  /// Values as in the file, texts without quotes: the setting has one of these, or none of them.
  is?: readonly string[];
  not?: readonly string[];
}

/// A setting has an effect if at least one condition of each list is met.
export type Needs = readonly (readonly Condition[])[];

type Values = Readonly<Record<string, unknown>>;
/// The default of a setting under the laws of a project (`analysis.laws`).
export type DefaultOf = (table: string, key: string, laws: unknown) => unknown;

const valuesOf = (table: unknown): Values =>
  typeof table === 'object' && table !== null && !Array.isArray(table) ? (table as Values) : {};

const textOf = (value: unknown) => (Array.isArray(value) ? JSON.stringify(value) : String(value));

/// Whether a condition of a setting of `table` is met. `row` has the setting's own values, `project` the other tables.
export function isMet(
  { key, given, is, not }: Condition,
  table: string,
  row: Values,
  project: Values,
  defaultOf: DefaultOf,
): boolean {
  const [first, second] = key.split('.');
  const name = second === undefined ? table : first!;
  const own = second ?? first!;
  const value = (name === table ? row : valuesOf(project[name]))[own] ?? undefined;
  if (given !== undefined) return (value !== undefined) === given;
  const text = textOf(value ?? defaultOf(name, own, valuesOf(project.analysis).laws));
  return is ? is.includes(text) : !not?.includes(text);
}

/// Whether a setting of `table` has an effect. Conditions on the setting `except` count as met.
export const hasEffect = (
  needs: Needs,
  table: string,
  row: Values,
  project: Values,
  defaultOf: DefaultOf = () => undefined,
  except = '',
): boolean =>
  needs.every(
    (any) =>
      any.some((one) => one.key === except) || any.some((one) => isMet(one, table, row, project, defaultOf)),
  );
