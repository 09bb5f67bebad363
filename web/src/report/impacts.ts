// Total kinetic energy lost at each impact on the ground: single impacts of the trajectories shown, and the mean over all
// rocks.

import * as d3 from '../figures/d3';
import { axes, extentOf, legend, sign, tip } from '../figures/report';
import { drawing, element, figure } from './figure';
import { axisIn, count, energyText, kJ, lengthText, number, unitIn } from './format';
import { runs, single, startOfSentence, xyText } from './run';

export function impactFigure(parent) {
  const shown = runs.filter((run) => run.losses.length);
  if (!shown.length) return element(parent, 'p', 'The trajectories shown have no impacts.', {class: 'quiet'});
  let axis = 'impact';
  // The position of an impact: x along a section, the distance travelled in 3D.
  const place = shown.every((run) => run.isSection) ? {key: 'x', text: 'position (x)', label: `x of the impact [${unitIn('m')}]`} :
    {key: 'travelled', text: 'distance travelled', label: `Distance travelled on plan [${unitIn('m')}]`};
  const dotsText = shown.map((run) => `${single ? '' : run.label + ': '}dots are ${number(run.losses.length)} of ${count(run.lossTotal, 'impact')} of the rocks shown`).join('; ');
  const dots = shown.flatMap((run) => run.losses.map((loss) => ({...loss, run})));
  const highest = d3.max(shown, (run) => d3.max(run.losses, (loss) => loss.impact));
  const made = figure(parent, {
    title: 'Total kinetic energy lost at each impact on the ground', label: 'Total kinetic energy lost at each impact against its number or position', width: drawing.wide,
    caption: startOfSentence(dotsText) +
      '; the line is the mean over all recorded rocks that had that impact. The loss is the total kinetic energy on arrival minus that on departure.',
    draw(svg, width) {
      const side = {left: 78, right: width - 14, top: 12, bottom: 232};
      const placeOf = (dot) => axis === 'place' ? dot[place.key] : dot.impact + (shown.length > 1 ? (dot.run === shown[0] ? -0.12 : 0.12) : 0);
      const domain = axis === 'place' ? extentOf(dots.map(placeOf)) : [0.4, Math.max(highest, 2) + 0.6];
      const toX = d3.scaleLinear().domain(domain).range([side.left, side.right]);
      const lines = axis === 'place' ? [] : shown.map((run) => ({run, points: run.lossByNumber.filter((m) => m.impact <= highest)}));
      const toY = d3.scaleLinear().domain(extentOf([0, ...dots.map((d) => d.lost), ...lines.flatMap((l) => l.points.map((m) => m.mean))]))
        .range([side.bottom, side.top]);
      axes(svg, axis === 'place' ? axisIn('m', toX) : toX, axisIn('J', toY), side, {xLabel: axis === 'place' ? place.label : 'Number of the impact', yLabel: `Total kinetic energy lost [${unitIn('J')}]`, xTicks: axis === 'impact' ? Math.min(highest, 16) : undefined});
      tip(svg.append('g').selectAll('circle').data(dots).enter().append('circle').attr('class', 'dot').attr('r', 3).style('--run', (d) => d.run.colour)
        .attr('cx', (d) => toX(placeOf(d))).attr('cy', (d) => toY(d.lost)),
      (d) => `Rock ${d.rock}, impact ${d.impact}` + (single ? '' : ` · ${d.run.label}`) +
        `\nlost ${energyText(d.lost)} of ${energyText(d.kinetic_before)} of total kinetic energy\nat x ${xyText(d.run, d.x)}, after ${lengthText(d.travelled)} on plan`);
      for (const {run, points} of lines) {
        svg.append('path').attr('class', 'mean-line').style('stroke', single ? null : run.colour)
          .attr('d', d3.line().x((m) => toX(m.impact)).y((m) => toY(m.mean))(points));
        tip(svg.append('g').selectAll('circle').data(points).enter().append('circle').attr('r', 4).attr('class', 'mechanical stop').style('fill', single ? null : run.colour)
          .attr('cx', (m) => toX(m.impact)).attr('cy', (m) => toY(m.mean)),
        (m) => (single ? '' : run.label + '\n') + `Impact ${m.impact}: ${count(m.rocks, 'rock')}\nmean loss ${energyText(m.mean)}\nminimum ${energyText(m.least)}, maximum ${energyText(m.most)}`);
      }
      return legend(svg, [
        ...shown.map((run) => ({text: single ? 'single impact' : run.label, draw: sign.circle('dot', run.colour)})),
        ...(axis === 'impact' ? [{text: 'mean over all rocks', draw: sign.line('mean-line')}] : []),
      ], side.left, side.bottom + 56, side.right) + 12;
    },
    rows: () => [['run', 'rock', 'impact', 'x_m', 'travelled_on_plan_m', 'total_kinetic_lost_kJ', 'total_kinetic_before_kJ'], ...dots.map((d) => [d.run.label, d.rock, d.impact, d.x, d.travelled, kJ(d.lost), kJ(d.kinetic_before)])],
  });
  const select = made.head.insert('label', '.save').text('against ').append('select');
  element(select, 'option', 'number of the impact', {value: 'impact'});
  element(select, 'option', place.text, {value: 'place'});
  select.on('change', function () { axis = this.value; made.redraw(); });
}
