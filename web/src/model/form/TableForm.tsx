// The form of one table of the project, its fields in groups.

import { useState } from 'preact/hooks';
import { edit, valueAt } from '../../state/document';
import { problemsOf } from '../awaited';
import type { Path } from '../../toml/edit';
import { is2d, tableAt, thingOf } from '../place';
import type { Field as Setting } from '../schema';
import { groupsIn } from '../sections';
import { tableOf } from '../settings';
import { Field } from './Field';

type Group = ReturnType<typeof groupsIn>[number];

const isGiven = (path: Path) => valueAt(path) !== undefined || problemsOf(path).length > 0;

/// All of a table's settings, or only some.
export function TableForm({ table, path, only }: { table: string; path: Path; only?: string[] }) {
  const described = tableOf(table);
  if (!described) return null;
  const groups = groupsIn(
    table,
    described.fields.filter(({ key }) => only?.includes(key) ?? true),
  );
  return (
    <>
      {groups.map((group, k) => (
        <GroupOfFields key={k} group={group} path={path} />
      ))}
    </>
  );
}

function GroupOfFields({ group, path }: { group: Group; path: Path }) {
  const row = tableAt(path);
  const applies = ({ key }: Setting) => isGiven([...path, key]) || (group.applies?.(key, row, is2d.value) ?? true);
  const hasGiven = group.fields.some(({ key }) => isGiven([...path, key]));
  const [open, setOpen] = useState(!group.folded || hasGiven);
  const alternatives = (group.oneOf ?? []).map((keys) =>
    group.fields.filter(
      (field) =>
        keys.includes(field.key) &&
        (isGiven([...path, field.key]) || (group.applies?.(field.key, row, is2d.value) ?? true)),
    ),
  );
  const fields = group.fields.filter(applies);
  if (fields.length === 0) return null;
  const body = fields.map((field) => {
    const choice = alternatives.find((list) => list.length > 1 && list.includes(field));
    if (!choice) return <Field key={field.key} field={field} path={[...path, field.key]} />;
    return choice[0] === field ? <OneOf key={field.key} fields={choice} path={path} /> : null;
  });
  if (!group.title) return <div class="group">{body}</div>;
  return (
    <details class="group" open={open} onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary>{group.title}</summary>
      {open && body}
    </details>
  );
}

/// Settings that exclude each other: one of them is chosen, the others go.
function OneOf({ fields, path }: { fields: Setting[]; path: Path }) {
  const [picked, setPicked] = useState<string | null>(null);
  const given = fields.find(({ key }) => valueAt([...path, key]) !== undefined);
  const now = fields.find(({ key }) => key === picked) ?? given ?? fields[0]!;
  const pick = (next: Setting) => {
    setPicked(next.key);
    const gone = new Set([...next.excludes, ...fields.flatMap(({ key }) => (key === next.key ? [] : [key]))]);
    const removes = [...gone]
      .filter((key) => valueAt([...path, key]) !== undefined)
      .map((key) => ({ remove: [...path, key] }));
    if (removes.length > 0) edit(`give ${next.title.toLowerCase()} of ${thingOf(path)}`, removes);
  };
  return (
    <div class="one-of">
      <div
        class="segments"
        role="group"
        aria-label={`One of ${fields.map(({ title }) => title.toLowerCase()).join(', ')}`}
      >
        {fields.map((field) => (
          <button
            key={field.key}
            class="button"
            aria-pressed={field === now}
            onClick={() => field !== now && pick(field)}
          >
            {field.title}
          </button>
        ))}
      </div>
      {/* More than one in the file: the engine says so, and each can be cleared. */}
      {fields
        .filter((field) => field === now || valueAt([...path, field.key]) !== undefined)
        .map((field) => (
          <Field key={field.key} field={field} path={[...path, field.key]} />
        ))}
    </div>
  );
}
