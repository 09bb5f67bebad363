// The page of a calibration: what is known of each parameter, and how well it predicts the observations.

import type { CalibratedFeature, CalibratedGroup, CalibratedZone, CalibrationSummary, ShareRange } from '../archive/calibration';
import { bareWarning } from '../archive/bareWarning';
import { parameterPairs, parameterShareRows, parameterShares, predictedShareRows, predictedShares } from '../figures/bands';
import { titleOf, type Group } from '../figures/plot';
import { zoneShareRows, zoneShares, zoneSharesTall } from '../figures/zoneShares';
import { titled } from '../settings/titles';
import { drawing, element, figure, nameFigures } from './figure';
import { count, number } from './format';
import { embedded } from './data';
import { section, showStudy } from './studyPage';
import { table, type Row } from './tables';

/// The summary, and the sets that matter in the posterior: of each its weight, then its values.
const page = embedded<CalibrationSummary & { posterior_sets: number[][] }>();
const { observations, best } = page;
const parameters = page.parameters.map(titled);
const hasPosterior = page.effective_sets > 0;
const mostInPairs = 6; // parameters

const text = (value: number | null | undefined, digits = 4) => number(value, digits);
const percent = (share: number) => number(Math.round(1000 * share) / 10);
const spreadText = (mean: number, spread: number | null | undefined, unit: string) =>
  `${text(mean)} ± ${text(spread, 3)}${unit && ` ${unit}`}`;

function introduction(main: Group) {
  const observed = observations.reduce((sum, group) => sum + group.count, 0);
  const sites = new Set(observations.map(({ site }) => site)).size;
  const chosen = `${count(parameters.length, 'parameter')}, ${count(observed, 'observation')} at ${count(sites, 'site')}, ${count(page.sets, 'set')} of ${count(page.rocks_per_set, 'rock')}.`;
  const agree = `${count(page.agreeing_sets, 'set is', 'sets are')} as near to the observations as chance alone gives.`;
  const accurate = hasPosterior
    ? `The posterior is as accurate as ${count(Math.round(page.effective_sets), 'independent set')}.`
    : 'There is no posterior.';
  element(main, 'p', `${chosen} ${agree} ${accurate}`);
}

function parameterTable(parent: Group) {
  table(parent, {
    caption: 'Ranges hold 90 %',
    head: [['Parameter', 'Prior', 'Posterior', 'Median', 'Best set', 'Width, posterior / prior', '']],
    rows: parameters.map((parameter) => {
      const { name, prior, posterior, width_of_prior: width, learned_nothing: nothing } = parameter;
      return [
        { text: titleOf(parameter), full: name },
        `${text(prior.p05)} to ${text(prior.p95)}`,
        posterior ? `${text(posterior.p05)} to ${text(posterior.p95)}` : '–',
        text(posterior?.p50),
        text(best.values[name]),
        text(width, 2),
        nothing ? 'the data say nothing about this one' : '',
      ];
    }),
    numeric: (column) => column > 0 && column < 6,
  });
  if (best.note) element(parent, 'p', `${best.note}.`);
}

function parameterFigures(parent: Group) {
  const box = element(parent, 'div', null, { class: 'columns' });
  for (const { name, title, unit, histogram, posterior } of parameters) {
    if (!histogram || !posterior) continue;
    const { p05, p50, p95 } = posterior;
    const value = best.values[name] ?? p50;
    const shown = { title, unit, ...histogram, quantiles: [p05, p50, p95] as const, best: value };
    figure(box, {
      title: shown.title,
      label: `Prior and posterior of ${shown.title}`,
      caption: `Posterior: median ${text(p50)}, 90 % from ${text(p05)} to ${text(p95)}${unit && ` ${unit}`}.`,
      tall: 260,
      fill: (node, room) => parameterShares(node, room, shown),
      rows: () => parameterShareRows(shown),
    });
  }
}

