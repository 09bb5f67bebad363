// A calibration as the panel edits it, and its study file.

import { inlineText, pairText, stringText, tableText, type TomlTable, type TomlValue } from '../toml/format';

export const observationKinds = ['stops', 'marks', 'values', 'zones'] as const;
export type ObservationKind = (typeof observationKinds)[number];
/// The numbers of an entry, in the order of the form, and the only kind that has them.
export const observationNumbers = { accuracy_m: '', weight: '', released: 'zones', blocks: 'zones', relative_accuracy: 'zones' } as const;
export type ObservationNumber = keyof typeof observationNumbers;
export const numbersOfKind = (kind: ObservationKind) =>
  (Object.keys(observationNumbers) as ObservationNumber[]).filter((key) => ['', kind].includes(observationNumbers[key]));
export interface Observation {
  kind: ObservationKind;
  /// Relative to the project's folder.
  file: string;
  /// The barrier or collector of values.
  at?: string;
  numbers?: Partial<Record<ObservationNumber, number>>;
}
export interface Sought {
  path: string;
  range: [number, number];
  /// A distribution of a study that was written by hand, instead of the range.
  prior?: TomlTable;
}
/// The numbers of a study with a default of their own.
export const studyNumbers = ['rocks', 'draws', 'rounds', 'most_draws', 'folds', 'seed'] as const;
export type StudyNumber = (typeof studyNumbers)[number];
export interface StudyForm {
  /// Without folder and ending.
  name: string;
  observations: Observation[];
  parameters: Sought[];
  numbers: Partial<Record<StudyNumber, number>>;
  /// The study file that this form was written to or read from, which it may replace.
  written?: string;
}

export const studyEnding = '.study.toml';
export const emptyStudy = (name: string): StudyForm => ({ name, observations: [], parameters: [], numbers: {} });

/// The text of the study of a project in the same folder.
export function studyText(form: StudyForm, project: string): string {
  const tables: [string, TomlTable][] = [
    ['site', { project }],
    ...form.observations.map(({ kind, file, at, numbers = {} }): [string, TomlTable] => [
      'observations',
      {
        [kind]: file,
        ...(kind === 'values' && at !== undefined && { at }),
        ...Object.fromEntries(
          numbersOfKind(kind).flatMap((key) => (numbers[key] === undefined ? [] : [[key, numbers[key]]])),
        ),
      },
    ]),
    ...form.parameters.map(({ path, range, prior }): [string, TomlTable] => [
      'parameter',
      { path, ...(prior ? { prior } : { range }) },
    ]),
  ];
  return [
    `# Written by the workbench. To run it again: talus calibrate ${stringText(form.name + studyEnding)}`,
    pairText('name', form.name),
    ...studyNumbers.flatMap((key) => (form.numbers[key] === undefined ? [] : [pairText(key, form.numbers[key])])),
    ...tables.map(([key, table]) => `\n${tableText([key], table)}`),
    '',
  ].join('\n');
}

const tablesOf = (value: TomlValue | undefined): TomlTable[] =>
  Array.isArray(value) ? value.filter((one): one is TomlTable => typeof one === 'object' && !Array.isArray(one)) : [];
const others = (table: TomlTable, known: readonly string[]) => Object.keys(table).filter((key) => !known.includes(key));

/// Reads the values of a study file for the panel. Throws an error with the reason if the panel cannot show all of it.
export function formOf(values: TomlTable, name: string, project: string): StudyForm {
  const refuse = (what: string): never => {
    throw new Error(`The study ${what}, which the workbench cannot edit. Run it with talus calibrate.`);
  };
  const sites = tablesOf(values.site);
  const odd = others(values, ['name', 'site', 'observations', 'parameter', ...studyNumbers]);
  if (odd.length > 0) refuse(`has ${odd.join(', ')}`);
  if (sites.length !== 1) refuse('has several sites');
  if (sites[0]!.set !== undefined) refuse('overrides settings of its project');
  if (sites[0]!.project !== project) refuse(`is of the project ${inlineText(sites[0]!.project ?? '')}`);
  const number = (value: TomlValue | undefined) => (typeof value === 'number' ? value : undefined);
  const observations = tablesOf(values.observations).map((table): Observation => {
    const kind = observationKinds.find((one) => typeof table[one] === 'string');
    const more = others(table, ['name', 'site', ...observationKinds, 'at', ...Object.keys(observationNumbers)]);
    if (!kind || more.length > 0) return refuse(`has observations with ${more.join(', ') || 'no file'}`);
    const numbers = Object.fromEntries(
      numbersOfKind(kind).flatMap((key) => (number(table[key]) === undefined ? [] : [[key, Number(table[key])]])),
    );
    return {
      kind,
      file: String(table[kind]),
      ...(typeof table.at === 'string' && { at: table.at }),
      ...(Object.keys(numbers).length > 0 && { numbers }),
    };
  });
  const parameters = tablesOf(values.parameter).map((table): Sought => {
    const [least, most] = Array.isArray(table.range) ? table.range.map(Number) : [0, 0];
    const more = others(table, ['path', 'range', 'prior']);
    if (more.length > 0) refuse(`has a parameter with ${more.join(', ')}`);
    const prior = table.prior as TomlTable | undefined;
    return { path: String(table.path ?? ''), range: [least ?? 0, most ?? 0], ...(prior && { prior }) };
  });
  const numbers = Object.fromEntries(studyNumbers.flatMap((key) => (number(values[key]) === undefined ? [] : [[key, Number(values[key])]])));
  return { name, observations, parameters, numbers, written: name + studyEnding };
}
