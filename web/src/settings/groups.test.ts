import { expect, test } from 'vitest';
import { groupsIn } from './groups';
import { tables } from './declared';

test('the form of each table shows each of its settings once', () => {
  for (const table of tables) {
    const shown = groupsIn(table, table.fields).flatMap(({ fields }) => fields.map(({ key }) => key));
    expect(shown.toSorted(), table.key).toEqual(table.fields.map(({ key }) => key).toSorted());
  }
});
