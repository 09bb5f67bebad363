// Impact heights and energies of the hits on a barrier, as dots.

import type { Settings } from '../archive/summary';
import * as d3 from '../figures/d3';
import { axes, extentOf, legend, sign, type Group } from '../figures/plot';
import { tip } from '../figures/tip';
import type { Hit } from './data';
import { figure } from './figure';
import { axisIn, energyText, givenLength, isNumber, kJ, lengthText, measured, number, unitIn } from './format';
import { barriersOf, nameIn, placeText, resultsAt, runs, single, type Run } from './run';

interface HitOfRun extends Hit {
  run: Run;
}

const heightOf = ({ height_m }: Settings) => (isNumber(height_m) ? height_m : null);

// Heights of the barriers of this name, which are unlimited if they have none.
const topsOf = (name: string) =>
  runs.flatMap((run) =>
    barriersOf(run)
      .filter((barrier) => nameIn(barrier) === name)
      .map(heightOf)
      .filter((height) => height !== null),
  );

const hitText = ({ run, rock, outcome, height, angle, ke_translational, ke_total, x, y, z }: HitOfRun) =>
  [
    `Rock ${rock}: ${outcome}${single ? '' : ` · ${run.label}`}`,
    `height ${lengthText(height)}, angle ${measured(angle, 3)}°`,
    `translational ${energyText(ke_translational)}, total ${energyText(ke_total)}`,
    `at ${placeText(run, { x, y, z }, true)}`,
  ].join('\n');

function drawHits(svg: Group, width: number, name: string, hits: readonly HitOfRun[], shown: readonly Run[]): number {
  const side = { left: 62, right: width - 12, top: 12, bottom: 232 };
  const tops = topsOf(name);
  const highest = d3.max(tops);
  const x = d3
    .scaleLinear()
    .domain(extentOf([0, ...hits.map(({ ke_translational }) => ke_translational)]))
    .range([side.left, side.right]);
  const y = d3
    .scaleLinear()
    .domain(extentOf([0, ...(highest ? [highest] : []), ...hits.map(({ height }) => height)], 0.05))
    .range([side.bottom, side.top]);
  axes(svg, axisIn('J', x), axisIn('m', y), side, {
    xLabel: `Translational kinetic energy [${unitIn('J')}]`,
    yLabel: `Impact height of the contact [${unitIn('m')}]`,
  });
  for (const top of new Set(tops)) {
    svg
      .append('line')
      .attr('class', 'barrier')
      .style('stroke-width', 1.5)
      .attr('x1', side.left)
      .attr('x2', side.right)
      .attr('y1', y(top))
      .attr('y2', y(top));
    svg
      .append('text')
      .attr('class', 'barrier-name halo')
      .attr('x', side.left + 6)
      .attr('y', y(top) + 14)
      .text(`top, ${givenLength(top)}`);
  }
  const dots = svg
    .append('g')
    .selectAll('circle')
    .data(hits)
    .enter()
    .append('circle')
    .attr('class', 'dot')
    .attr('r', 3.4)
    .style('--run', ({ run }) => run.colour)
    .attr('cx', ({ ke_translational }) => x(ke_translational))
    .attr('cy', ({ height }) => y(height));
  tip(dots, hitText);
  if (single) return side.bottom + 42;
  const entries = shown.map(({ label, colour }) => ({ text: label, draw: sign.circle('dot', colour) }));
  return legend(svg, entries, side.left, side.bottom + 54, side.right) + 12;
}

/// Nothing if the page has no hits on the barrier.
export function hitFigure(parent: Group, name: string) {
  const shown = runs
    .map((run) => ({ run, hits: run.hits.filter(({ barrier }) => barrier === name) }))
    .filter(({ hits }) => hits.length > 0);
  if (shown.length === 0) return;
  const all = shown.flatMap(({ run, hits }) => hits.map((hit) => ({ ...hit, run })));
  const counts = shown.map(({ run, hits }) => {
    const reached = resultsAt(run, name)?.hits ?? hits.length;
    return `${single ? '' : `${run.label}: `}${number(hits.length)} of ${number(reached)} hits`;
  });
  figure(parent, {
    title: 'Impact height and translational energy',
    label: `Impact height against translational energy at ${name}`,
    caption: `${counts.join('; ')}.`,
    draw: (svg, width) => drawHits(svg, width, name, all, shown.map(({ run }) => run)),
    rows: () => [
      ['run', 'rock', 'impact_height_m', 'angle_deg', 'ke_translational_kJ', 'ke_total_kJ', 'outcome'],
      ...all.map(({ run, rock, height, angle, ke_translational, ke_total, outcome }) => [
        ...[run.label, rock, height, angle],
        ...[kJ(ke_translational), kJ(ke_total), outcome],
      ]),
    ],
  });
}
