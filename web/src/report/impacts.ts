// Total kinetic energy lost at each impact on the ground: single impacts of the trajectories shown, and the mean over all
// rocks.

import * as d3 from '../figures/d3';
import { axes, extentOf, legend, sign, type Group, type Scale } from '../figures/plot';
import { tip } from '../figures/tip';
import type { Loss, LossByNumber } from './data';
import { drawing, element, figure } from './figure';
import { axisIn, count, energyText, kJ, lengthText, number, unitIn } from './format';
import { runs, single, startOfSentence, xyText, type Run } from './run';

interface LossOfRun extends Loss {
  run: Run;
}
interface Place {
  text: string;
  label: string;
  of: (loss: Loss) => number;
}

// The position of an impact: x along a section, the distance travelled in 3D.
const placeIn = (shown: readonly Run[]): Place =>
  shown.every(({ isSection }) => isSection)
    ? { text: 'position (x)', label: `x of the impact [${unitIn('m')}]`, of: ({ x }) => x }
    : {
        text: 'distance travelled',
        label: `Distance travelled on plan [${unitIn('m')}]`,
        of: ({ travelled }) => travelled,
      };

const lossText = ({ run, rock, impact, lost, kinetic_before, x, travelled }: LossOfRun) =>
  [
    `Rock ${rock}, impact ${impact}${single ? '' : ` · ${run.label}`}`,
    `lost ${energyText(lost)} of ${energyText(kinetic_before)} of total kinetic energy`,
    `at x ${xyText(run, x)}, after ${lengthText(travelled)} on plan`,
  ].join('\n');

const meanText = ({ label }: Run, { impact, rocks, mean, least, most }: LossByNumber) =>
  [
    ...(single ? [] : [label]),
    `Impact ${impact}: ${count(rocks, 'rock')}`,
    `mean loss ${energyText(mean)}`,
    `minimum ${energyText(least)}, maximum ${energyText(most)}`,
  ].join('\n');

// The mean loss at each number of impact, as a line with dots.
function drawMeans(svg: Group, { x, y }: { x: Scale; y: Scale }, run: Run, points: readonly LossByNumber[]) {
  const colour = single ? '' : run.colour;
  const curve = d3
    .line<LossByNumber>()
    .x(({ impact }) => x(impact))
    .y(({ mean }) => y(mean));
  svg.append('path').attr('class', 'mean-line').style('stroke', colour).attr('d', curve([...points]));
  const stops = svg
    .append('g')
    .selectAll('circle')
    .data(points)
    .enter()
    .append('circle')
    .attr('r', 4)
    .attr('class', 'mechanical stop')
    .style('fill', colour)
    .attr('cx', ({ impact }) => x(impact))
    .attr('cy', ({ mean }) => y(mean));
  tip(stops, (point) => meanText(run, point));
}

// Against the number of the impact, or against its place if one is given.
function drawLosses(svg: Group, width: number, shown: readonly Run[], losses: readonly LossOfRun[], place: Place | null): number {
  const side = { left: 78, right: width - 14, top: 12, bottom: 232 };
  const highest = d3.max(losses, ({ impact }) => impact) ?? 0;
  const asideOf = (run: Run) => (shown.length === 1 ? 0 : run === shown[0] ? -0.12 : 0.12);
  const at = (loss: LossOfRun) => (place ? place.of(loss) : loss.impact + asideOf(loss.run));
  const means = place
    ? []
    : shown.map((run) => ({ run, points: run.lossByNumber.filter(({ impact }) => impact <= highest) }));
  const x = d3
    .scaleLinear()
    .domain(place ? extentOf(losses.map(at)) : [0.4, Math.max(highest, 2) + 0.6])
    .range([side.left, side.right]);
  const heights = [...losses.map(({ lost }) => lost), ...means.flatMap(({ points }) => points.map(({ mean }) => mean))];
  const y = d3
    .scaleLinear()
    .domain(extentOf([0, ...heights]))
    .range([side.bottom, side.top]);
  axes(svg, place ? axisIn('m', x) : x, axisIn('J', y), side, {
    xLabel: place ? place.label : 'Number of the impact',
    yLabel: `Total kinetic energy lost [${unitIn('J')}]`,
    xTicks: place ? undefined : Math.min(highest, 16),
  });
  const dots = svg
    .append('g')
    .selectAll('circle')
    .data(losses)
    .enter()
    .append('circle')
    .attr('class', 'dot')
    .attr('r', 3)
    .style('--run', ({ run }) => run.colour)
    .attr('cx', (loss) => x(at(loss)))
    .attr('cy', ({ lost }) => y(lost));
  tip(dots, lossText);
  for (const { run, points } of means) drawMeans(svg, { x, y }, run, points);
  const entries = [
    ...shown.map(({ label, colour }) => ({ text: single ? 'single impact' : label, draw: sign.circle('dot', colour) })),
    ...(place ? [] : [{ text: 'mean over all rocks', draw: sign.line('mean-line') }]),
  ];
  return legend(svg, entries, side.left, side.bottom + 56, side.right) + 12;
}

export function impactFigure(parent: Group) {
  const shown = runs.filter(({ losses }) => losses.length > 0);
  if (shown.length === 0) {
    element(parent, 'p', 'The trajectories shown have no impacts.', { class: 'quiet' });
    return;
  }
  const losses = shown.flatMap((run) => run.losses.map((loss) => ({ ...loss, run })));
  const dots = shown.map((run) => {
    const all = count(run.lossTotal, 'impact');
    return `${single ? '' : `${run.label}: `}dots are ${number(run.losses.length)} of ${all} of the rocks shown`;
  });
  const place = placeIn(shown);
  let isByPlace = false;
  const made = figure(parent, {
    title: 'Total kinetic energy lost at each impact on the ground',
    label: 'Total kinetic energy lost at each impact against its number or position',
    width: drawing.wide,
    caption:
      `${startOfSentence(dots.join('; '))}; the line is the mean over all recorded rocks that had that impact. ` +
      'The loss is the total kinetic energy on arrival minus that on departure.',
    draw: (svg, width) => drawLosses(svg, width, shown, losses, isByPlace ? place : null),
    rows: () => [
      ['run', 'rock', 'impact', 'x_m', 'travelled_on_plan_m', 'total_kinetic_lost_kJ', 'total_kinetic_before_kJ'],
      ...losses.map(({ run, rock, impact, x, travelled, lost, kinetic_before }) => [
        ...[run.label, rock, impact, x, travelled],
        ...[kJ(lost), kJ(kinetic_before)],
      ]),
    ],
  });
  const select: Group = made.head.insert('label', '.save').text('against ').append('select');
  element(select, 'option', 'number of the impact', { value: 'impact' });
  element(select, 'option', place.text, { value: 'place' });
  select.on('change', () => {
    isByPlace = select.property('value') === 'place';
    made.redraw();
  });
}
