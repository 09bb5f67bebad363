import { expect, test } from 'vitest';
import type { GroundSection, Model } from '../api/types';
import { valuesOf } from '../toml/values';
import { crossingOf, longestPart, sectionProject, withoutStraight } from './sectionProject';

const section: GroundSection = {
  distance_m: [0, 10, 20, 20, 40, 40, 45],
  z_m: [50, 40, 30, 28, 20, null, 3],
  x_m: [],
  y_m: [],
  materials: [0, 1, null, 1, null, null, null],
};
const text = `name = "Valley" # kept
[terrain]
raster = "valley.tif"
crs = "local"
[[material]]
name = "Rock"   # bare
normal_restitution = 0.5
[[material]]
name = "Scree"
[ground]
default = "Rock"
polygons = "g.gpkg"
attribute = "material"
[[seeder]]
name = "Crest"
type = "line"
points = [[0, 0], [0, 100]]
height_above_m = 1
rocks = 200
mass_kg = { mean = 100, distribution = "normal", std_dev = 5 }
horizontal_velocity_m_s = 2
direction = [0.1, -1, 0]
[[seeder]]
name = "Far"
position = [0, 900, 70]
mass_kg = 5
[[barrier]]
name = "Net"
line = [[10, 25], [-10, 25]]
height_m = 3
inclination_deg = 20
capacity_kJ = 500
[output]
raster_cell_m = "terrain"
geopackage = "none"
`;
// The line goes south from (0, 50).
const line: [number, number][] = [[0, 50], [0, 5]];
const model = {
  materials: ['Rock', 'Scree'],
  seeders: [
    { name: 'Crest', path: 'seeder.0', rocks: 200, points: [[1, 48, 51], [-1, 44, 47], [30, 40, 40], [0, 60, 60]] },
    { name: 'Far', path: 'seeder.1', rocks: 10, points: [[0, 900, 70]] },
  ],
  barriers: [{ name: 'Net', kind: 'barrier', path: 'barrier.0', foot: [[10, 25, 30], [-10, 25, 30]], top: [] }],
} as unknown as Model;

test('the longest part without gaps keeps steps and the material of each segment', () => {
  expect(longestPart(section)).toEqual({
    vertices: [[0, 50], [10, 40], [20, 30], [20, 28], [40, 20]],
    materials: [0, 1, null, 1],
  });
});

test('vertices that repeat, or that make neither a bend nor a change of the material, are left out', () => {
  const straight = withoutStraight(
    [[0, 10], [1, 9], [1, 9.00001], [2, 8], [3, 7], [3, 7], [4, 7], [5, 7.0004], [6, 7]],
    [0, 0, 0, 0, 1, 1, 1, 1],
  );
  expect(straight).toEqual({ vertices: [[0, 10], [3, 7], [6, 7]], materials: [0, 1] });
  // A step of a metre stays; so does a change of the material on a straight slope.
  expect(withoutStraight([[0, 5], [2, 3], [2, 2], [3, 2]], [0, 0, 0])).toEqual({ vertices: [[0, 5], [2, 3], [2, 2], [3, 2]], materials: [0, 0, 0] });
  expect(withoutStraight([[0, 5], [2, 3], [4, 1]], [0, 1])).toEqual({ vertices: [[0, 5], [2, 3], [4, 1]], materials: [0, 1] });
});

test('a project of the section: ground, materials, seeders of the corridor, barriers on the line', () => {
  const { text: made, notes } = sectionProject(text, valuesOf(text), model, section, line, 5, 'Valley, section');
  const values = valuesOf(made) as Record<string, any>;
  expect(values.name).toBe('Valley, section');
  expect(values.terrain).toEqual({ section: [[0, 50], [10, 40], [20, 30], [20, 28], [40, 20]] });
  expect(values.ground).toEqual({ segments: ['Rock', 'Scree', 'Scree', 'Scree'] });
  expect(made).toContain('name = "Rock"   # bare');
  expect(values.seeder).toEqual([
    {
      name: 'Crest',
      type: 'line',
      points: [[2], [6]],
      height_above_m: 1,
      rocks: 100, // two of four release places
      mass_kg: { mean: 100, distribution: 'normal', std_dev: 5 },
      horizontal_velocity_m_s: 2,
      direction: [1, 0], // south
    },
  ]);
  // The net runs west, and leans to its right: north, against the section.
  expect(values.barrier).toEqual([{ name: 'Net', line: 25, height_m: 3, inclination_deg: -20, capacity_kJ: 500 }]);
  expect(values.output).toEqual({});
  expect(notes).toEqual(['No rock starts in the corridor from Far.']);
});

test('without a seeder in the corridor the project asks for one', () => {
  const { notes, text: made } = sectionProject(text, valuesOf(text), model, section, [[500, 50], [500, 5]], 5, 'x');
  expect(notes).toEqual(['No rock starts in the corridor from Crest, Far.', 'Add a seeder: where do rocks start?']);
  expect(valuesOf(made).seeder).toBeUndefined();
  expect(valuesOf(made).barrier).toBeUndefined();
});

test('a barrier crosses a bent line at its first crossing', () => {
  const at = (...foot: [number, number, number][]) => crossingOf({ foot } as never, [[0, 0], [10, 0], [10, 10]]);
  expect(at([5, -1, 0], [5, 1, 0])).toEqual({ distance: 5, leansForwards: true });
  expect(at([5, 1, 0], [5, -1, 0])).toEqual({ distance: 5, leansForwards: false });
  expect(at([11, 4, 0], [9, 4, 0])?.distance).toBe(14);
  expect(at([0, 5, 0], [4, 5, 0])).toBeNull();
});
