// Lines of facts below a heading.

import type { Group } from '../figures/plot';
import { element } from './figure';

/// A label and its value.
export type Fact = readonly [label: string, value: string];

/// A run with its colour on the page.
interface Named {
  label: string;
  colour: string;
}

export function factsLine(parent: Group, facts: readonly Fact[], run: Named | null = null) {
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
