import { useEffect, useState } from 'preact/hooks';
import type { LibraryMaterial } from '../api/types';
import { rowsOf } from '../project/document';
import { attempt, reportFailure } from '../state/messages';
import { Dialog } from '../ui/Dialog';
import { library, loadLibrary } from '../project/library';
import { isNameOf } from '../project/likeness';
import { addOwn, loadOwn, ownMaterials, removeOwn } from '../project/ownMaterials';
import type { KeyOf } from '../settings/names';
import { unusedName } from '../project/place';
import { append } from '../project/things';
import { valueText } from '../settings/words';

const allColumns: [KeyOf<'material'>, string][] = [
  ['normal_restitution', 'Rn'],
  ['tangential_restitution', 'Rt'],
  ['friction_angle_deg', 'Friction angle, °'],
  ['roughness_deg', 'Roughness, °'],
  ['dynamic_friction', 'Dynamic friction'],
  ['rolling_friction', 'Rolling friction'],
];

function addMaterial({ key, name }: LibraryMaterial) {
  append('material', { name: unusedName('material', name), like: key }, `add ${name}`);
}

/// How many materials of the project are this one by their names.
const countOf = (name: string) => rowsOf('material').filter((row) => isNameOf(row.name, name)).length;

function InProject({ name }: { name: string }) {
  const count = countOf(name);
  return count === 0 ? null : <span class="faint"> {count === 1 ? 'in the project' : `${count} in the project`}</span>;
}

interface Row {
  name: string;
  /// Where the values are from.
  from: string;
  values: Record<string, unknown>;
  add: () => void;
  remove?: () => void;
}

function Materials({ caption, rows }: { caption: string; rows: Row[] }) {
  const [asked, ask] = useState<string | null>(null);
  const columns = allColumns.filter(([key]) => rows.some(({ values }) => values[key] !== undefined));
  return (
    <div class="table-scroll">
      <table>
        <caption>{caption}</caption>
        <thead>
          <tr>
            <th scope="col">Material</th>
            <th scope="col">
              <span class="visually-hidden">Add</span>
            </th>
            {columns.map(([key, title]) => (
              <th key={key} scope="col" class="number">
                {title}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {rows.map(({ name, from, values, add: addIt, remove }) => (
            <tr key={name}>
              <th scope="row" title={from}>
                {name}
              </th>
              <td>
                <button class="button" aria-label={`Add ${name}`} onClick={addIt}>
                  Add
                </button>
                <InProject name={name} />
                {remove && (
                  <button
                    class="button plain danger"
                    aria-label={`Delete ${name} from my materials${asked === name ? ' for good' : ''}`}
                    onClick={() => (asked === name ? remove() : ask(name))}
                  >
                    {asked === name ? 'Delete for good?' : 'Delete'}
                  </button>
                )}
              </td>
              {columns.map(([key]) => (
                <td key={key} class="number">
                  {valueText(values[key])}
                </td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

/// Adds materials with the values of those in the library, or in the library of one's own.
export function LibraryChoice() {
  const [isOpen, open] = useState(false);
  useEffect(loadLibrary, []);
  const start = () => {
    void loadOwn().catch(reportFailure);
    open(true);
  };
  const own = ownMaterials.value.map((material): Row => {
    const { name, values, from, on } = material;
    const inherited = library.value.find(({ key }) => key === values.like)?.values;
    return {
      name,
      from: [from && `saved from ${from}`, on].filter(Boolean).join(', '),
      values: { ...inherited, ...values },
      add: () => addOwn(material),
      remove: () => void attempt('own materials', () => removeOwn(name)),
    };
  });
  return (
    <>
      <button class="button plain" aria-haspopup="dialog" onClick={start}>
        + From the library…
      </button>
      {isOpen && (
        <Dialog title="Add materials from the library" close={() => open(false)}>
          {own.length > 0 && <Materials caption="My materials" rows={own} />}
          <Materials
            caption="From the literature"
            rows={library.value.map((material) => ({
              name: material.name,
              from: material.sources.map(({ text }) => text).join('\n'),
              values: material.values,
              add: () => addMaterial(material),
            }))}
          />
        </Dialog>
      )}
    </>
  );
}
