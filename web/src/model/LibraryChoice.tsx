import { useEffect, useState } from 'preact/hooks';
import type { LibraryMaterial } from '../api/types';
import { rowsOf } from '../state/document';
import { Dialog } from '../ui/Dialog';
import { library, loadLibrary } from './library';
import type { KeyOf } from './names';
import { freshName } from './place';
import { add } from './things';
import { valueText } from './words';

const allColumns: [KeyOf<'material'>, string][] = [
  ['normal_restitution', 'Rn'],
  ['tangential_restitution', 'Rt'],
  ['friction_angle_deg', 'Friction angle, °'],
  ['roughness_deg', 'Roughness, °'],
  ['dynamic_friction', 'Dynamic friction'],
  ['rolling_friction', 'Rolling friction'],
];

function addMaterial({ key, name }: LibraryMaterial) {
  const isTaken = rowsOf('material').some((row) => row.name === name);
  add('material', { name: isTaken ? freshName(['material'], name) : name, like: key }, `add ${name}`);
}

/// Adds a material with the values of one in the library.
export function LibraryChoice() {
  const [isOpen, open] = useState(false);
  useEffect(loadLibrary, []);
  const columns = allColumns.filter(([key]) => library.value.some(({ values }) => values[key] !== undefined));
  return (
    <>
      <button class="button plain" aria-haspopup="dialog" onClick={() => open(true)}>
        + From the library…
      </button>
      {isOpen && (
        <Dialog title="Add a material from the library" close={() => open(false)}>
          <div class="table-scroll">
            <table>
              <thead>
                <tr>
                  <th scope="col">Material</th>
                  {columns.map(([key, title]) => (
                    <th key={key} scope="col" class="number">
                      {title}
                    </th>
                  ))}
                  <th scope="col">
                    <span class="visually-hidden">Add</span>
                  </th>
                </tr>
              </thead>
              <tbody>
                {library.value.map((material) => (
                  <tr key={material.key}>
                    <th scope="row" title={material.sources.map(({ text }) => text).join('\n')}>
                      {material.name}
                    </th>
                    {columns.map(([key]) => (
                      <td key={key} class="number">
                        {valueText(material.values[key])}
                      </td>
                    ))}
                    <td>
                      <button class="button" aria-label={`Add ${material.name}`} onClick={() => addMaterial(material)}>
                        Add
                      </button>
                    </td>
                  </tr>
                ))}
              </tbody>
            </table>
          </div>
        </Dialog>
      )}
    </>
  );
}
