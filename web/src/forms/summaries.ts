// One-line summaries of the parts of the project, for the outline.

import { rowsOf, valueAt, values } from '../project/document';
import { model } from '../project/model';
import type { TomlValue } from '../toml/format';
import { counted } from '../units/numbers';
import { library } from '../project/library';
import { likeness } from '../project/likeness';
import { defaultOf, type Row, type TableName } from '../settings/names';
import { tableAt } from '../project/place';
import { isTable } from '../settings/tables';
import { valueText, wordText } from '../settings/words';

const number = (value: TomlValue | undefined) => (isTable(value) ? valueText(value.mean) : valueText(value));

function terrain(): string {
  const { section, width_m, ...given } = tableAt(['terrain']);
  if (Array.isArray(section))
    return `section, ${counted(section.length, 'vertex', 'vertices')}${width_m === undefined ? '' : `, ${number(width_m)} m wide`}`;
  for (const key of ['raster', 'mesh', 'points', 'lines', 'polygons'] as const) {
    const file = given[key];
    if (typeof file === 'string') return file;
    if (Array.isArray(file)) return counted(file.length, 'file');
  }
  if (Array.isArray(given.polylines)) return counted(given.polylines.length, 'polyline');
  if (Array.isArray(given.triangles)) return counted(given.triangles.length, 'triangle');
  return 'none yet';
}

function seeder(row: Row<'seeder'>): string {
  const type = wordText(String(row.type ?? defaultOf('seeder', 'type')));
  const built = model.value?.seeders.find(({ name }) => name === row.name);
  const rocks =
    row.rocks_per_cell !== undefined
      ? `${number(row.rocks_per_cell)} ${row.rocks_per_cell === 1 ? 'rock' : 'rocks'} a cell`
      : row.type === 'table' && built === undefined && row.rocks === undefined
        ? `${number(row.rocks_per_row ?? 1)} ${(row.rocks_per_row ?? 1) === 1 ? 'rock' : 'rocks'} a row`
        : counted(built?.rocks ?? Number(row.rocks ?? defaultOf('seeder', 'rocks')), 'rock');
  return `${type}, ${rocks}`;
}

function material(row: Row<'material'>): string {
  const found = likeness(row, library.value);
  const entry = library.value.find(({ key }) => key === row.like);
  if (row.like !== undefined && (!found || found.changed.length === 0)) return wordText(String(row.like));
  const valueOf = (key: 'normal_restitution' | 'tangential_restitution') =>
    number(row[key] ?? (entry?.values[key] as TomlValue | undefined) ?? { ...defaultOf('material', key) });
  const values = `Rn ${valueOf('normal_restitution')}, Rt ${valueOf('tangential_restitution')}`;
  return found && found.changed.length > 0 ? `${values}, changed` : values;
}

function barrier(key: string, row: Row<'barrier'>): string {
  const capacity = row.capacity_kJ;
  return [
    key,
    row.height_m !== undefined ? `${number(row.height_m)} m` : '',
    typeof capacity === 'number' && Number.isFinite(capacity) ? `${capacity} kJ` : '',
  ]
    .filter(Boolean)
    .join(', ');
}

function forest(row: Row<'forest'>): string {
  if (row.density === 'none') return 'clearing';
  const drag = valueText(row.density) || (row.drag_kg_s !== undefined ? `${valueText(row.drag_kg_s)} kg/s` : '');
  const height = row.height_m !== undefined ? `${valueText(row.height_m)} m high` : '';
  return [drag, height].filter(Boolean).join(', ') || 'no density yet';
}

export function summaryOf(key: TableName, index?: number): string {
  const row = index === undefined ? {} : (rowsOf(key)[index] ?? {});
  switch (key) {
    case 'analysis':
      return wordText(String(valueAt(['analysis', 'model']) ?? defaultOf('analysis', 'model')));
    case 'terrain':
      return terrain();
    case 'ground':
      return groundText();
    case 'material':
      return material(row);
    case 'area':
      return valueText(row.material) || 'no material yet';
    case 'forest':
      return forest(row);
    case 'seeder':
      return seeder(row);
    case 'barrier':
    case 'collector':
      return barrier(key, row);
    case 'layer':
      return valueText(row.file) || 'no file yet';
    case 'kit':
      return row.mel_kJ === undefined ? '' : `${valueText(row.mel_kJ)} kJ`;
    case 'sampling':
      return `seed ${valueText(valueAt(['sampling', 'seed']) ?? defaultOf('sampling', 'seed'))}`;
    case 'output':
      return `paths of ${valueText(valueAt(['output', 'paths']) ?? defaultOf('output', 'paths'))}`;
    case 'report':
      return valueText(valueAt(['report', 'number'])) || valueText(valueAt(['report', 'paper']) ?? defaultOf('report', 'paper'));
    case 'design':
      return isTable(values.value.design) ? 'on' : 'off';
    default:
      return '';
  }
}

function groundText(): string {
  const ground = tableAt(['ground']);
  if (typeof ground.raster === 'string') return ground.raster;
  if (typeof ground.polygons === 'string') return ground.polygons;
  if (ground.segments !== undefined) return 'by segments';
  if (ground.triangles !== undefined) return 'by triangles';
  return typeof ground.default === 'string' ? ground.default : 'one material';
}
