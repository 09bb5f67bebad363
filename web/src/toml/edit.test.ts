import { describe, expect, test } from 'vitest';
import { edited } from './edit';
import { valuesOf } from './values';

const lines = (...all: string[]) => all.join('\n') + '\n';

describe('untouched text keeps its layout', () => {
  const text = lines(
    '# A slope.',
    'name  = "A"   # its name',
    '',
    '[terrain]',
    'section = [ # x, z',
    '  [0, 0],      # crest',
    '  [10,-10.0],',
    ']',
    '',
    '# The rock.',
    '[[material]]',
    "name = 'Rock'",
    'normal_restitution = { mean = 0.5, distribution = "normal", std_dev = 0.03 } # measured',
    '',
    '# The soil.',
    '[[material]]',
    'name = "Soil"',
  );
  test('a value in a table', () =>
    expect(edited(text, [{ set: ['material', 0, 'normal_restitution', 'mean'], value: 0.4 }])).toBe(
      text.replace('mean = 0.5', 'mean = 0.4'),
    ));
  test('a number in a list', () =>
    expect(edited(text, [{ set: ['terrain', 'section', 1, 0], value: 12 }])).toBe(
      text.replace('[10,-10.0]', '[12,-10.0]'),
    ));
  test('a new key', () =>
    expect(edited(text, [{ set: ['material', 0, 'friction_angle_deg'], value: 30 }])).toBe(
      text.replace('# measured\n', '# measured\nfriction_angle_deg = 30\n'),
    ));
  test('a key before the first table', () => {
    expect(edited(text, [{ set: ['name'], value: 'B "x"' }])).toBe(text.replace('"A"', '"B \\"x\\""'));
    expect(edited('# Only words.\n\n# The rock.\n[[material]]\n', [{ set: ['name'], value: 'B' }])).toBe(
      '# Only words.\n\nname = "B"\n\n# The rock.\n[[material]]\n',
    );
  });
  test('a removed table takes its comment with it', () =>
    expect(edited(text, [{ remove: ['material', 0] }])).toBe(
      text.slice(0, text.indexOf('# The rock.')) + text.slice(text.indexOf('# The soil.')),
    ));
  test('the last table is removed', () =>
    expect(edited(text, [{ remove: ['material', 1] }])).toBe(text.slice(0, text.indexOf('\n# The soil.'))));
  test('a new table', () =>
    expect(edited(text, [{ append: ['material'], value: { name: 'Scree', friction_angle_deg: 34 } }])).toBe(
      text + lines('', '[[material]]', 'name = "Scree"', 'friction_angle_deg = 34'),
    ));
  test('a new vertex has a line of its own', () =>
    expect(edited(text, [{ set: ['terrain', 'section', 2], value: [20, -15] }])).toBe(
      text.replace('  [10,-10.0],\n', '  [10,-10.0],\n  [20, -15],\n'),
    ));
  test('a removed vertex takes its line with it', () => {
    expect(edited(text, [{ remove: ['terrain', 'section', 1] }])).toBe(text.replace('  [10,-10.0],\n', ''));
    expect(edited(text, [{ remove: ['terrain', 'section', 0] }])).toBe(text.replace('  [0, 0],      # crest\n', ''));
  });
});

describe('missing tables', () => {
  test('are created', () => {
    expect(edited('', [{ set: ['output', 'maps'], value: false }])).toBe('[output]\nmaps = false\n');
    expect(edited('name = "A"', [{ append: ['seeder'], value: { rocks: 1 } }])).toBe(
      'name = "A"\n\n[[seeder]]\nrocks = 1\n',
    );
  });
  test('a value in a distribution that was a number', () =>
    expect(edited('[[material]]\nrn = 0.35\n', [{ set: ['material', 0, 'rn', 'mean'], value: 0.4 }])).toBe(
      '[[material]]\nrn = { mean = 0.4 }\n',
    ));
});

