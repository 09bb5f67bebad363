// The maps that a run may have, in the order of the page.

export interface MapKind {
  /// Of its file.
  name: string;
  title: string;
  quantity: string;
  /// That of the data.
  unit: string;
}

// Of a quantity the 95th percentile is shown, or the maximum if the run has no such map.
const quantities = [
  { name: 'bounce_height', ending: 'm', title: 'bounce height', of: 'Bounce height of the lowest point', unit: 'm' },
  { name: 'energy_total', ending: 'kJ', title: 'total kinetic energy', of: 'Total kinetic energy', unit: 'kJ' },
  { name: 'velocity', ending: 'm_s', title: 'velocity', of: 'Velocity', unit: 'm/s' },
];
const parts = [
  { part: 'p95', titleOf: (what: string) => `95 % ${what}`, of: '95 %' },
  { part: 'max', titleOf: (what: string) => `Maximum ${what}`, of: 'maximum' },
];

// A map, and the ends of its range between ensembles.
function withEnds(nameOf: (end: '' | 'low' | 'high') => string, kind: Omit<MapKind, 'name'>): MapKind[] {
  const end = (word: 'low' | 'high', side: string) => ({
    ...kind,
    name: nameOf(word),
    title: `${kind.title}: ${word} end of the range between ensembles`,
    quantity: `${kind.title}; 5 % of the ensembles are ${side}`,
  });
  return [{ ...kind, name: nameOf('') }, end('low', 'below'), end('high', 'above')];
}

const reach = { title: 'Reach probability', quantity: 'Share of all rocks that reach the cell', unit: 'share' };

export const mapKinds: readonly MapKind[] = [
  ...quantities.flatMap(({ name, ending, title, of: quantity, unit }) =>
    parts.flatMap(({ part, titleOf, of }) =>
      withEnds((end) => [name, part, ...(end ? [end] : []), ending].join('_'), {
        title: titleOf(title),
        quantity: `${quantity}, ${of}`,
        unit,
      }),
    ),
  ),
  ...withEnds((end) => ['reach_share', ...(end ? [end] : [])].join('_'), reach),
  {
    name: 'reach_share_parameter_part',
    title: 'Part of the parameters in the reach probability',
    quantity: 'Part of its variance between ensembles',
    unit: 'share',
  },
];
