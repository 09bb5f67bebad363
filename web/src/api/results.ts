// Requests for the results of a run.

import { getJson, getText } from './client';
import { parseExact, type NumberText } from './exact';
import type { Difference, RockAnswer, RunMap, Statistics } from './types';

/// Which rocks are counted: all conditions must be met; the names of a list are alternatives; null: no condition.
export interface RockFilter {
  reasons: string[] | null;
  seeders: string[] | null;
  sources: string[] | null;
  barriers: string[] | null;
  /// Numbers of release places of the shown run.
  releases: number[] | null;
  /// The rocks that cross an asked line: the server's name of their selection.
  crossing: string | null;
  minEnergy_kJ: number | null;
  maxEnergy_kJ: number | null;
}

/// Descriptive statistics as in summary.json.
export interface FigureTexts {
  [figure: string]: NumberText | NumberText[] | Record<string, NumberText>;
}

/// The part of summary.json that the page shows.
export interface Summary {
  name: string;
  seed: NumberText;
  rocks: { planned: NumberText; done: NumberText; lifted: NumberText };
  interrupted: boolean;
  end_reasons: Record<string, NumberText>;
  events: NumberText;
  statistics: Record<string, FigureTexts>;
  barriers?: { name: string; kind: 'barrier' | 'collector'; statistics?: Record<string, FigureTexts> }[];
  design?: Design;
  sources: { name: string }[];
  /// By seeder.
  releases?: { rocks: NumberText }[];
  project: { seeder: { name?: string }[]; [table: string]: unknown };
  /// Files with the checksums that they had when the run began, and where values of the library are from.
  inputs?: {
    files: { name: string; bytes: NumberText; sha256: string }[];
    material_sources?: { material: string; like: string; keys: string[]; source: string }[];
  };
  talus?: { version: string };
  warnings: string[];
  /// Of the warnings that have one, by their place in the list.
  warning_kinds?: { warning: NumberText; kind: string; where: string }[];
  notes?: string[];
  timings: { seconds: NumberText; rocks_per_second: NumberText; threads: NumberText };
}

/// A percentile with the ends of its confidence interval; null if there are too few rocks.
export type Interval = [NumberText, NumberText | null, NumberText | null];
export interface DesignLine {
  name: string;
  rocks: NumberText;
  percentiles: Record<string, Record<string, Interval>>;
  needs: { energy_J: NumberText; class: NumberText; height_m: NumberText } | null;
  clearance_m: NumberText | null;
  most_elongation_m: NumberText | null;
}

/// A kit of a pair of lines.
export interface PairKit {
  line: string;
  kit: string | null;
  height_m: NumberText;
  energy_J: NumberText;
}
/// Two lines, one behind the other.
export interface DesignPair {
  first: PairKit;
  second: PairKit;
  suffices: boolean;
  caught_share: { value: NumberText; low: NumberText; high: NumberText } | null;
  caught_by_first: NumberText;
  at_second: NumberText;
  caught_by_second: NumberText;
  beside: NumberText;
  cost: NumberText;
  overlap_m: NumberText | null;
  needs_overlap_m: NumberText | null;
}
/// A factor of the check, with where its value is from.
export interface AppliedFactor {
  symbol: string;
  key: string;
  multiplies: string;
  value: NumberText;
  source: string;
  not_read: string;
}
export interface Design {
  standard: string | null;
  applied_factors?: AppliedFactor[];
  pairs?: DesignPair[];
  confidence: NumberText;
  design_percentile: NumberText;
  lines: DesignLine[];
}

export interface BarrierAnswer {
  name: string;
  kind: 'barrier' | 'collector';
  height_m: NumberText;
  capacity_kJ: NumberText | null;
  hits: NumberText;
  rocks_hit: NumberText;
  stopped: NumberText;
  rebounded: NumberText;
  passed_through: NumberText;
  passed_above: NumberText;
  design: DesignLine | null;
}

export interface ColumnStatistics extends Omit<Statistics, 'statistics'> {
  statistics: FigureTexts;
}

