// Lines of facts below a heading.

import type { Group } from '../figures/plot';
import { element } from './figure';
import { isNumber, number } from './format';
import { runs, single, tableOf, type Run } from './run';
import { terrainFile } from './terrain';

/// A label and its value.
export type Fact = readonly [label: string, value: string];

export function factsLine(parent: Group, facts: readonly Fact[], run: Run | null = null) {
  const line = element(parent, 'p', null, { class: 'facts' });
  if (run) {
    element(line, 'span', run.label, { class: 'run-name' }).style('--run', run.colour);
    element(line, 'span', '   ');
  }
  facts.forEach(([label, value], k) => {
    element(line, 'span', (k > 0 ? '  ·  ' : '') + label);
    element(line, 'b', value);
  });
}

/// Those that have a value.
export const knownFacts = (facts: readonly (readonly [string, string | null | undefined | false])[]): Fact[] =>
  facts.flatMap(([label, value]) => (value ? [[label, value] as const] : []));

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
