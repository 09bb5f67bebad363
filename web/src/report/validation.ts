// The page of a field experiment: each site predicted from the others, by each model.

import { bareWarning } from '../archive/bareWarning';
import type { Experiment, Prediction } from '../archive/validation';
import { predictedShareRows, predictedShares } from '../figures/bands';
import { titleOf, type Group } from '../figures/plot';
import { runRangeRows, runRanges } from '../figures/runRanges';
import { stopRows, stopsOnPlan, stopsTall } from '../figures/stopsOnPlan';
import { fixedText } from '../units/numbers';
import { titled } from '../settings/titles';
import { embedded } from './data';
import { drawing, element, figure, nameFigures } from './figure';
import { number } from './format';
import { section, showStudy } from './studyPage';
import { table } from './tables';

const page = embedded<Experiment>();

const m = (metres: number | null) => (metres === null ? '–' : fixedText(metres, 1));
const within = (count: number, runs: number, least: number, most: number) => `${count} of ${runs} (${least} to ${most})`;
const isNumeric = (from: number) => (column: number) => column >= from;

function results(parent: Group) {
  table(parent, {
    caption: 'Runouts, observed and predicted from the other runs [m]',
    head: [['Model', 'Predicted', 'Observed', 'Predicted', '90 % of the mean', '90 % of the spread', 'Runs in their 50 %', 'Runs in their 90 %']],
    rows: page.results.map((row) => [
      row.model,
      row.predicted,
      `${m(row.observed_mean_m)} ± ${m(row.observed_std_dev_m)}`,
      `${m(row.mean_m)} ± ${m(row.std_dev_m)}`,
      `${m(row.mean_p05_m)} to ${m(row.mean_p95_m)}`,
      `${m(row.std_dev_p05_m)} to ${m(row.std_dev_p95_m)}`,
      within(row.in_50, row.runs, row.in_50_least, row.in_50_most),
      within(row.in_90, row.runs, row.in_90_least, row.in_90_most),
    ]),
    numeric: isNumeric(2),
  });
  const text =
    'Mean ± standard deviation over the runs. The ranges of mean and spread hold 90 % of repetitions of all runs, each with one set of parameters. In brackets: the number of runs expected in 95 % of cases if the intervals hold what they claim.';
  element(parent, 'p', text, { class: 'quiet' });
}

function scores(parent: Group) {
  table(parent, {
    caption: 'Errors beside those of a constant [m]; lower is better',
    head: [
      [
        { text: '', span: 2 },
        { text: 'Score of the runout', span: 3 },
        { text: 'Score of the place', span: 3 },
        { text: 'RMS error', span: 2 },
        { text: 'Mean error', span: 2 },
      ],
      ['Model', 'Predicted', 'posterior', 'prior', 'constant', 'posterior', 'prior', 'constant', 'run', 'constant', 'run', 'constant'],
    ],
    rows: page.results.map((row) => [
      row.model,
      row.predicted,
      ...[row.crps_m, row.crps_prior_m, row.crps_constant_m, row.place_m, row.place_prior_m, row.place_constant_m].map(m),
      ...[row.rmse_m, row.rmse_constant_m, row.mae_m, row.mae_constant_m].map(m),
    ]),
    numeric: isNumeric(2),
  });
  const text =
    'Runout: mean continuous ranked probability score. Place: mean energy score of the stop on plan. Constant: the runouts, or the stops, of the runs that were calibrated on, as the forecast for every run; for the errors of single runs, their mean or median. Errors of single runs are those of the mean (root mean square, RMS) and of the median (mean magnitude) of what was predicted for each run from its own release.';
  element(parent, 'p', text, { class: 'quiet' });
}

function groups(parent: Group) {
  if (page.groups.length === 0) return;
  table(parent, {
    caption: 'By group: mean runouts, and root mean square errors of single runs [m]',
    head: [['Group', 'Model', 'Runs', 'Observed', 'Predicted', 'Error', 'Error of a constant']],
    rows: page.groups.map((row) => [
      row.group,
      row.model,
      number(row.runs),
      ...[row.observed_mean_m, row.mean_m, row.rmse_m, row.rmse_constant_m].map(m),
    ]),
    numeric: isNumeric(2),
  });
}

