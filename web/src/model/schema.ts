// What a form needs to know of each setting, read from the schema that the engine gives of its project file.

export interface Range {
  least?: number;
  most?: number;
  leastExcluded?: boolean;
  mostExcluded?: boolean;
}

/// The form of a value in the file.
export type Kind =
  | { kind: 'number' | 'whole'; range: Range }
  | { kind: 'boolean' | 'text' | 'file' }
  | { kind: 'choice'; words: string[] }
  | { kind: 'distribution'; range: Range; parts: Field[] }
  /// One of a few words, or a number.
  | { kind: 'word or number'; words: string[]; whole: boolean; range: Range }
  | { kind: 'list'; of: 'number' | 'whole' | 'text' }
  /// A point or a vector of so many numbers; some may be words, such as "surface".
  | { kind: 'tuple'; least: number; most: number; words: string[] }
  /// Rows of such tuples.
  | { kind: 'rows'; least: number; columns: number; whole: boolean; words: string[] }
  | { kind: 'lists of rows'; columns: number }
  /// x in 2D, points on plan in 3D.
  | { kind: 'line' }
  /// What something in a file is called here: keys and texts.
  | { kind: 'names'; whole: boolean };

export interface Field {
  key: string;
  title: string;
  unit: string;
  type: Kind;
  description: string;
  source: string;
  required: boolean;
  /// As in the file; undefined: there is none that could be written.
  default?: unknown;
  /// What holds where the key is absent and no default says it.
  withoutIt: string;
  /// `inf` is a value.
  infinite: boolean;
  excludes: string[];
}

export interface Table {
  key: string;
  repeated: boolean;
  description: string;
  fields: Field[];
}

interface Node {
  type?: string;
  enum?: string[];
  const?: string;
  anyOf?: Node[];
  items?: Node;
  minItems?: number;
  maxItems?: number;
  minimum?: number;
  maximum?: number;
  exclusiveMinimum?: number;
  exclusiveMaximum?: number;
  properties?: Record<string, Node>;
  propertyNames?: { pattern?: string };
  required?: string[];
  description?: string;
  default?: unknown;
  'x-unit'?: string;
  'x-without-it'?: string;
  'x-source'?: string;
  'x-file'?: boolean;
  'x-infinite'?: boolean;
  'x-excludes'?: string[];
}

const rangeOf = (node: Node): Range => ({
  least: node.minimum ?? node.exclusiveMinimum,
  most: node.maximum ?? node.exclusiveMaximum,
  leastExcluded: node.exclusiveMinimum !== undefined,
  mostExcluded: node.exclusiveMaximum !== undefined,
});

const wordsOf = (node: Node): string[] => node.enum ?? (node.const !== undefined ? [node.const] : []);

function alternatives(nodes: Node[]): Kind {
  const number = nodes.find(({ type }) => type === 'number' || type === 'integer');
  const parts = nodes.find(({ properties }) => properties?.distribution);
  if (number && parts) return { kind: 'distribution', range: rangeOf(number), parts: fieldsOf(parts) };
  if (nodes.some(({ type }) => type === 'array')) return { kind: 'line' };
  return {
    kind: 'word or number',
    words: nodes.flatMap(wordsOf),
    whole: number?.type === 'integer',
    range: number ? rangeOf(number) : {},
  };
}

function arrayOf(node: Node): Kind {
  const item = node.items ?? {};
  if (item.type === 'array') {
    const inner = item.items ?? {};
    if (inner.type === 'array') return { kind: 'lists of rows', columns: inner.maxItems ?? 3 };
    return {
      kind: 'rows',
      least: item.minItems ?? 1,
      columns: item.maxItems ?? 3,
      whole: inner.type === 'integer',
      words: (inner.anyOf ?? []).flatMap(wordsOf),
    };
  }
  if (node.maxItems !== undefined)
    return {
      kind: 'tuple',
      least: node.minItems ?? 1,
      most: node.maxItems,
      words: (item.anyOf ?? []).flatMap(wordsOf),
    };
  return { kind: 'list', of: item.type === 'string' ? 'text' : item.type === 'integer' ? 'whole' : 'number' };
}

function kindOf(node: Node): Kind {
  if (node.anyOf) return alternatives(node.anyOf);
  if (node.enum) return { kind: 'choice', words: node.enum };
  switch (node.type) {
    case 'number':
      return { kind: 'number', range: rangeOf(node) };
    case 'integer':
      return { kind: 'whole', range: rangeOf(node) };
    case 'boolean':
      return { kind: 'boolean' };
    case 'array':
      return arrayOf(node);
    case 'object':
      return { kind: 'names', whole: node.propertyNames?.pattern !== undefined };
    default:
      return { kind: node['x-file'] ? 'file' : 'text' };
  }
}

function fieldsOf(table: Node, name = ''): Field[] {
  return Object.entries(table.properties ?? {}).map(([key, node]) => ({
    key,
    title: titleOf(key, node['x-unit'] ?? '', name),
    unit: unitText(node['x-unit'] ?? ''),
    type: kindOf(node),
    description: node.description ?? '',
    source: node['x-source'] ?? '',
    required: table.required?.includes(key) ?? false,
    default: node.default,
    withoutIt: node['x-without-it'] ?? '',
    infinite: node['x-infinite'] ?? false,
    excludes: node['x-excludes'] ?? [],
  }));
}

