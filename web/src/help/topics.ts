// Where the documents say more about a setting.

import { checkKeys } from '../model/groups';
import type { Path } from '../toml/edit';

export interface Topic {
  document: string;
  heading: string;
}

const laws = (heading: string): Topic => ({ document: 'laws.md', heading });
const gis = (heading: string): Topic => ({ document: 'gis.md', heading });
const terrain = (heading: string): Topic => ({ document: 'terrain.md', heading });
const outputs = (heading: string): Topic => ({ document: 'outputs.md', heading });
const design = (heading: string): Topic => ({ document: 'barrier-design.md', heading });

const equations = laws('The equations of the lumped mass');
const points = laws('Points worth knowing');
const survey = terrain('A survey as terrain');
const cells = gis('Seeders on cells');
const check = design('The check');
const ranking = design('Which line, height and energy');
const maps = outputs('maps/');

/// By table and key, or by table.
export const topics: Record<string, Topic> = {
  analysis: equations,
  'analysis.model': laws('The laws'),
  'analysis.normal_velocity_cutoff_m_s': points,
  'analysis.grazing_angle_deg': points,
  'analysis.stopped_velocity_m_s': points,
  'analysis.friction_angle': points,
  'terrain.section_std_dev_m': points,
  'terrain.rotate_deg': points,
  'terrain.rotate_about': points,
  'terrain.raster': terrain('Rasters'),
  'terrain.points': survey,
  'terrain.lines': survey,
  'terrain.boundary': survey,
  'terrain.max_edge_m': survey,
  'terrain.remove_spikes_m': survey,
  'terrain.polylines': survey,
  'terrain.polygons': survey,
  'terrain.merge_tolerance_m': survey,
  terrain: terrain('Terrain'),
  material: equations,
  'material.like': { document: 'materials.md', heading: 'The library of materials' },
  'material.friction_angle_deg': equations,
  'material.roughness_deg': points,
  'material.roughness_spacing_m': points,
  'material.roughness_amplitude_m': points,
  'material.dynamic_friction': laws('The laws'),
  'material.rolling_friction': laws('The laws'),
  'material.forest': laws('Forest'),
  'material.forest_drag_kg_s': laws('Forest'),
  'material.forest_height_m': laws('Forest'),
  'material.ground_drag_per_s': laws('Soft ground'),
  ground: gis('Ground from polygons'),
  area: gis('Areas drawn on it'),
  seeder: { document: 'project-file.md', heading: '`[[seeder]]`' },
  'seeder.lines': gis('Lines'),
  'seeder.polygons': cells,
  'seeder.polygon': cells,
  'seeder.layer': gis('Vector files'),
  'seeder.min_slope_deg': cells,
  'seeder.max_slope_deg': cells,
  'seeder.mask': cells,
  'seeder.cell_m': cells,
  'seeder.place': cells,
  'seeder.rocks_per_cell': cells,
  barrier: points,
  collector: points,
  sampling: { document: 'project-file.md', heading: '`[sampling]`' },
  output: { document: 'project-file.md', heading: '`[output]`' },
  'output.paths': outputs('paths.csv'),
  'output.geopackage': outputs('results.gpkg'),
  'output.vtk': outputs('paths.vtp'),
  'output.maps': maps,
  'output.maps_by_source': maps,
  'output.raster_cell_m': maps,
  'output.percentiles': maps,
  design: design('What is counted'),
  'design.confidence': design('Confidence'),
  'design.percentiles': design('design.csv'),
  'design.catch_share': ranking,
  'design.heights_m': ranking,
  'design.energies_kJ': ranking,
  'design.cost_height_exponent': ranking,
  'design.cost_energy_exponent': ranking,
  ...Object.fromEntries(
    checkKeys.map((key) => [`design.${key}`, check]),
  ),
};

/// Of the setting at a path of the project.
export function topicOf(path: Path): Topic | undefined {
  const [table, key] = [String(path[0]), String(path.at(-1))];
  return path.length < 2 ? undefined : (topics[`${table}.${key}`] ?? topics[table]);
}
