// Lines of facts below a heading.

import { element } from './figure';
import { isNumber, number } from './format';
import { runs, single } from './run';
import { terrainFile } from './terrain';

export function factsLine(parent, parts, run) {
  const facts = element(parent, 'p', null, {class: 'facts'});
  if (run) {
    element(facts, 'span', run.label, {class: 'run-name'}).style('--run', run.colour);
    facts.append('span').text('   ');
  }
  parts.forEach(([label, value], i) => {
    facts.append('span').text((i ? '  ·  ' : '') + label);
    element(facts, 'b', value);
  });
}

export function factsList(parent) {
  for (const run of runs) {
    const model = {lumped_mass: 'lumped mass', rigid_sphere: 'rigid sphere', rigid_body: 'rigid body'}[(run.project.analysis || {}).model];
    const talus = run.summary.talus || {};
    const rocks = run.summary.rocks || {};
    const parts = [
      ['', run.date], ['Model ', model && `${model}, ${run.isSection ? '2D' : '3D'}`], ['Rocks ', isNumber(rocks.done) ? number(rocks.done) : null],
      ['Terrain ', terrainFile(run)], ['Seed ', run.summary.seed === undefined ? null : String(run.summary.seed)], ['Talus ', talus.version], ['Folder ', run.folder],
    ].filter(([, value]) => value);
    factsLine(parent, parts, single ? null : run);
  }
}