describe('other forms of TOML', () => {
  test('dotted keys', () => {
    const text = lines('analysis.model = "lumped_mass"', 'analysis.rotation = true', '', '[terrain]', 'width_m = 5');
    expect(edited(text, [{ set: ['analysis', 'rotation'], value: false }])).toBe(text.replace('true', 'false'));
    expect(edited(text, [{ remove: ['analysis', 'model'] }])).toBe(
      text.replace('analysis.model = "lumped_mass"\n', ''),
    );
    const more = edited(text, [{ set: ['analysis', 'sliding'], value: 'stepped' }]);
    expect(valuesOf(more)).toMatchObject({
      analysis: { model: 'lumped_mass', rotation: true, sliding: 'stepped' },
      terrain: { width_m: 5 },
    });
  });
  test('all dotted keys of a table', () => {
    const text = lines('name = "A"', 'analysis.model = "lumped_mass"', 'analysis.rotation = true');
    expect(edited(text, [{ remove: ['analysis'] }])).toBe('name = "A"\n');
  });
  test('a dotted distribution', () => {
    const text = lines('[[material]]', 'rn.mean = 0.5', 'rn.distribution = "normal"');
    expect(valuesOf(edited(text, [{ set: ['material', 0, 'rn', 'std_dev'], value: 0.1 }]))).toEqual({
      material: [{ rn: { mean: 0.5, distribution: 'normal', std_dev: 0.1 } }],
    });
    expect(valuesOf(edited(text, [{ set: ['material', 0, 'rn'], value: 0.3 }]))).toEqual({ material: [{ rn: 0.3 }] });
  });
  test('a distribution with its own header', () => {
    const text = lines('[[seeder]]', 'rocks = 5', '[seeder.mass_kg]', 'mean = 100', '[[seeder]]', 'rocks = 6');
    expect(edited(text, [{ set: ['seeder', 0, 'mass_kg', 'mean'], value: 200 }])).toBe(text.replace('100', '200'));
    expect(edited(text, [{ set: ['seeder', 0, 'name'], value: 'A' }])).toBe(
      text.replace('rocks = 5\n', 'rocks = 5\nname = "A"\n'),
    );
    expect(edited(text, [{ remove: ['seeder', 0, 'mass_kg'] }])).toBe(
      text.replace('[seeder.mass_kg]\nmean = 100\n', ''),
    );
    expect(valuesOf(edited(text, [{ set: ['seeder', 0, 'mass_kg'], value: 50 }]))).toEqual({
      seeder: [{ rocks: 5, mass_kg: 50 }, { rocks: 6 }],
    });
    expect(edited(text, [{ remove: ['seeder', 0] }])).toBe('[[seeder]]\nrocks = 6\n');
    expect(valuesOf(edited(text, [{ append: ['seeder'], value: { rocks: 7 } }])).seeder).toHaveLength(3);
  });
  test('an inline list of tables', () => {
    const text = 'material = [{ name = "A" }, { name = "B" }]\n';
    expect(edited(text, [{ set: ['material', 1, 'name'], value: 'C' }])).toBe(text.replace('"B"', '"C"'));
    expect(edited('a = 1\n', [{ append: ['material'], value: { name: 'C' }, comment: 'From elsewhere' }])).toBe(
      'a = 1\n\n# From elsewhere\n[[material]]\nname = "C"\n',
    );
    expect(edited(text, [{ append: ['material'], value: { name: 'C' } }])).toBe(
      'material = [{ name = "A" }, { name = "B" }, { name = "C" }]\n',
    );
    expect(edited(text, [{ remove: ['material', 0] }])).toBe('material = [{ name = "B" }]\n');
    expect(edited(text, [{ remove: ['material', 1] }])).toBe('material = [{ name = "A" }]\n');
    expect(edited(text, [{ set: ['material', 0, 'rn', 'mean'], value: 1 }])).toBe(
      'material = [{ name = "A", rn = { mean = 1 } }, { name = "B" }]\n',
    );
  });
  test('the only entry of an inline list, and keys of an empty table', () => {
    expect(edited('a = [1]\n', [{ remove: ['a', 0] }])).toBe('a = []\n');
    expect(edited('a = []\n', [{ set: ['a', 0], value: 1 }])).toBe('a = [1]\n');
    expect(edited('a = {}\n', [{ set: ['a', 'b'], value: 1 }])).toBe('a = { b = 1 }\n');
    expect(edited('[a]\n\n[b]\n', [{ set: ['a', 'c'], value: 1 }])).toBe('[a]\nc = 1\n\n[b]\n');
  });
  test('keys in quotes', () => {
    const text = '[ground]\nvalues = { "Fels & Co" = "Rock", b = "Soil" }\n';
    expect(edited(text, [{ set: ['ground', 'values', 'Fels & Co'], value: 'Soil' }])).toBe(
      text.replace('"Rock"', '"Soil"'),
    );
    expect(edited(text, [{ remove: ['ground', 'values', 'Fels & Co'] }])).toBe('[ground]\nvalues = { b = "Soil" }\n');
    expect(edited(text, [{ set: ['ground', 'values', 'Höhe'], value: 'Soil' }])).toContain('"Höhe" = "Soil"');
  });
});

