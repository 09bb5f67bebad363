// envelopes.csv: what rocks did along a section, cell by cell.

export interface Envelopes {
  /// The middle of each cell [m].
  x: number[];
  /// By the column's name, in the order of the file; null where no rock was.
  columns: Map<string, (number | null)[]>;
}

export function envelopesOf(csv: string): Envelopes {
  const [heading = '', ...lines] = csv.trimEnd().split('\n');
  const rows = lines.map((line) => line.split(',').map((cell) => (cell === '' ? null : Number(cell))));
  const columns = new Map(heading.split(',').map((name, k) => [name, rows.map((row) => row[k] ?? null)]));
  const x = (columns.get('x_m') ?? []).map(Number);
  columns.delete('x_m');
  return { x, columns };
}

/// What can be drawn together: a quantity, and which of its figures there are.
export interface Quantity {
  /// What the columns' names begin with; of counts, the whole name.
  key: string;
  title: string;
  /// As it is shown.
  unit: string;
  /// How much one of it is of what the file has.
  per: number;
  figures: { column: string; title: string }[];
}

const measured: Omit<Quantity, 'figures'>[] = [
  { key: 'energy_total', title: 'Energy, total', unit: 'kJ', per: 1 },
  { key: 'energy_translational', title: 'Energy, translational', unit: 'kJ', per: 1 },
  { key: 'velocity', title: 'Velocity', unit: 'm/s', per: 1 },
  { key: 'bounce_height', title: 'Bounce height', unit: 'm', per: 1 },
];
const counted: Omit<Quantity, 'figures'>[] = [
  { key: 'reach_share', title: 'Share of rocks that get here', unit: '%', per: 0.01 },
  { key: 'passages', title: 'Rocks that were here', unit: '', per: 1 },
  { key: 'deposits', title: 'Rocks that came to rest here', unit: '', per: 1 },
  { key: 'impacts', title: 'Impacts', unit: '', per: 1 },
];

const figureTitle = (figure: string) =>
  figure === 'max' ? 'Maximum' : figure === 'mean' ? 'Mean' : `Percentile ${figure.slice(1)}`;

/// Those that the file has, the most asked for first.
export function quantitiesOf({ columns }: Envelopes): Quantity[] {
  const names = [...columns.keys()];
  const figuresOf = (key: string) =>
    names.flatMap((column) => {
      const figure = column.startsWith(`${key}_`) ? /^(max|mean|p[\d.]+)_/.exec(column.slice(key.length + 1))?.[1] : undefined;
      return figure ? [{ column, title: figureTitle(figure) }] : [];
    });
  return [
    ...measured.map((quantity) => ({ ...quantity, figures: figuresOf(quantity.key) })),
    ...counted.map((quantity) => ({
      ...quantity,
      figures: names.includes(quantity.key) ? [{ column: quantity.key, title: quantity.title }] : [],
    })),
  ].filter(({ figures }) => figures.length > 0);
}
