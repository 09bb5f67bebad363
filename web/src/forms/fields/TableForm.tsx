// The form of a table of the project, with its fields in groups.

import { useState } from 'preact/hooks';
import { edit, valueAt, values } from '../../project/document';
import { problemsOf } from '../../project/awaited';
import type { Name, Path } from '../../settings/names';
import { tableAt, thingOf } from '../../project/place';
import type { Field as Setting } from '../../settings/schema';
import { choicesOf, groupsIn, isOffered, type Group } from '../../settings/groups';
import type { Table } from '../../settings/schema';
import { tableOf } from '../../settings/declared';
import { Field } from './Field';

const isGiven = (path: Path) => valueAt(path) !== undefined || problemsOf(path).length > 0;

/// The form of all settings of a table, or of some (`only`).
export function TableForm({ table, path, only }: { table: Table['key']; path: Path; only?: readonly Name[] }) {
  const described = tableOf(table);
  if (!described) return null;
  const groups = groupsIn(
    described,
    described.fields.filter(({ key }) => only?.includes(key) ?? true),
  );
  return (
    <>
      {groups.map((group) => (
        <GroupOfFields key={group.title} table={described} group={group} path={path} />
      ))}
    </>
  );
}

function GroupOfFields({ table, group, path }: { table: Table; group: Group; path: Path }) {
  const row = tableAt(path);
  const hasGiven = group.fields.some(({ key }) => isGiven([...path, key]));
  const [open, setOpen] = useState(!group.folded || hasGiven);
  const fields = group.fields.filter(
    (field) => isGiven([...path, field.key]) || isOffered(table, field, row, values.value),
  );
  if (fields.length === 0) return null;
  const choices = choicesOf(table, fields);
  const choiceOf = (field: Setting) => choices.find((ways) => ways.some((way) => way.includes(field)));
  const body = fields.map((field) => {
    const choice = choiceOf(field);
    if (!choice) return <Field key={field.key} field={field} path={[...path, field.key]} />;
    const isFirst = fields.find((other) => choiceOf(other) === choice) === field;
    return isFirst ? <OneOf key={field.key} ways={choice} path={path} /> : null;
  });
  if (!group.title) return <div class="group">{body}</div>;
  return (
    <details class="group" open={open} onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary>{group.title}</summary>
      {open && body}
    </details>
  );
}

/// Mutually exclusive settings: choosing one removes the others.
function OneOf({ ways, path }: { ways: Setting[][]; path: Path }) {
  const [picked, setPicked] = useState<string | null>(null);
  const isGivenHere = (field: Setting) => valueAt([...path, field.key]) !== undefined;
  const nameOfWay = (way: Setting[]) => way[0]!.key;
  const now = ways.find((way) => nameOfWay(way) === picked) ?? ways.find((way) => way.some(isGivenHere)) ?? ways[0]!;
  const pick = (next: Setting[]) => {
    setPicked(nameOfWay(next));
    const gone = new Set([
      ...next.flatMap(({ excludes }) => excludes),
      ...ways.flatMap((way) => (way === next ? [] : way.map(({ key }) => key))),
    ]);
    const removes = [...gone]
      .filter((key) => valueAt([...path, key]) !== undefined)
      .map((key) => ({ remove: [...path, key] }));
    if (removes.length > 0) edit(`switch to ${next[0]!.title.toLowerCase()} of ${thingOf(path)}`, removes);
  };
  return (
    <div class="one-of">
      <div
        class="segments"
        role="group"
        aria-label={`One of ${ways.map((way) => way[0]!.title.toLowerCase()).join(', ')}`}
      >
        {ways.map((way) => (
          <button key={nameOfWay(way)} class="button" aria-pressed={way === now} onClick={() => way !== now && pick(way)}>
            {way[0]!.title}
          </button>
        ))}
      </div>
      {/* If the file has several, the engine reports it, and each can be cleared. */}
      {ways
        .flatMap((way) => way.filter((field) => way === now || isGivenHere(field)))
        .map((field) => (
          <Field key={field.key} field={field} path={[...path, field.key]} />
        ))}
    </div>
  );
}