describe('Windows line ends', () => {
  const text = '# A\r\nname = "A"\r\n\r\n[[material]]\r\nname = "Rock"\r\n\r\n[[seeder]]\r\nrocks = 5\r\n';
  const hasOnlyCrLf = (result: string) => expect(result.replaceAll('\r\n', '')).not.toMatch(/[\r\n]/);
  test('are also used in added text', () => {
    for (const edit of [
      { set: ['material', 0, 'roughness_deg'], value: 3 },
      { set: ['output', 'maps'], value: true },
      { append: ['material'], value: { name: 'Soil', like: 'soft_soil' } },
      { remove: ['material', 0, 'name'] },
      { remove: ['seeder', 0] },
      { set: ['terrain', 'section'], value: Array.from({ length: 40 }, (_, k) => [k, -k]) },
    ])
      hasOnlyCrLf(edited(text, [edit]));
    expect(edited(text, [{ set: ['material', 0, 'roughness_deg'], value: 3 }])).toBe(
      text.replace('"Rock"\r\n', '"Rock"\r\nroughness_deg = 3\r\n'),
    );
  });
});

describe('a text without a final newline', () => {
  test('a key, a table', () => {
    expect(edited('[a]\nb = 1', [{ set: ['a', 'c'], value: 2 }])).toBe('[a]\nb = 1\nc = 2\n');
    expect(edited('[a]\nb = 1 # so', [{ append: ['d'], value: { e: 1 } }])).toBe('[a]\nb = 1 # so\n\n[[d]]\ne = 1\n');
    expect(edited('[a]\nb = 1', [{ remove: ['a', 'b'] }])).toBe('[a]\n');
  });
});

test('set values can be read back', () => {
  const values = [
    1,
    -0.5,
    1e300,
    1e-7,
    123456789012,
    Infinity,
    true,
    'a\\b "c"\n\u0007\u007f',
    ['a', 'b'],
    [
      [1, 2],
      [3, 4],
    ],
    { mean: 1, distribution: 'normal' },
  ];
  for (const value of values)
    expect(valuesOf(edited('[x]\n', [{ set: ['x', 'y'], value }]))).toEqual({ x: { y: value } });
});

test('removing twice is allowed', () => {
  const once = edited('a = 1\n[b]\nc = 2\n', [
    { remove: ['b', 'c'] },
    { remove: ['b', 'c'] },
    { remove: ['d'] },
    { remove: ['b', 'e', 'f'] },
  ]);
  expect(once).toBe('a = 1\n[b]\n');
});

test('a byte order mark is kept', () => {
  const marked = '\ufeffname = "A"\r\n';
  expect(valuesOf(marked)).toEqual({ name: 'A' });
  expect(edited(marked, [{ set: ['name'], value: 'B' }, { append: ['seeder'], value: { rocks: 5 } }])).toBe(
    '\ufeffname = "B"\r\n\r\n[[seeder]]\r\nrocks = 5\r\n',
  );
});

test('a table is not appended to anything but a list of tables', () => {
  const append = () => [{ append: ['material'], value: { name: 'A' } }];
  for (const text of ['material = 3\n', 'material = { name = "B" }\n', '[material]\nname = "B"\n'])
    expect(() => edited(text, append())).toThrow('material already exists and is not a list of tables');
});
