// The parameters that are sought, with the ranges within which they lie.

import { useEffect } from 'preact/hooks';
import { library, loadLibrary } from '../project/library';
import { TypedInput } from '../ui/TypedInput';
import { values } from '../project/document';
import { inlineText } from '../toml/format';
import { changeForm, form } from './observations';
import { candidatesOf } from './parameters';
import { ProblemsAt } from './ProblemsAt';
import type { Sought } from './study';

const change = (index: number, next: Partial<Sought>) =>
  changeForm({ parameters: form.peek().parameters.map((one, k) => (k === index ? { ...one, ...next } : one)) });
const remove = (index: number) => changeForm({ parameters: form.peek().parameters.filter((_, k) => k !== index) });

function ParameterRow({ index, of, title }: { index: number; of: Sought; title: string | undefined }) {
  const [least, most] = of.range;
  const name = of.path || `parameter ${index + 1}`;
  return (
    <li class="sought">
      <div class="row">
        {title !== undefined ? (
          <strong title={of.path}>{title}</strong>
        ) : (
          <input
            type="text"
            class="typed"
            aria-label={`Path of parameter ${index + 1}`}
            placeholder="analysis.grazing_angle_deg"
            spellcheck={false}
            value={of.path}
            onChange={(event) => change(index, { path: event.currentTarget.value.trim() })}
          />
        )}
        <button class="button icon" aria-label={`Remove ${name}`} title="Remove" onClick={() => remove(index)}>
          ×
        </button>
      </div>
      {of.prior ? (
        <p class="mono">{inlineText(of.prior)}</p>
      ) : (
        <div class="row numbers">
          <label>
            from
            <TypedInput
              label={`Least value of ${name}`}
              value={least}
              take={(value) => typeof value === 'number' && change(index, { range: [value, most] })}
            />
          </label>
          <label>
            to
            <TypedInput
              label={`Greatest value of ${name}`}
              value={most}
              take={(value) => typeof value === 'number' && change(index, { range: [least, value] })}
            />
          </label>
        </div>
      )}
      <ProblemsAt path={`parameter.${index}`} />
    </li>
  );
}

export function ParameterList() {
  useEffect(loadLibrary, []);
  const { parameters } = form.value;
  const candidates = candidatesOf(values.value, library.value);
  const open = candidates.filter(({ path }) => !parameters.some((one) => one.path === path));
  const add = (path: string) => {
    const candidate = candidates.find((one) => one.path === path);
    changeForm({ parameters: [...parameters, { path, range: candidate?.range ?? [0, 1] }] });
  };
  return (
    <section aria-label="Parameters">
      <h3>Parameters that are sought</h3>
      <p class="faint">
        One for every five observations at most. A new one gets the range of the library's published values, or else what
        the setting may be; widen or narrow it to what is known of the ground.
      </p>
      {parameters.length > 0 && (
        <ul class="observations">
          {parameters.map((of, index) => (
            <ParameterRow
              key={index}
              index={index}
              of={of}
              title={candidates.find(({ path }) => path === of.path)?.title}
            />
          ))}
        </ul>
      )}
      <div class="row">
        <select aria-label="Add a parameter" value="" onChange={(event) => event.currentTarget.value && add(event.currentTarget.value)}>
          <option value="">Add a parameter…</option>
          {open.map(({ path, title }) => (
            <option key={path} value={path}>
              {title}
            </option>
          ))}
        </select>
        <button class="button plain" onClick={() => add('')}>
          Another setting
        </button>
      </div>
    </section>
  );
}
