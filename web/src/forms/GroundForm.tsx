// The assignment of materials to the ground: one everywhere, by picked segments or triangles, or by files.

import { useState } from 'preact/hooks';
import { edit, rowsOf } from '../project/document';
import { reportFailure } from '../state/messages';
import { model } from '../project/model';
import { counted } from '../units/numbers';
import { assignByClicks, paintArea } from '../tools/assignTool';
import { materialColour } from '../view/colours';
import { Field } from './fields/Field';
import { materialNames, is2d, nameOf, tableAt } from '../project/place';
import { TableForm } from './fields/TableForm';
import { changeWay, groundWays, wayOf, waysFor, type GroundWay } from '../settings/groundWays';
import { fieldOf } from '../settings/declared';
import { kindOf } from '../settings/terrainKinds';

export function GroundForm() {
  const [picked, setPicked] = useState<GroundWay | null>(null);
  const ground = tableAt(['ground']);
  const given = wayOf(ground);
  const way = given.name === 'one' && picked ? picked : given;
  const allowed = waysFor(kindOf(tableAt(['terrain']))?.name ?? '');
  const offered = groundWays.filter((one) => allowed.includes(one) || one === way);
  const pick = (next: GroundWay) => {
    setPicked(next);
    const edits = changeWay(next, ground, materialNames());
    if (edits.length > 0) edit(`ground: ${next.title.toLowerCase()}`, edits);
  };
  // Settings of the chosen way that are not given yet.
  const wanted = way.keys.slice(0, 1).filter((key) => key !== 'triangles' && ground[key] === undefined);
  return (
    <>
      <TableForm table="ground" path={['ground']} only={['default']} />
      <div class="field">
        <div class="head">
          <label for="ground-way">Where materials are</label>
        </div>
        <select
          id="ground-way"
          value={way.name}
          onChange={(event) => pick(groundWays.find(({ name }) => name === event.currentTarget.value)!)}
        >
          {offered.map(({ name, title }) => (
            <option key={name} value={name}>
              {title}
            </option>
          ))}
        </select>
      </div>
      {(way.name === 'segments' || way.name === 'triangles') && <Pickers way={way} />}
      {wanted
        .flatMap((key) => fieldOf('ground', key) ?? [])
        .map((field) => (
          <Field key={field.key} field={field} path={['ground', field.key]} />
        ))}
      <TableForm table="ground" path={['ground']} only={way.keys.filter((key) => key !== 'triangles')} />
      {way.name === 'triangles' && Array.isArray(ground.triangles) && (
        <p class="faint">
          Materials are assigned to {counted(ground.triangles.length, 'triangle')}.
        </p>
      )}
      {!is2d.value && <Painters />}
    </>
  );
}

/// Areas drawn in the view, which override the assignment above.
function Painters() {
  const areas = rowsOf('area').length;
  const rows = rowsOf('material').map((_, k) => ({ name: nameOf('material', k), colour: materialColour(k) }));
  return (
    <div class="pickers">
      <h3>Areas</h3>
      <p class="faint">
        {areas === 0
          ? 'Choose a material, then click around its area in the view. Areas override the settings above.'
          : `${areas === 1 ? 'One area overrides' : `${areas} areas override`} the settings above. Where areas overlap, the later one applies.`}
      </p>
      {rows.map(({ name, colour }, k) => (
        <div key={k} class="row">
          <span class="chip" style={{ background: colour }} />
          <span class="name">{name}</span>
          <button
            class="button"
            disabled={model.value === null}
            aria-label={`Draw an area of ${name}`}
            onClick={() => paintArea(k)}
          >
            Draw
          </button>
        </div>
      ))}
    </div>
  );
}

/// One button per material, which starts picking in the view.
function Pickers({ way }: { way: GroundWay }) {
  const materials = rowsOf('material');
  const isPossible = model.value !== null;
  return (
    <div class="pickers">
      <p class="faint">Choose a material, then click {way.name} in the view.</p>
      {materials.map((_, k) => (
        <div key={k} class="row">
          <span class="chip" style={{ background: materialColour(k) }} />
          <span class="name">{nameOf('material', k)}</span>
          <button
            class="button"
            disabled={!isPossible}
            aria-label={`Pick ${way.name} of ${nameOf('material', k)}`}
            onClick={() => void assignByClicks(k).catch(reportFailure)}
          >
            Pick
          </button>
        </div>
      ))}
      {materials.length < 2 && <p class="faint">Add a second material to have a choice.</p>}
    </div>
  );
}
