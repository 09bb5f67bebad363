import { describe, expect, it } from 'vitest';
import { edited, valuesOf } from './edit';

const project = `# A slope.
name = "One" # of many

[analysis]
gravity_m_s2 = 9.81   # of the hand calculation

# The ground.
[[material]]
name = "A"
normal_restitution = { mean = 0.5, std_dev = 0.1 } # measured
friction_angle_deg = 30

[[material]]
name = "B"

# Where rocks start.
[[seeder]]
type = "point"
position = [0, 1, "surface"]
`;

describe('edits of a project', () => {
  it('replace a value and leave its comment', () => {
    expect(edited(project, [{ set: ['analysis', 'gravity_m_s2'], value: 9.8 }])).toBe(
      project.replace('9.81 ', '9.8 '),
    );
  });
  it('reach into inline tables and lists', () => {
    const text = edited(project, [
      { set: ['material', 0, 'normal_restitution', 'mean'], value: 0.45 },
      { set: ['material', 0, 'normal_restitution', 'distribution'], value: 'normal' },
      { set: ['seeder', 0, 'position', 2], value: 7.5 },
    ]);
    expect(text).toContain('normal_restitution = { mean = 0.45, std_dev = 0.1, distribution = "normal" } # measured');
    expect(text).toContain('position = [0, 1, 7.5]');
  });
  it('turn a plain value into a table where one of its keys is set', () => {
    const text = edited(project, [{ set: ['material', 0, 'friction_angle_deg', 'mean'], value: 31 }]);
    expect(valuesOf(text)).toMatchObject({ material: [{ friction_angle_deg: { mean: 31 } }, {}] });
  });
  it('add a key at the end of its table, above the comment of the next one', () => {
    expect(edited(project, [{ set: ['material', 1, 'roughness_deg'], value: 2 }])).toBe(
      project.replace('name = "B"\n', 'name = "B"\nroughness_deg = 2\n'),
    );
  });
  it('add a table that is missing', () => {
    expect(edited(project, [{ set: ['sampling', 'seed'], value: 7 }])).toBe(`${project}\n[sampling]\nseed = 7\n`);
  });
  it('append a table after the last of its kind', () => {
    expect(edited(project, [{ append: ['material'], value: { name: 'C "x"' } }])).toBe(
      project.replace('name = "B"\n', 'name = "B"\n\n[[material]]\nname = "C \\"x\\""\n'),
    );
  });
  it('remove a key with its line, and a table with its comment', () => {
    expect(edited(project, [{ remove: ['analysis', 'gravity_m_s2'] }])).toBe(
      project.replace('gravity_m_s2 = 9.81   # of the hand calculation\n', ''),
    );
    const text = edited(project, [{ remove: ['material', 0] }]);
    expect(text).not.toContain('# The ground.');
    expect(text).toContain('# Where rocks start.');
    expect(valuesOf(text)).toMatchObject({ material: [{ name: 'B' }] });
  });
  it('take back nothing that is not there', () => {
    expect(edited(project, [{ remove: ['terrain', 'section', 3] }, { remove: ['design'] }])).toBe(project);
  });
  it('give numbers their shortest text, and infinity its word', () => {
    const text = edited('', [
      { set: ['a'], value: 0.1 + 0.2 },
      { set: ['b'], value: Infinity },
      { set: ['c'], value: [1e21, -0, 2] },
    ]);
    expect(valuesOf(text)).toEqual({ a: 0.30000000000000004, b: Infinity, c: [1e21, 0, 2] });
  });
});
