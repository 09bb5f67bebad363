// Reads envelopes.csv.

import { curvesOf, envelopeQuantities, type Cells, type EnvelopeQuantity } from '../figures/envelope';

export function envelopesOf(csv: string, name: string, colour: string): Cells {
  const [heading = '', ...lines] = csv.trimEnd().split('\n');
  const rows = lines.map((line) => line.split(',').map((cell) => (cell === '' ? null : Number(cell))));
  const values = new Map(heading.split(',').map((column, k) => [column, rows.map((row) => row[k] ?? null)]));
  const x = (values.get('x_m') ?? []).map(Number);
  values.delete('x_m');
  // Cells are adjacent and of equal width.
  const half = x.length > 1 ? (x.at(-1)! - x[0]!) / (x.length - 1) / 2 : 0.5;
  return { name, colour, x, from: x.map((at) => at - half), to: x.map((at) => at + half), values };
}

/// The quantities of the file.
export const quantitiesOf = ({ values }: Cells): EnvelopeQuantity[] =>
  envelopeQuantities.filter(({ key }) => curvesOf([...values.keys()], key).length > 0);
