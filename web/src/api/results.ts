// Requests for the results of a run.

import type { AppliedFactorOf, DesignLineOf, DesignPairOf, FiguresOf, IntervalOf, PairKitOf, SummaryOf } from '../archive/summary';
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

// summary.json with the numbers as texts of the file.
export type FigureTexts = FiguresOf<NumberText>;
export type Summary = SummaryOf<NumberText>;
export type Interval = IntervalOf<NumberText>;
export type DesignLine = DesignLineOf<NumberText>;
export type PairKit = PairKitOf<NumberText>;
export type DesignPair = DesignPairOf<NumberText>;
export type AppliedFactor = AppliedFactorOf<NumberText>;

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

