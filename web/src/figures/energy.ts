// The energy of one rock along its trajectory: total kinetic, rotational, potential and mechanical energy.

import { measured } from '../units/numbers';
import { extentOf, openDrawing, openPlot, readAlong, sign, type Group, type Room } from './plot';

export interface EnergyRow {
  /// On the horizontal axis, ascending.
  place: number;
  /// [J]
  translational: number;
  rotational: number;
  potential: number;
  /// At the start of a flight, whose energies are quadratic in `place`: the change of potential energy over half its
  /// duration at the departure velocity [J].
  rise?: number | null;
  /// The tooltip.
  text: string;
}

/// `turns` is the change of each energy for a rise of potential energy by 1.
const curves = [
  { name: 'potential', label: 'potential', of: (row: EnergyRow) => row.potential, turns: 1 },
  { name: 'rotational', label: 'rotational', of: (row: EnergyRow) => row.rotational, turns: 0 },
  { name: 'kinetic', label: 'total kinetic', of: (row: EnergyRow) => row.translational + row.rotational, turns: -1 },
  {
    name: 'mechanical',
    label: 'mechanical',
    of: (row: EnergyRow) => row.translational + row.rotational + row.potential,
    turns: 0,
  },
];

export interface Energy {
  xLabel: string;
  rows: readonly EnergyRow[];
  /// Whether every row has a dot.
  hasDots: boolean;
  /// The displayed unit, of so many joules.
  unit?: string;
  per?: number;
}

export function energy(element: SVGSVGElement, room: Room, { xLabel, rows, hasDots, unit = 'kJ', per = 1000 }: Energy) {
  const shownIn = (joules: number) => joules / per;
  const svg = openDrawing(element, room);
  const shown = curves.filter(({ name, of }) => name !== 'rotational' || rows.some((row) => of(row) !== 0));
  const groups = shown.map(() => svg.append('g') as Group);
  const plot = openPlot(svg, room, {
    x: extentOf(
      rows.map(({ place }) => place),
      0.02,
    ),
    y: extentOf([0, ...rows.flatMap((row) => shown.map(({ of }) => shownIn(of(row))))]),
    xLabel,
    yLabel: `Energy [${unit}]`,
    entries: shown
      .map(({ name, label }, k) => ({
        text: `${label} energy`,
        draw: sign.line(`energy ${name}`),
        switches: groups[k]!,
      }))
      .reverse(),
  });
  const at = (place: number, joules: number) => `${plot.x(place).toFixed(2)},${plot.y(shownIn(joules)).toFixed(2)}`;
  shown.forEach(({ name, of, turns }, k) => {
    const path = rows.map((row, i) => {
      const from = rows[i - 1];
      if (!from) return `M${at(row.place, of(row))}`;
      if (typeof from.rise !== 'number') return `L${at(row.place, of(row))}`;
      return `Q${at((from.place + row.place) / 2, of(from) + turns * from.rise)} ${at(row.place, of(row))}`;
    });
    groups[k]!.raise().append('path').attr('class', `energy ${name}`).attr('d', path.join(''));
    if (!hasDots) return;
    const dots = groups[k]!.selectAll('circle')
      .data(rows)
      .enter()
      .append('circle')
      .attr('class', `stop ${name}`)
      .attr('r', 3);
    dots.attr('cx', (row: EnergyRow) => plot.x(row.place)).attr('cy', (row: EnergyRow) => plot.y(shownIn(of(row))));
  });
  const places = rows.map(({ place }) => place);
  const isAscending = places.every((place, k) => k === 0 || places[k - 1]! <= place);
  const order = isAscending ? rows : [...rows].sort((a, b) => a.place - b.place);
  readAlong(
    svg,
    plot,
    order.map(({ place }) => place),
    (k) => {
      const row = order[k]!;
      return [row.text, ...shown.map(({ label, of }) => `${label} ${measured(shownIn(of(row)))} ${unit}`).reverse()].join('\n');
    },
  );
}
