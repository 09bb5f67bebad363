import { expect, test } from 'vitest';
import { foundInSource, setByOthers } from './owners.mjs';

// It reads the whole source, beside other tests.
test('every signal of the page is set by its own module', { timeout: 60_000 }, () => {
  expect(foundInSource()).toEqual([]);
});

test('a module that sets an imported signal would be found', () => {
  const text = `import { chosen, choose as take } from '../project/chosen';
import * as picture from './picture';
const own = signal(0);
chosen.value = null;
const set = () => (picture.pointer.value = null);
own.value = chosen.value;
[own.value, chosen.value] = [1, null];
++chosen.value;
const isNone = !chosen.value && -chosen.value === 0;
`;
  expect(setByOthers('a/b.ts', text)).toEqual([
    'a/b.ts:4 sets chosen.value, which another module has',
    'a/b.ts:5 sets picture.pointer.value, which another module has',
    'a/b.ts:7 sets chosen.value, which another module has',
    'a/b.ts:8 sets chosen.value, which another module has',
  ]);
});
