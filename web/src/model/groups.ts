// In which groups the settings of a table stand, and which mean something beside the others. A setting that no group
// names stands in the last one, so that none is forgotten.

import type { TomlTable } from '../toml/format';
import type { Field } from './schema';

export interface Group {
  title: string;
  keys: string[];
  /// Keys of which one is chosen, the others then being absent.
  oneOf?: string[][];
  /// Folded until it is opened, or something in it is given.
  folded?: boolean;
  /// Whether a key means anything beside the values of its table; one that is given stands there all the same.
  applies?: (key: string, row: TomlTable, is2d: boolean) => boolean;
}

const isType =
  (...types: string[]) =>
  (row: TomlTable) =>
    types.includes(String(row.type ?? 'point'));

const seederPlaces: Record<string, (row: TomlTable) => boolean> = {
  position: isType('point'),
  points: isType('line'),
  lines: isType('line'),
  polygon: isType('polygon'),
  polygons: isType('polygon'),
  layer: (row) => row.lines !== undefined || row.polygons !== undefined,
  source_attribute: (row) => row.lines !== undefined || row.polygons !== undefined,
  min_slope_deg: isType('polygon', 'raster'),
  max_slope_deg: isType('polygon', 'raster'),
  mask: isType('polygon', 'raster'),
  mask_value: (row) => row.mask !== undefined,
  cell_m: isType('polygon', 'raster'),
  place: isType('polygon', 'raster'),
  rocks_per_cell: isType('polygon', 'raster'),
};

/// Of the check that a standard prescribes for a barrier's design.
export const checkKeys = [
  'standard',
  'design_percentile',
  'trajectory_factor',
  'topography_factor',
  'volume_factor',
  'density_factor',
  'risk_factor',
  'energy_level',
  'energy_factor',
  'energy',
  'block_mass_kg',
  'upper_clearance_m',
];

const surveyKeys = ['points', 'lines'];
const terrainNeeds: Record<string, string[]> = {
  width_m: ['section'],
  point_classes: ['points'],
  points_layer: ['points'],
  lines_layer: ['lines'],
  elevation_attribute: surveyKeys,
  boundary: surveyKeys,
  boundary_layer: ['boundary'],
  max_edge_m: surveyKeys,
  remove_spikes_m: surveyKeys,
  polygons_layer: ['polygons'],
  merge_tolerance_m: ['polylines', 'polygons'],
  crs: ['mesh', 'triangles', 'polylines', 'polygons', ...surveyKeys],
};

export const terrainKinds = ['section', 'mesh', 'triangles', 'raster', 'points', 'lines', 'polylines', 'polygons'];

