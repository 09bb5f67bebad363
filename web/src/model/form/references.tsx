// Settings that name other things of the project: materials, barriers, collectors.

import { edit, rowsOf, valueAt } from '../../state/document';
import { model, problemsAt } from '../../state/model';
import { is2d, nameOf, pathText, put, tableAt } from '../place';
import { absentText } from '../words';
import { cellText } from '../numbers';
import { Choice } from './Choice';
import { sayingsId, type Common, type FieldProps } from './Field';

const names = (key: string) => rowsOf(key).map((_, index) => nameOf(key, index));
export const materialNames = () => names('material');

/// Texts that are the name of something.
export const materialFields = new Set(['ground.default', 'area.material', 'design.protect']);

export function NameChoice({ field, path, ...common }: FieldProps & Common) {
  const words = path[0] === 'design' ? names('collector') : materialNames();
  const titles = Object.fromEntries(words.map((word) => [word, word]));
  return (
    <Choice
      {...common}
      words={words}
      titles={titles}
      value={valueAt(path)}
      absent={absentText(field)}
      take={(next) => put(path, next, field.title)}
    />
  );
}

/// A material for each segment, or some of the barriers and collectors.
export function NameList({ field, path }: FieldProps) {
  const value = valueAt(path);
  const given = Array.isArray(value) ? value.map(cellText) : [];
  if (path[0] === 'ground') return <SegmentList field={field} path={path} given={given} />;
  const words = [...names('barrier'), ...names('collector')];
  const unknown = given.filter((name) => !words.includes(name));
  if (words.length === 0 && unknown.length === 0) return <p class="faint">There are no barriers and collectors yet.</p>;
  return (
    <div>
      {given.length === 0 && <p class="faint">{absentText(field)}</p>}
      {[...words, ...unknown].map((name) => (
        <label key={name} class="check">
          <input
            type="checkbox"
            checked={given.includes(name)}
            onChange={(event) => {
              const next = event.currentTarget.checked ? [...given, name] : given.filter((other) => other !== name);
              put(path, next.length > 0 ? next : undefined, field.title);
            }}
          />
          {name}
        </label>
      ))}
    </div>
  );
}

function SegmentList({ field, path, given }: FieldProps & { given: string[] }) {
  const words = materialNames();
  const titles = Object.fromEntries(words.map((word) => [word, word]));
  const section = tableAt(['terrain']).section;
  const count = Math.max(given.length, Array.isArray(section) ? section.length - 1 : 0);
  const standard = cellText(valueAt(['ground', 'default'])) || words[0] || '';
  const all = Array.from({ length: count }, (_, k) => given[k] ?? standard);
  const own = pathText(path);
  const wrong = new Set(problemsAt(own).flatMap(({ severity, path: at }) => (severity === 'error' ? [at] : [])));
  if (!is2d.value && model.value?.kind === 'raster') return null;
  return (
    <div class="scroll">
      <table aria-label={field.title}>
        <thead>
          <tr>
            <th scope="col">Segment</th>
            <th scope="col">Material</th>
          </tr>
        </thead>
        <tbody>
          {all.map((name, k) => (
            <tr key={k}>
              <th scope="row">{k + 1}</th>
              <td>
                <Choice
                  label={`Material of segment ${k + 1}`}
                  words={words}
                  titles={titles}
                  value={name}
                  absent=""
                  isOneOfMany
                  invalid={wrong.has(`${own}.${k}`)}
                  describedBy={wrong.has(`${own}.${k}`) ? sayingsId(path) : undefined}
                  take={(next) =>
                    next !== undefined &&
                    edit(
                      `make segment ${k + 1} ${next}`,
                      given.length === count
                        ? [{ set: [...path, k], value: next }]
                        : [{ set: path, value: all.with(k, next) }],
                      `${own}.${k}`,
                    )
                  }
                />
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
