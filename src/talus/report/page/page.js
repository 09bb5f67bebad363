// The page, from top to bottom.

function heading() {
  const head = d3.select('#head');
  element(head, 'p', single ? 'Rockfall analysis' : 'Rockfall analysis · two runs compared', {class: 'kind'});
  element(head, 'h1', single || alike ? runs[0].name : runs.map((run) => run.name).join(' and '));
  for (const run of runs) {
    const facts = element(head, 'p', null, {class: 'facts'});
    if (!single) {
      element(facts, 'span', run.label, {class: 'run-name'}).style('--run', run.colour);
      facts.append('span').text('   ');
    }
    const model = {lumped_mass: 'lumped mass', rigid_sphere: 'rigid sphere'}[(run.project.analysis || {}).model];
    const talus = run.summary.talus || {};
    const rocks = run.summary.rocks || {};
    const parts = [
      ['', run.date], ['Model ', model && `${model}, ${run.isSection ? '2D' : '3D'}`], ['Rocks ', isNumber(rocks.done) ? number(rocks.done) : null],
      ['Terrain ', terrainFile(run)], ['Seed ', run.summary.seed === undefined ? null : String(run.summary.seed)], ['Talus ', talus.version], ['Folder ', run.folder],
    ].filter(([, value]) => value);
    parts.forEach(([words, value], i) => {
      facts.append('span').text((i ? '  ·  ' : '') + words);
      element(facts, 'b', value);
    });
  }
}

function section(title, id, fill) {
  const node = element(d3.select('#main'), 'section', null, {id, 'aria-label': title});
  element(node, 'h2', title);
  fill(node);
  element(d3.select('#contents'), 'a', title, {href: '#' + id});
}

heading();
cards(d3.select('#main'));
warnings(d3.select('#main'));
section('Slope and paths', 'slope', (node) => {
  const box = element(node, 'div', null, {class: 'columns'});
  sectionFigure(box, planFigure(box) || drawing.wide);
});
if (runs.some((run) => run.maps.length)) section('Maps', 'maps', mapFigures);
if (runs.some((run) => run.envelopes.rows.length)) section('Along the section', 'envelopes', envelopeFigures);
section('End points and runout', 'runout', (node) => {
  distributionFigures(node);
  element(node, 'p', 'Boxes: quartiles with the median; whiskers: least and greatest value; cross: mean.', {class: 'quiet'});
  statisticsTable(node, runs, [
    {text: 'End point x', unit: 'm', of: (run) => run.isSection ? run.statistics.end_x_m : null},
    {text: 'Runout on plan', unit: 'm', of: (run) => run.statistics.runout_xy_m},
    {text: 'Runout in space', unit: 'm', of: (run) => run.statistics.runout_total_m},
    {text: 'Greatest total kinetic energy', unit: 'kJ', per: 1000, of: (run) => run.statistics.max_ke_J},
    {text: 'Greatest bounce height', unit: 'm', of: (run) => run.statistics.max_bounce_m},
  ], 'Descriptive statistics, one value a rock');
  element(node, 'p', 'Standard deviation and variance are those of a sample (n − 1); kurtosis is excess kurtosis and skewness is corrected for bias; the confidence level is half the width of the 95 % interval of the mean, by Student’s t. Variances have the square of the unit. Total kinetic energy is that of translation and rotation.', {class: 'quiet'});
});
section('Why the rocks ended', 'reasons', endReasons);
if (runs.some((run) => run.barriers.length)) section('Barriers and collectors', 'barriers', barrierSections);
if (designsOf().length) section('Design of barriers', 'design', designSections);
section('Energy', 'energy', (node) => { energyFigures(node); impactFigure(node); });
section('Model', 'model', modelTables);
fitTablesToPaper();
{
  const foot = d3.select('#foot');
  const times = runs.map((run) => run.summary.timings || {}).filter((t) => isNumber(t.seconds));
  const speed = times.map((t) => `${number(t.seconds, 3)} s` + (isNumber(t.rocks_per_second) ? `, ${number(Math.round(t.rocks_per_second))} rocks/s` : '') +
    (isNumber(t.threads) ? ` on ${count(t.threads, 'thread')}` : '')).join('; ');
  element(foot, 'p', `Made by Talus ${page.version} from the files of ${runs.map((run) => run.folder).join(' and ')}.` + (speed ? ` The analysis took ${speed}.` : '') +
    ' This page needs no network. Drawn with D3 (d3js.org), copyright Mike Bostock.');
}