const groupsOf: Record<string, Group[]> = {
  analysis: [
    { title: 'Motion', keys: ['model', 'rotation', 'sliding', 'friction_angle', 'gravity_m_s2', 'energy_datum_m'] },
    {
      title: 'Restitution',
      folded: true,
      keys: [
        'scale_rn_by_velocity',
        'rn_velocity_scale_m_s',
        'scale_rn_by_mass',
        'rn_mass_scale_kg',
        'tangential_crsp_damping',
      ],
      applies: (key, row) =>
        key === 'rn_velocity_scale_m_s'
          ? row.scale_rn_by_velocity === true
          : key === 'rn_mass_scale_kg'
            ? row.scale_rn_by_mass === true
            : true,
    },
    {
      title: 'When a rock stops',
      folded: true,
      keys: [
        'normal_velocity_cutoff_m_s',
        'grazing_angle_deg',
        'stopped_velocity_m_s',
        'max_timestep_s',
        'max_steps',
        'max_time_s',
      ],
    },
  ],
  terrain: [
    {
      title: 'Surface',
      keys: [
        ...terrainKinds.slice(0, 2),
        'vertices',
        ...terrainKinds.slice(2),
        'width_m',
        ...Object.keys(terrainNeeds).filter((key) => key !== 'width_m'),
      ],
      applies: (key, row) => (terrainNeeds[key] ?? [key]).some((other) => row[other] !== undefined),
    },
    {
      title: 'Uncertain vertices',
      keys: ['section_std_dev_m'],
      folded: true,
      applies: (_key, row, is2d) => is2d && row.section !== undefined,
    },
    { title: 'Turning', folded: true, keys: ['rotate_deg', 'rotate_about'], applies: (_key, _row, is2d) => !is2d },
  ],
  material: [
    { title: '', keys: ['name', 'like'] },
    {
      title: 'Impact',
      keys: [
        'normal_restitution',
        'tangential_restitution',
        'roughness_deg',
        'roughness_spacing_m',
        'roughness_amplitude_m',
      ],
    },
    {
      title: 'Sliding and rolling',
      keys: ['friction_angle_deg', 'dynamic_friction', 'rolling_friction', 'ground_drag_per_s'],
    },
    { title: 'Forest', folded: true, keys: ['forest', 'forest_drag_kg_s', 'forest_height_m'] },
  ],
  seeder: [
    { title: '', keys: ['name', 'source'] },
    {
      title: 'Where rocks start',
      keys: [
        'type',
        'position',
        'points',
        'lines',
        'polygon',
        'polygons',
        'layer',
        'source_attribute',
        'height_above_m',
        'min_slope_deg',
        'max_slope_deg',
        'mask',
        'mask_value',
        'cell_m',
        'place',
      ],
      oneOf: [
        ['points', 'lines'],
        ['polygon', 'polygons'],
      ],
      applies: (key, row, is2d) => {
        if (is2d && ['lines', 'polygon', 'polygons'].includes(key)) return false;
        return seederPlaces[key]?.(row) ?? true;
      },
    },
    {
      title: 'How many',
      keys: ['rocks', 'rocks_per_cell'],
      oneOf: [['rocks', 'rocks_per_cell']],
      applies: (key, row) => seederPlaces[key]?.(row) ?? true,
    },
    {
      title: 'How large',
      keys: ['mass_kg', 'volume_m3', 'diameter_m', 'density_kg_m3'],
      oneOf: [['mass_kg', 'volume_m3', 'diameter_m']],
    },
    {
      title: 'How fast',
      keys: ['horizontal_velocity_m_s', 'vertical_velocity_m_s', 'speed_m_s', 'direction', 'rotational_velocity_deg_s'],
      oneOf: [['horizontal_velocity_m_s', 'speed_m_s']],
      applies: (key, row) => (key === 'vertical_velocity_m_s' ? row.speed_m_s === undefined : true),
    },
  ],
  ground: [
    { title: '', keys: ['default'] },
    {
      title: '',
      keys: ['segments', 'triangles', 'raster', 'classes', 'polygons', 'layer', 'attribute', 'values'],
      applies: (key, row) => {
        if (key === 'classes') return row.raster !== undefined;
        if (['layer', 'attribute', 'values'].includes(key)) return row.polygons !== undefined;
        return row[key] !== undefined;
      },
    },
  ],
  output: [
    { title: '', keys: ['report', 'paths', 'geopackage', 'vtk'] },
    {
      title: 'Maps',
      keys: ['maps', 'maps_by_source', 'raster_cell_m', 'percentiles'],
      applies: (_key, _row, is2d) => !is2d,
    },
  ],
  design: [
    { title: 'What is asked', keys: ['lines', 'protect', 'section_m', 'percentiles', 'confidence'] },
    {
      title: 'Check',
      keys: checkKeys,
      folded: true,
    },
    {
      title: 'Kits to choose from',
      keys: ['catch_share', 'heights_m', 'energies_kJ', 'cost_height_exponent', 'cost_energy_exponent'],
      folded: true,
    },
  ],
};

/// The fields of a table in groups; those that no group names are the last.
export function groupsIn(table: string, fields: readonly Field[]): (Group & { fields: Field[] })[] {
  const groups = groupsOf[table] ?? [{ title: '', keys: fields.map(({ key }) => key) }];
  const named = new Set(groups.flatMap(({ keys }) => keys));
  const rest = fields.filter(({ key }) => !named.has(key));
  const all =
    rest.length > 0
      ? [...groups, { title: groups.length > 1 ? 'More' : '', keys: rest.map(({ key }) => key) }]
      : groups;
  return all.map((group) => ({
    ...group,
    fields: group.keys.flatMap((key) => fields.find((field) => field.key === key) ?? []),
  }));
}
