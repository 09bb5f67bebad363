// The runs of the page.

import {
  entriesIn,
  type BarrierOf,
  type FiguresOf,
  type HistogramOf,
  type Settings,
  type SummaryOf,
  type TerrainSummary,
} from '../archive/summary';
import {
  embedded,
  records,
  type EndPoint,
  type Hit,
  type Loss,
  type LossByNumber,
  type PageData,
  type Rock,
  type PathRow,
  type RunData,
  type Stop,
} from './data';
import { energyText, isNumber, lengthText, measured, showIn } from './format';

export const page = embedded<PageData>();

export type Summary = SummaryOf<number>;
export type Statistics = FiguresOf<number>;
export type Histogram = HistogramOf<number>;
export type BarrierResults = BarrierOf<number>;

export interface Run extends Pick<RunData, 'folder' | 'date' | 'summary' | 'maps' | 'convergence' | 'uncertainty' | 'notes'> {
  /// Its place on the page.
  index: number;
  name: string;
  /// The name that distinguishes it from the other run.
  label: string;
  colour: string;
  isSection: boolean;
  terrain: TerrainSummary;
  statistics: Record<string, Statistics>;
  histograms: Record<string, Histogram | null>;
  barriers: BarrierResults[];
  /// Tables with rows; `Total`: the rows of their files, of which the page carries some.
  endpoints: EndPoint[];
  endpointTotal: number;
  hits: Hit[];
  hitTotal: number;
  losses: Loss[];
  lossTotal: number;
  lossByNumber: LossByNumber[];
  envelopes: { cells_each: number; columns: string[]; rows: (number | null)[][] };
  rocks: Rock[];
  rocksWithPaths: number;
  observed: RunData['observed'];
  stops: Stop[];
}

const isSingle = page.runs.length === 1;
const nameOf = ({ summary, folder }: RunData) => summary.name || folder;
const areAlike = !isSingle && nameOf(page.runs[0]!) === nameOf(page.runs[1]!);

// Two runs with the same name are labelled by their folders, or else by their order.
function labelOf(data: RunData, index: number): string {
  if (!areAlike) return nameOf(data);
  return page.runs[0]!.folder !== page.runs[1]!.folder ? data.folder : `${nameOf(data)}, run ${index + 1}`;
}

function runOf(data: RunData, index: number): Run {
  const { summary, folder, date, maps, convergence, uncertainty, notes, observed } = data;
  const { columns } = data.paths;
  return {
    ...{ folder, date, summary, maps, convergence, uncertainty, notes, observed, index },
    name: nameOf(data),
    label: labelOf(data, index),
    colour: index === 0 ? 'var(--run-a)' : 'var(--run-b)',
    terrain: summary.terrain ?? {},
    isSection: summary.terrain?.kind === 'section',
    statistics: summary.statistics ?? {},
    histograms: summary.histograms ?? {},
    barriers: summary.barriers ?? [],
    endpoints: records<EndPoint>(data.endpoints),
    endpointTotal: data.endpoints.total,
    hits: records<Hit>(data.hits),
    hitTotal: data.hits.total,
    losses: records<Loss>(data.losses),
    lossTotal: data.losses.of_shown_paths,
    lossByNumber: records<LossByNumber>({ columns: data.losses.by_number_columns, rows: data.losses.by_number }),
    envelopes: data.envelopes as Run['envelopes'],
    rocks: data.paths.rocks.map(({ rock, rows }) => ({ rock, run: index, rows: records<PathRow>({ columns, rows }) })),
    rocksWithPaths: data.paths.total,
    stops: observed ? records<Stop>(observed.stops) : [],
  };
}

export const runs: readonly Run[] = page.runs.map(runOf);
export const firstRun = runs[0]!;
export const single = isSingle;
export const alike = areAlike;

/// A table of the project that occurs once, such as [analysis]; empty if it is missing.
export function tableOf({ summary }: Run, table: string): Settings {
  const found = summary.project[table];
  return found && !Array.isArray(found) ? (found as Settings) : {};
}
/// The entries of a repeated table, such as [[material]].
export const listOf = ({ summary }: Run, table: string) => entriesIn(summary.project, table);
export const materialsOf = (run: Run) => listOf(run, 'material');
export const barriersOf = (run: Run) => [...listOf(run, 'barrier'), ...listOf(run, 'collector')];
export const nameIn = ({ name }: Settings) => (typeof name === 'string' ? name : '');

/// The results of a barrier of this name; undefined: the run has none.
export const resultsAt = (run: Run, name: string) => run.barriers.find((barrier) => barrier.name === name);

/// x and y of a terrain are coordinates on a map, in metres always; its heights and all of a section are lengths.
export const xyText = (run: Run, value: number) => (run.isSection ? lengthText(value) : `${measured(value, 5)} m`);
interface Place {
  x: number;
  y: number;
  z?: number | null;
}
export const placeText = (run: Run, { x, y, z }: Place, hasY = !run.isSection) =>
  [`x ${xyText(run, x)}`, ...(hasY ? [`y ${xyText(run, y)}`] : []), ...(isNumber(z) ? [`z ${lengthText(z)}`] : [])].join(', ');

export const metricParts = runs.every((run) => run.isSection) ? 'Inputs' : 'Coordinates x and y, inputs';

/// The title block; of two runs that of the first. Texts that are not given are empty.
const reportTable = tableOf(firstRun, 'report');
const given = (key: string) => {
  const value = reportTable[key];
  return typeof value === 'string' || typeof value === 'number' ? String(value) : '';
};
export const titleBlock = {
  client: given('client'),
  project: given('project'),
  number: given('number'),
  revision: given('revision'),
  author: given('author'),
  checked: given('checked'),
  date: given('date'),
  text: given('text'),
};
if (reportTable.units === 'us') showIn('US customary');
/// Both papers leave columns of 184 mm between their margins.
export const papers = { A4: { size: 'A4 portrait', mm: 184 }, A3: { size: 'A3 landscape', mm: 394 } };
export const paperName: keyof typeof papers = reportTable.paper === 'A3' ? 'A3' : 'A4';

/// Capitalizes a sentence. With two runs it begins with a run's name, which stays as it is.
export const startOfSentence = (text: string) => (single ? text.charAt(0).toUpperCase() + text.slice(1) : text);

/// A barrier's line on plan as points [m]. In 2D it may be a single x.
export function barrierLine({ line }: Settings): [number, number][] {
  if (isNumber(line)) return [[line, 0]];
  if (!Array.isArray(line) || line.length === 0) return [];
  return Array.isArray(line[0]) ? (line as [number, number][]) : [[line[0] as number, (line[1] as number) ?? 0]];
}

export const endText = (run: Run) => (end: EndPoint) =>
  [
    `End of rock ${end.rock}${single ? '' : ` · ${run.label}`}`,
    end.end_reason,
    placeText(run, end),
    `runout ${lengthText(end.runout_xy)}, time ${measured(end.time)} s`,
    `maximum total kinetic energy ${energyText(end.max_ke)}`,
  ].join('\n');
