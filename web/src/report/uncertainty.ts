// Figures of a run with uncertain parameters: the range between ensembles, and the parts of rocks and of parameters.

import * as d3 from '../figures/d3';
import * as figures from '../figures/report';
import { axes, legend, sign, tip } from '../figures/report';
import { figureTitle, figureUnit } from './convergence';
import { drawing, element, figure } from './figure';
import { count, measured, number } from './format';
import { runs, single } from './run';
import { table } from './tables';

function uncertaintyTable(parent, run) {
  const {figures: all, confidence, ensembles} = run.uncertainty;
  table(parent, {
    caption: `Figures with their ${number(100 * confidence)} % ranges over ${count(ensembles, 'ensemble')}${single ? '' : ` · ${run.label}`}`,
    head: [['Figure', 'All rocks', 'Range between ensembles', 'Of the parameters alone', 'Of the rocks alone', 'Part of the parameters']],
    rows: all.map((each) => {
      const {unit, per} = figureUnit(each), range = ([, low, high]) => `${measured(low / per, 4)} to ${measured(high / per, 4)}`;
      return [figureTitle(each), `${measured(each.total[0] / per, 4)} ${unit}`, range(each.total), each.parameter_share > 0 ? range(each.parameters) : '–', range(each.rocks),
        `${number(Math.round(100 * each.parameter_share))} %`];
    }),
    numeric: (column) => column > 0,
  });
}

// Which part of each figure's variance between ensembles is due to the parameters, and which to the rocks.
function uncertaintyFigure(parent, run) {
  const shown = run.uncertainty.figures;
  const title = single ? 'Parts of the uncertainty' : `Parts of the uncertainty · ${run.label}`;
  figure(parent, {
    title, label: 'Parts of parameters and of rocks in the variance of each figure between ensembles', caption: '', width: drawing.wide,
    draw(svg, width) {
      const letter = 6.4, names = Math.min(0.5 * width, letter * Math.max(...shown.map((each) => figureTitle(each).length)));
      const left = 24 + names, right = width - 14, top = 30, each = 24;
      const x = d3.scaleLinear().domain([0, 100]).range([left, right]);
      const bottom = top + each * shown.length;
      axes(svg, x, null, {left, right, top, bottom}, {xLabel: 'Part of the variance between ensembles [%]', yLabel: ''});
      shown.forEach((one, k) => {
        const g = svg.append('g'), y = top + each * k + 4, share = 100 * one.parameter_share;
        g.append('text').attr('x', left - 10).attr('y', y + 12).attr('text-anchor', 'end').text(figures.shortened(figureTitle(one), names));
        g.append('rect').attr('class', 'bar').style('--run', 'var(--m3)').attr('x', left).attr('width', x(share) - left).attr('y', y).attr('height', each - 8);
        g.append('rect').attr('class', 'bar').style('--run', 'var(--m1)').attr('x', x(share)).attr('width', right - x(share)).attr('y', y).attr('height', each - 8);
        tip(g, () => `${figureTitle(one)}\nparameters ${number(Math.round(share))} %, rocks ${number(Math.round(100 - share))} %`);
      });
      legend(svg, [{text: 'parameters', draw: sign.box('bar', 'var(--m3)')}, {text: 'rocks', draw: sign.box('bar', 'var(--m1)')}], left, 12, right);
      return bottom + 44;
    },
    rows: () => [['figure', 'parameters', 'rocks'], ...shown.map((one) => [figureTitle(one), one.parameter_share, 1 - one.parameter_share])],
  });
}

export function uncertaintySections(parent) {
  for (const run of runs.filter((each) => each.uncertainty.figures.length)) {
    const rocks = Math.round((run.summary.rocks.planned || 0) / run.uncertainty.ensembles);
    element(parent, 'p', `The rocks of this run belong to ${count(run.uncertainty.ensembles, 'ensemble')} of about ${count(rocks, 'rock')}, each with parameters drawn from ${(run.project.sampling || {}).parameters}. All other sections of this page are of all rocks together, but for maps and curves of a range between ensembles: their percentiles contain the uncertainty of the parameters. The table below is also in uncertainty.csv.`);
    uncertaintyTable(parent, run);
    uncertaintyFigure(parent, run);
  }
  element(parent, 'p', 'The range between ensembles contains both parts: that of the parameters, which more knowledge of the site would lessen, and that of the rocks, which is the chance in an ensemble of so many rocks. Variances add up (law of total variance); ranges do not. A dash: the ensembles differ by no more than chance.', {class: 'quiet'});
}
