// Envelopes along a section, from envelopes.csv: energy, velocity, bounce height and counts, cell by cell. For two runs
// only the first curve of each is drawn.

import { sectionFigures } from '../generated/columns';
import type { Cell } from './files';
import {
  extentOf,
  fromZero,
  openDrawing,
  openPlot,
  rangeText,
  readAlong,
  sign,
  titleOf,
  valueText,
  type Group,
  type Quantity,
  type Room,
} from './plot';

/// A quantity of the file; `key` is the common beginning of its column names, or the name of its only column.
export interface EnvelopeQuantity extends Quantity {
  key: string;
}

export const envelopeQuantities: readonly EnvelopeQuantity[] = Object.entries(sectionFigures).map(([key, figure]) => ({
  key,
  ...figure,
}));

export interface Curve {
  column: string;
  title: string;
  style: 'maximum' | 'percentile' | 'mean' | 'band';
  dash: string | null;
}

const dashes = ['7 3', '4 3', '2 3', '1 4'];

// The ends of the range between ensembles.
const bandEnds = { low: '5 % of ensembles below', high: '5 % of ensembles above' } as const;
const bandDash = '1 2';

/// The curves of a quantity among the columns of a file: maximum, percentiles in descending order, mean. Ranges between
/// ensembles are those of shares and maxima.
export function curvesOf(columns: readonly string[], key: string): Curve[] {
  const band = Object.entries(bandEnds).flatMap(([end, title]): Curve[] => {
    const column = columns.find((each) => each === `${key}_${end}` || each.startsWith(`${key}_max_${end}_`));
    if (!column) return [];
    return [{ column, title: column === `${key}_${end}` ? title : `maximum, ${title}`, style: 'band', dash: bandDash }];
  });
  if (columns.includes(key))
    return [{ column: key, title: band.length > 0 ? 'all rocks' : '', style: 'maximum', dash: null }, ...band];
  const found = columns.flatMap((column): (Omit<Curve, 'dash'> & { order: number })[] => {
    const figure = column.startsWith(`${key}_`)
      ? /^(max|mean|p[\d.]+)_(?!low_|high_)/.exec(column.slice(key.length + 1))?.[1]
      : undefined;
    if (!figure) return [];
    if (figure === 'max') return [{ column, title: 'maximum', style: 'maximum', order: Infinity }];
    if (figure === 'mean') return [{ column, title: 'mean', style: 'mean', order: -1 }];
    const percent = Number(figure.slice(1));
    return [{ column, title: `percentile ${percent}`, style: 'percentile', order: percent }];
  });
  found.sort((a, b) => b.order - a.order);
  const curves = found.map(({ column, title, style }, k) => ({
    column,
    title,
    style,
    dash: dashes[Math.min(k, dashes.length) - 1] ?? null,
  }));
  return [...curves, ...band];
}

/// The cells of one run.
export interface Cells {
  name: string;
  colour: string;
  /// The centre of each cell as in the file, and its edges, ascending [m, or `xUnit` of a figure].
  x: readonly number[];
  from: readonly number[];
  to: readonly number[];
  /// By column name; null where no rock passed.
  values: ReadonlyMap<string, readonly (number | null)[]>;
}

export interface Envelope extends EnvelopeQuantity {
  of: readonly Cells[];
  /// Barriers in the section.
  walls: readonly { name: string; x: number }[];
  /// Of the places of cells and walls.
  xUnit?: string;
}

const curvesIn = ({ values }: Cells, key: string, isOne: boolean) => {
  const curves = curvesOf([...values.keys()], key);
  return isOne ? curves : curves.slice(0, 1);
};

export function envelope(element: SVGSVGElement, room: Room, { key, title, unit, per, of, walls, xUnit = 'm' }: Envelope) {
  const svg = openDrawing(element, room);
  const isOne = of.length === 1;
  const lines = of.flatMap((cells) =>
    curvesIn(cells, key, isOne).map((curve) => ({
      ...curve,
      cells,
      text: isOne ? curve.title : [cells.name, curve.title].filter(Boolean).join(', '),
      values: cells.values.get(curve.column)!.map((value) => (value === null ? null : value / per)),
      group: svg.append('g') as Group,
    })),
  );
  const drawnBy = ({ style, dash, cells }: (typeof lines)[number]) =>
    sign.line(`envelope ${style}`, cells.colour, dash ?? '');
  const [low, high] = fromZero(lines.flatMap(({ values }) => values.filter((value) => value !== null)));
  const plot = openPlot(svg, room, {
    x: extentOf(
      of.flatMap(({ from, to }) => [...from, ...to]),
      0.02,
    ),
    y: [low, walls.length > 0 ? 1.12 * high : high], // space for their names
    xLabel: `x [${xUnit}]`,
    yLabel: titleOf({ title, unit }),
    entries:
      lines.length > 1 ? lines.map((line) => ({ text: line.text, draw: drawnBy(line), switches: line.group })) : [],
  });
  const { side, x, y } = plot;
  for (const wall of walls) {
    svg
      .append('line')
      .attr('class', 'barrier thin')
      .attr('x1', x(wall.x))
      .attr('x2', x(wall.x))
      .attr('y1', side.bottom)
      .attr('y2', side.top);
  }
  for (const { style, dash, cells, values, group } of lines) {
    // Steps between adjacent cells; the line is broken where no rock passed.
    const path = values.map((value, k) => {
      if (value === null) return '';
      const isBroken = k === 0 || values[k - 1] === null;
      const begin = isBroken ? `M${x(cells.from[k]!).toFixed(2)},` : 'V';
      return `${begin}${y(value).toFixed(2)}H${x(cells.to[k]!).toFixed(2)}`;
    });
    group.raise().append('path').attr('class', `envelope ${style}`).style('--run', cells.colour);
    group
      .select('path')
      .style('stroke-dasharray', dash ?? 'none')
      .attr('d', path.join(''));
  }
  for (const wall of walls)
    svg
      .append('text')
      .attr('class', 'barrier-name halo')
      .attr('x', x(wall.x) + 5)
      .attr('y', side.top + 13)
      .text(wall.name);
  const first = of[0];
  if (!first) return;
  const middles = first.x;
  readAlong(svg, plot, middles, (k) =>
    [
      `x ${rangeText(first.from[k]!, first.to[k]!, xUnit)}`,
      ...lines.map(({ text, cells, values }) => {
        const here = values[cells.from.findIndex((low, c) => low <= middles[k]! && middles[k]! < cells.to[c]!)] ?? null;
        return `${text} ${here === null ? '–' : valueText(here, unit)}`.trim();
      }),
    ].join('\n'),
  );
}

/// The numbers of the files; with several runs, the first column names the run.
export function envelopeRows(of: readonly Cells[], key: string): Cell[][] {
  const columns = of[0] ? curvesOf([...of[0].values.keys()], key).map(({ column }) => column) : [];
  const named = of.length > 1;
  return [
    [...(named ? ['of'] : []), 'x_m', 'from_x_m', 'to_x_m', ...columns],
    ...of.flatMap(({ name, x, from, to, values }) =>
      x.map((middle, k) => [
        ...(named ? [name] : []),
        middle,
        from[k]!,
        to[k]!,
        ...columns.map((column) => values.get(column)?.[k] ?? ''),
      ]),
    ),
  ];
}