/// Every table of the project file; the one without a key is what stands before the first.
export function tablesOf(schema: unknown): Table[] {
  const root = schema as Node;
  const isTable = (node: Node) => node.properties !== undefined || node.items?.properties !== undefined;
  const entries = Object.entries(root.properties ?? {});
  const before = Object.fromEntries(entries.filter(([, node]) => !isTable(node)));
  return [
    {
      key: '',
      repeated: false,
      description: root.description ?? '',
      fields: fieldsOf({ ...root, properties: before }),
    },
    ...entries
      .filter(([, node]) => isTable(node))
      .map(([key, node]) => {
        const table = node.items ?? node;
        return {
          key,
          repeated: node.items !== undefined,
          description: table.description ?? '',
          fields: fieldsOf(table, key),
        };
      }),
  ];
}

// Where the key alone would read badly; of one table, or of all.
const titles: Record<string, string> = {
  'design.lines': 'Candidate lines',
  'seeder.lines': 'Lines of a file',
  'seeder.points': 'Points of a line',
  'seeder.polygon': 'Polygon',
  'seeder.polygons': 'Polygons of a file',
  'terrain.boundary': 'Boundary of the survey',
  'terrain.lines': 'Contours and breaklines',
  'terrain.points': 'Surveyed points',
  crs: 'Coordinate system',
  geopackage: 'Rocks in the GeoPackage',
  like: 'Values of the library',
  max_edge_m: 'Longest edge',
  max_slope_deg: 'Steepest slope',
  max_steps: 'Most steps',
  max_time_s: 'Longest time',
  max_timestep_s: 'Time step',
  min_slope_deg: 'Gentlest slope',
  model: 'Rock model',
  paths: 'Rocks with paths',
  place: 'Place in the cell',
  raster_cell_m: 'Cell of the maps',
  rel_max: 'Relative maximum',
  rel_min: 'Relative minimum',
  rn_mass_scale_kg: 'Mass scale of Rn',
  rn_velocity_scale_m_s: 'Velocity scale of Rn',
  scale_rn_by_mass: 'Scale Rn by mass',
  scale_rn_by_velocity: 'Scale Rn by velocity',
  section_std_dev_m: 'Standard deviations of the vertices',
  std_dev: 'Standard deviation',
  tangential_crsp_damping: 'Tangential CRSP damping',
  vtk: 'Paths for ParaView',
};

/// "Normal restitution" of normal_restitution, "Forest height" of forest_height_m: the key without its unit.
export function titleOf(key: string, unit = '', table = ''): string {
  const given = titles[`${table}.${key}`] ?? titles[key];
  if (given) return given;
  const ending = `_${unit.replace('1/', 'per_').replaceAll('/', '_')}`;
  const bare = unit && key.endsWith(ending) ? key.slice(0, -ending.length) : key;
  return `${bare.charAt(0).toUpperCase()}${bare.slice(1).replaceAll('_', ' ')}`;
}

/// "m/s²" of m/s2, "°" of deg.
export function unitText(unit: string): string {
  return unit
    .replace('deg', '°')
    .replace(/([a-z])2\b/, '$1²')
    .replace(/([a-z])3\b/, '$1³');
}

/// A word of the file for people: "lumped mass".
export const wordText = (word: string) => word.replaceAll('_', ' ');

/// "0 to 1", "more than 0", "0 or more"; nothing where every number will do.
export function rangeText({ least, most, leastExcluded, mostExcluded }: Range): string {
  const low = leastExcluded ? `more than ${least}` : `${least} or more`;
  const high = mostExcluded ? `less than ${most}` : `at most ${most}`;
  if (least !== undefined && most !== undefined)
    return leastExcluded || mostExcluded ? `${low}, ${high}` : `${least} to ${most}`;
  return least !== undefined ? low : most !== undefined ? high : '';
}

/// A default for people: "0.35", "yes", "1, 0, 0".
export function valueText(value: unknown): string {
  if (value === undefined) return '';
  if (typeof value === 'boolean') return value ? 'yes' : 'no';
  if (typeof value === 'string') return wordText(value);
  if (Array.isArray(value)) return value.map(valueText).join(', ');
  if (typeof value === 'object' && value !== null && 'mean' in value) {
    const { mean, distribution } = value as { mean: unknown; distribution?: string };
    return distribution && distribution !== 'none' ? `${valueText(mean)}, ${distribution}` : valueText(mean);
  }
  return value === Infinity ? 'unlimited' : String(value);
}

/// What holds where nothing is given: "default 0.35", "without it: the terrain's lowest point".
export function absentText(field: Field): string {
  if (field.default !== undefined) return `default ${valueText(field.default)}`;
  if (field.required) return 'required';
  if (field.withoutIt) return field.withoutIt.replaceAll('`', '');
  return field.infinite ? 'default unlimited' : '';
}