function pairs(parent: Group) {
  table(parent, {
    caption: 'Correlations in the posterior',
    head: [['', ...parameters.map((_, k) => String(k + 1))]],
    rows: parameters.map(({ title }, a) => [
      `${a + 1} ${title}`,
      ...parameters.map((_, b) => text(page.correlations?.[a]?.[b], 2).replace('–', '')),
    ]),
    numeric: (column) => column > 0,
  });
  const box = element(parent, 'div', null, { class: 'columns' });
  const shown = parameters.slice(0, mostInPairs);
  shown.forEach((y, b) =>
    shown.slice(0, b).forEach((x, a) => {
      const sets = page.posterior_sets.map(([weight = 0, ...values]) => ({ weight, x: values[a] ?? 0, y: values[b] ?? 0 }));
      figure(box, {
        title: `${x.title}, and ${y.title}`,
        label: `Sets of the posterior by ${x.title} and ${y.title}`,
        caption: 'Each dot is a set of the posterior; its area is its weight.',
        tall: 300,
        fill: (node, room) => parameterPairs(node, room, { x, y, sets }),
        rows: () => [[x.name, y.name, 'weight'], ...sets.map((set) => [set.x, set.y, set.weight])],
      });
    }),
  );
}

const placeOf = ({ site, name }: CalibratedGroup) => (new Set(observations.map((each) => each.site)).size > 1 ? `${site}, ${name}` : name);

// How near the best set comes to the observations.
const distanceText = ({ distance = 'energy distance', best_distance: reached, threshold }: CalibratedGroup) =>
  `${distance.charAt(0).toUpperCase()}${distance.slice(1)} of the best set ${text(reached, 3)}; chance alone gives up to ${text(threshold, 3)}.`;

function distribution(parent: Group, group: CalibratedGroup, feature: CalibratedFeature) {
  const { name, unit, distribution: of } = feature;
  if (!of || of.at.length === 0) return;
  const shown = { title: `${name.charAt(0).toUpperCase()}${name.slice(1)}`, unit, ...of };
  const observed = spreadText(feature.observed_mean, feature.observed_std_dev, unit);
  const predicted = spreadText(feature.predicted_mean ?? 0, feature.predicted_std_dev, unit);
  figure(parent, {
    title: `${shown.title}, ${placeOf(group)}`,
    label: `Distribution of ${name}: observed, and the bands that prior and posterior predict`,
    caption: `Observed ${observed}, predicted ${predicted} (mean and standard deviation). ${distanceText(group)}`,
    tall: 300,
    fill: (node, room) => predictedShares(node, room, shown),
    rows: () => predictedShareRows(shown),
  });
}

const unitOfDeposits = (unit: string) => (unit === 'm3' ? 'm³' : unit);
const rangeCell = (range: ShareRange | undefined) =>
  range ? { text: percent(range.p50), below: `${percent(range.p05)} to ${percent(range.p95)}` } : '–';

function depositsText({ deposits }: CalibratedGroup): string {
  if (!deposits) return '';
  const { unit, in_zones: held, released, elsewhere_observed: isAll, independent_rocks: rocks } = deposits;
  const shown = unitOfDeposits(unit);
  const where =
    released !== null && held !== null
      ? `The zones hold ${text(held)} of the ${text(released)} ${shown} that were released (${percent(held / released)} %). `
      : isAll
        ? ''
        : 'Shares are of what the zones hold: what came to rest outside was not observed. ';
  return `${where}The observation counts as ${text(rocks, 3)} independent rocks. `;
}

function zones(parent: Group, group: CalibratedGroup, list: readonly CalibratedZone[]) {
  const unit = unitOfDeposits(group.deposits?.unit ?? '');
  table(parent, {
    caption: `Deposits by zone, ${placeOf(group)}; below each median the range of 90 %`,
    head: [
      [
        'Zone',
        { text: 'Observed', ...(unit && { unit }) },
        { text: 'Observed share', unit: '%' },
        { text: 'Predicted', unit: '%' },
        { text: 'Prior', unit: '%' },
      ],
    ],
    rows: list.map((zone): Row => [
      zone.name,
      text(zone.observed_amount),
      percent(zone.observed_share),
      rangeCell(zone.predicted_share),
      rangeCell(zone.prior_share),
    ]),
    numeric: (column) => column > 0,
  });
  element(parent, 'p', depositsText(group) + distanceText(group));
  figure(parent, {
    title: `Deposits by zone, ${placeOf(group)}`,
    label: `Shares of deposits by zone: observed, and predicted by the posterior`,
    caption: 'Predicted: 90 % of as many rocks as were observed would lie within the range.',
    width: drawing.wide,
    tall: zoneSharesTall(list),
    fill: (node, room) => zoneShares(node, room, list),
    rows: () => zoneShareRows(list),
  });
}