export interface RunFile {
  name: string;
  bytes: number;
}

const at = (id: string) => `/api/runs/${encodeURIComponent(id)}`;
export const fileAddress = (id: string, name: string) =>
  `${at(id)}/files/${name.split('/').map(encodeURIComponent).join('/')}`;

/// The filter as a query string.
function queryOf(filter: RockFilter | null): string {
  const query = new URLSearchParams();
  const lists = { reason: filter?.reasons, seeder: filter?.seeders, source: filter?.sources, barrier: filter?.barriers };
  for (const [key, names] of Object.entries(lists)) for (const name of names ?? []) query.append(key, name);
  for (const number of filter?.releases ?? []) query.append('release', String(number));
  if (filter && filter.crossing !== null) query.set('crossing', filter.crossing);
  if (filter && filter.minEnergy_kJ !== null) query.set('min_energy_kJ', String(filter.minEnergy_kJ));
  if (filter && filter.maxEnergy_kJ !== null) query.set('max_energy_kJ', String(filter.maxEnergy_kJ));
  const text = query.toString();
  return text && `&${text}`;
}

async function statisticsAt(path: string, signal?: AbortSignal): Promise<ColumnStatistics> {
  const text = await getText(path, signal);
  // Numbers for drawing, texts for tables.
  const exact = parseExact<{ statistics: FigureTexts }>(text);
  return { ...(JSON.parse(text) as Statistics), statistics: exact.statistics };
}

export const results = {
  summary: async (id: string, signal?: AbortSignal) => parseExact<Summary>(await getText(`${at(id)}/summary`, signal)),
  files: async (id: string, signal?: AbortSignal) =>
    (await getJson<{ files: RunFile[] }>(`${at(id)}/files`, signal)).files,
  fileText: (id: string, name: string, signal?: AbortSignal) => getText(fileAddress(id, name), signal),
  statistics: (id: string, column: string, filter: RockFilter | null, signal?: AbortSignal) =>
    statisticsAt(`${at(id)}/statistics?of=${encodeURIComponent(column)}${queryOf(filter)}`, signal),
  /// Statistics of two runs with histograms in the same bins: of the hits on a barrier (by name), or of the rocks.
  compared: async (id: string, other: string, column: string, filter: RockFilter | null, barrier: string | null, signal?: AbortSignal) => {
    const on = barrier === null ? '' : `&hits_on=${encodeURIComponent(barrier)}`;
    const path = `${at(id)}/compared/${encodeURIComponent(other)}/statistics?of=${encodeURIComponent(column)}${on}`;
    const text = await getText(`${path}${queryOf(filter)}`, signal);
    const exact = parseExact<{ runs: { statistics: FigureTexts }[] }>(text);
    const { runs } = JSON.parse(text) as { runs: [Statistics, Statistics] };
    return runs.map((run, k) => ({ ...run, statistics: exact.runs[k]!.statistics })) as [ColumnStatistics, ColumnStatistics];
  },
  barriers: async (id: string, signal?: AbortSignal) =>
    parseExact<{ barriers: BarrierAnswer[] }>(await getText(`${at(id)}/barriers`, signal)).barriers,
  barrierStatistics: (id: string, barrier: number, column: string, filter: RockFilter | null, signal?: AbortSignal) =>
    statisticsAt(`${at(id)}/barriers/${barrier}/statistics?of=${encodeURIComponent(column)}${queryOf(filter)}`, signal),
  rock: (id: string, rock: number, signal?: AbortSignal) => getJson<RockAnswer>(`${at(id)}/rocks/${rock}`, signal),
  maps: async (id: string, signal?: AbortSignal) => (await getJson<{ maps: RunMap[] }>(`${at(id)}/maps`, signal)).maps,
  differences: async (id: string, other: string, signal?: AbortSignal) =>
    (await getJson<{ differences: Difference[] }>(`${at(id)}/differences/${encodeURIComponent(other)}`, signal))
      .differences,
};

