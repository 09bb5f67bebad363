// What the page says of its runs below the heading.

import type { Group } from '../figures/plot';
import { factsLine, knownFacts } from './factsLine';
import { isNumber, number } from './format';
import { runs, single, tableOf } from './run';
import { terrainFile } from './terrain';

const modelWords: Record<string, string> = { lumped_mass: 'lumped mass', rigid_sphere: 'rigid sphere', rigid_body: 'rigid body' };

export function factsList(parent: Group) {
  for (const run of runs) {
    const { rocks, talus, seed } = run.summary;
    const model = modelWords[String(tableOf(run, 'analysis').model)];
    const facts = knownFacts([
      ['', run.date],
      ['Model ', model && `${model}, ${run.isSection ? '2D' : '3D'}`],
      ['Rocks ', isNumber(rocks?.done) && number(rocks.done)],
      ['Terrain ', terrainFile(run)],
      ['Seed ', seed === undefined ? null : String(seed)],
      ['Talus ', talus?.version],
      ['Folder ', run.folder],
    ]);
    factsLine(parent, facts, single ? null : run);
  }
}