function published(parent: Group) {
  if (page.published.length === 0) return;
  table(parent, {
    caption: 'Other programs on this experiment: mean runouts [m]',
    head: [['Program', 'Observed', 'Predicted', 'Difference', 'Mean error of a run', 'Source']],
    rows: page.published.map((each) => {
      const difference = each.predicted_mean_m - each.observed_mean_m;
      return [
        each.name,
        m(each.observed_mean_m),
        m(each.predicted_mean_m),
        `${difference > 0 ? '+' : ''}${m(difference)}`,
        m(each.mean_abs_error_m),
        each.source,
      ];
    }),
    numeric: (column) => column > 0 && column < 5,
  });
}

function prediction(parent: Group, of: Prediction) {
  const { site, from, runs, plan, mean_of_the_others: others } = of;
  element(parent, 'h3', `${site}, from ${from}`);
  const box = element(parent, 'div', null, { class: 'columns' });
  const ranges = { runs, others, unit: 'm', per: 1 };
  figure(box, {
    title: `Runs of ${site}`,
    label: `Observed runouts of ${runs.length} runs, and the ranges predicted for them`,
    caption: 'Predicted for each run from its own release.',
    tall: 300,
    fill: (node, room) => runRanges(node, room, ranges),
    rows: () => runRangeRows(ranges),
  });
  const shares = { title: 'Runout', unit: 'm', ...of.distribution, prior: null };
  figure(box, {
    title: `Runouts of ${site}`,
    label: 'Distribution of the runouts: observed, and the band that is predicted',
    caption: '90 % of repetitions of all runs lie within the band.',
    tall: 300,
    fill: (node, room) => predictedShares(node, room, shares),
    rows: () => predictedShareRows(shares),
  });
  figure(box, {
    title: `${site} on plan`,
    label: 'Releases, observed stops and predicted stops on plan',
    caption: `${number(plan.predicted.length)} predicted stops are drawn.`,
    tall: stopsTall(plan, drawing.half),
    fill: (node, room) => stopsOnPlan(node, room, plan),
    rows: () => stopRows(plan),
  });
  const facts = element(box, 'div');
  table(facts, {
    caption: 'Parameters; ranges hold 90 %',
    head: [['Parameter', 'Prior', 'Posterior', 'Median']],
    rows: of.parameters.map(titled).map(({ name, title, unit, prior, posterior }) => [
      { text: titleOf({ title, unit }), full: name },
      `${number(prior.p05, 4)} to ${number(prior.p95, 4)}`,
      `${number(posterior.p05, 4)} to ${number(posterior.p95, 4)}`,
      number(posterior.p50, 4),
    ]),
    numeric: isNumeric(1),
  });
  for (const warning of of.warnings) element(facts, 'p', bareWarning(warning), { class: 'note' });
}

function list(parent: Group, title: string, texts: readonly string[]) {
  if (texts.length === 0) return;
  element(parent, 'h4', title);
  const items = element(parent, 'ul');
  for (const text of texts) element(items, 'li', text);
}

nameFigures('');
showStudy({
  kind: 'Validation',
  title: page.title,
  facts: [['Talus ', page.talus]],
  version: page.talus,
  warnings: [],
  show: (main) => {
    element(main, 'p', page.summary);
    for (const limit of page.limits) element(main, 'p', limit, { class: 'note' });
    section(main, 'Results', 'results', (node) => [results, scores, groups, published].forEach((part) => part(node)));
    for (const model of new Set(page.predictions.map((each) => each.model))) {
      const shown = page.predictions.filter((each) => each.model === model);
      section(main, model, model.replace(/[^A-Za-z0-9]+/g, '-'), (node) => shown.forEach((each) => prediction(node, each)));
    }
    section(main, 'How it was done', 'method', (node) => {
      element(node, 'p', page.split);
      list(node, 'Sought', page.sought);
      list(node, 'Not sought', page.not_sought);
      list(node, 'Data', page.citations);
      element(node, 'p', `Licence: ${page.licence}`);
    });
  },
});
