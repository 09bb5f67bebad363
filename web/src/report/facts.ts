// What the page says of its runs below the heading.

import type { Group } from '../figures/plot';
import { rockModels } from '../figures/rockModels';
import { factsLine, knownFacts } from './factsLine';
import { element } from './figure';
import { isNumber, number } from './format';
import { runs, single, tableOf } from './run';
import { terrainFile } from './terrain';

// How far the answer may depend on the model that the facts name.
function modelNote(parent: Group) {
  const note = element(parent, 'p', 'With another rock model, runout, energy and height may be several times larger or smaller: ', { class: 'quiet' });
  element(note, 'code', 'talus compare PROJECT.toml --models');
  element(note, 'span', ' shows by how much (page “Which model?”).');
}

export function factsList(parent: Group) {
  for (const run of runs) {
    const { rocks, talus, seed } = run.summary;
    const model = rockModels[String(tableOf(run, 'analysis').model)];
    const facts = knownFacts([
      ['', run.date],
      ['Rock model ', model && `${model}, ${run.isSection ? '2D' : '3D'}`],
      ['Rocks ', isNumber(rocks?.done) && number(rocks.done)],
      ['Terrain ', terrainFile(run)],
      ['Seed ', seed === undefined ? null : String(seed)],
      ['Talus ', talus?.version],
      ['Folder ', run.folder],
    ]);
    factsLine(parent, facts, single ? null : run);
  }
  modelNote(parent);
}
