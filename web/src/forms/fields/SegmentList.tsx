// The material of each segment of the section.

import { edit, valueAt } from '../../project/document';
import { model, problemsAt } from '../../project/model';
import type { Path } from '../../settings/names';
import { counted } from '../../units/numbers';
import { cellText } from '../../settings/numbers';
import { is2d, pathText, tableAt, materialNames } from '../../project/place';
import { Choice } from './Choice';
import { problemsId, type FieldProps } from './fieldProps';

export function SegmentList({ field, path }: FieldProps) {
  const value = valueAt(path);
  const given = Array.isArray(value) ? value.map(cellText) : [];
  const words = materialNames();
  const titles = Object.fromEntries(words.map((word) => [word, word]));
  const section = tableAt(['terrain']).section;
  const count = Array.isArray(section) ? Math.max(0, section.length - 1) : 0;
  const standard = cellText(valueAt(['ground', 'default'])) || words[0] || '';
  const all = given.length > 0 ? given : Array<string>(count).fill(standard);
  const own = pathText(path);
  const wrong = new Set(problemsAt(own).flatMap(({ severity, path: at }) => (severity === 'error' ? [at] : [])));
  if (!is2d.value && model.value?.kind === 'raster') return null;
  const choose = (k: number, next: string) =>
    edit(
      `assign ${next} to segment ${k + 1}`,
      given.length > 0 ? [{ set: [...path, k], value: next }] : [{ set: path, value: all.with(k, next) }],
      `${own}.${k}`,
    );
  return (
    <>
      <UnequalNumbers path={path} given={given} count={count} standard={standard} />
      <div class="scroll">
        <table aria-label={field.title}>
          <thead>
            <tr>
              <th scope="col">Segment</th>
              <th scope="col">Material</th>
            </tr>
          </thead>
          <tbody>
            {Array.from({ length: Math.max(all.length, count) }, (_, k) => (
              <tr key={k}>
                <th scope="row">{k + 1}</th>
                <td>
                  {k > all.length ? (
                    <span class="faint">none</span>
                  ) : (
                    <Choice
                      label={`Material of segment ${k + 1}`}
                      words={words}
                      titles={titles}
                      value={all[k]}
                      absent={k < all.length ? '' : 'none'}
                      isOneOfMany
                      invalid={k >= all.length || k >= count || wrong.has(`${own}.${k}`)}
                      describedBy={wrong.has(`${own}.${k}`) ? problemsId(path) : undefined}
                      take={(next) => next !== undefined && choose(k, next)}
                    />
                  )}
                  {k >= count && <span class="problem">the section has no such segment</span>}
                </td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
    </>
  );
}

interface ListProps {
  path: Path;
  given: string[];
  count: number;
  standard: string;
}

/// A notice if the list was edited by hand and its length differs from the number of segments.
function UnequalNumbers({ path, given, count, standard }: ListProps) {
  const missing = count - given.length;
  if (given.length === 0 || missing === 0) return null;
  const filled = [...given.slice(0, count), ...Array<string>(Math.max(0, missing)).fill(standard)];
  return (
    <div>
      <p class="problem warning">
        The project lists {counted(given.length, 'material')} for {counted(count, 'segment')}. Check every segment: if a
        material was left out, all later ones are off by one segment.
      </p>
      <button class="button" onClick={() => edit('fit the materials to the segments', [{ set: path, value: filled }])}>
        {missing > 0
          ? `Assign ${standard} to the last ${missing === 1 ? 'segment' : `${missing} segments`}`
          : `Remove the last ${missing === -1 ? 'material' : `${-missing} materials`}`}
      </button>
    </div>
  );
}