function predictions(parent: Group) {
  element(parent, 'p', 'Bands: 90 % of as many rocks as were observed would lie within them, by the posterior and by the prior.', { class: 'quiet' });
  const box = element(parent, 'div', null, { class: 'columns' });
  for (const group of observations) for (const feature of group.features) distribution(box, group, feature);
  for (const group of observations) if (group.zones) zones(parent, group, group.zones);
}

function heldOut(parent: Group) {
  const all = page.held_out;
  const rocks = all.reduce((sum, { observations: n }) => sum + n, 0);
  const mean = (of: (each: (typeof all)[number]) => number | null) =>
    all.reduce<number | null>((sum, each) => (sum === null || of(each) === null ? null : sum + (each.observations * of(each)!) / rocks), 0);
  const row = (name: string, n: number, posterior: number | null, prior: number | null, constant: number | null): Row => [
    name,
    number(n),
    ...[posterior, prior, constant].map((score) => text(score, 3)),
  ];
  table(parent, {
    caption: 'Mean energy score (CRPS on a line) over the observed spread; lower is better',
    head: [['Held out', 'Observations', 'Posterior', 'Prior', 'Constant']],
    rows: [
      ...all.map((each) => row(each.name, each.observations, each.posterior, each.prior, each.constant)),
      row('all', rocks, mean((each) => each.posterior), mean((each) => each.prior), mean((each) => each.constant)),
    ],
    numeric: (column) => column > 0,
  });
  element(parent, 'p', 'Constant: the distribution of the other observations.', { class: 'quiet' });
  table(parent, {
    caption: 'Held-out observations within the central 90 % of their prediction',
    head: [['Held out', 'Quantity', 'Observations', 'Within 90 %', 'Expected']],
    rows: (page.held_out_coverage ?? []).map((each) => [
      each.observations,
      each.name,
      number(each.count),
      number(each.within_90),
      `${number(each.expected[0])} to ${number(each.expected[1])}`,
    ]),
    numeric: (column) => column > 1,
  });
  element(parent, 'p', 'Expected: in 95 % of cases, if predictions hold what they claim and observations are independent.', { class: 'quiet' });
  // Of single sites; of random parts there would be a row for each part.
  const sites = new Set(observations.map(({ site }) => site));
  const features = all.filter(({ name }) => sites.has(name)).flatMap((each) => each.features ?? []);
  if (features.length === 0) return;
  table(parent, {
    caption: 'Predicted from the other observations: mean and standard deviation',
    head: [['Held out', 'Quantity', 'Observed', 'Predicted']],
    rows: features.map((each) => [
      each.observations,
      titleOf({ title: each.name, unit: each.unit }),
      spreadText(each.observed_mean, each.observed_std_dev, ''),
      spreadText(each.predicted_mean, each.predicted_std_dev, ''),
    ]),
    numeric: (column) => column > 1,
  });
}

nameFigures(page.study);
showStudy({
  kind: 'Calibration',
  title: page.study,
  facts: [
    ['Sets ', number(page.sets)],
    ['Rocks each ', number(page.rocks_per_set)],
    ['Seed ', String(page.seed ?? '')],
    ['Talus ', page.talus],
  ],
  version: page.talus ?? '',
  warnings: page.warnings.map(bareWarning),
  show: (main) => {
    introduction(main);
    section(main, 'What is known of each parameter', 'parameters', (node) => {
      parameterTable(node);
      parameterFigures(node);
    });
    if (!hasPosterior) return;
    if (parameters.length > 1) section(main, 'Pairs of parameters', 'pairs', pairs);
    section(main, 'Observed and predicted distributions', 'predictions', predictions);
    if (page.held_out.length > 0) section(main, 'Predictions of observations that were held out', 'held-out', heldOut);
  },
});
