// The observations of the project: imported files, what they are, and their problems.

import { useEffect, useRef } from 'preact/hooks';
import { chosenFiles, files, fittingFiles, loadFiles, relativeTo } from '../project/files';
import { TypedInput } from '../ui/TypedInput';
import { rowsOf, file } from '../project/document';
import { reportFailure } from '../state/messages';
import { counted } from '../units/numbers';
import {
  addObservation,
  changeObservation,
  countOf,
  form,
  hasPlaces,
  problemsOfFile,
  removeObservation,
  takeObserved,
} from './observations';
import { ProblemsAt } from './ProblemsAt';
import { numbersOfKind, type Observation, type ObservationKind, type ObservationNumber } from './study';

const kinds: Record<ObservationKind, string> = {
  stops: 'Stops',
  marks: 'Impact marks',
  values: 'Values at a line',
  zones: 'Deposits by zone',
};
/// With the defaults of `talus calibrate`.
const numbers: Record<ObservationNumber, { title: string; usual: string; what: string }> = {
  accuracy_m: { title: 'Accuracy, m', usual: '0.5', what: 'Standard deviation of an observed place or height' },
  weight: { title: 'Weight', usual: '1', what: 'Less than 1 where rocks were not independent of each other' },
  released: { title: 'Released', usual: '', what: 'Volume in m³ or number of all rocks that were released' },
  blocks: { title: 'Blocks', usual: '', what: 'How many rocks the volumes or shares consist of' },
  relative_accuracy: { title: 'Relative accuracy', usual: '0.2', what: 'Standard deviation of an observed volume or share, over itself' },
};

function ObservationRow({ index, of }: { index: number; of: Observation }) {
  const count = countOf(of.file);
  const lines = [...rowsOf('collector'), ...rowsOf('barrier')].flatMap(({ name }) => (typeof name === 'string' ? [name] : []));
  const about = `of ${of.file}`;
  return (
    <li class="observation">
      <div class="row">
        <strong>{of.file}</strong>
        {count !== null && <span class="faint">{counted(count, 'place')}</span>}
        <button class="button icon" aria-label={`Remove ${of.file}`} title="Remove" onClick={() => removeObservation(index)}>
          ×
        </button>
      </div>
      <div class="row">
        <select
          aria-label={`Kind ${about}`}
          value={of.kind}
          onChange={(event) => changeObservation(index, { kind: event.currentTarget.value as ObservationKind })}
        >
          {Object.entries(kinds).map(([kind, title]) => (
            <option key={kind} value={kind}>
              {title}
            </option>
          ))}
        </select>
        {of.kind === 'values' && (
          <select
            aria-label={`Line ${about}`}
            value={of.at ?? ''}
            onChange={(event) => changeObservation(index, { at: event.currentTarget.value })}
          >
            <option value="">which line?</option>
            {lines.map((name) => (
              <option key={name} value={name}>
                {name}
              </option>
            ))}
          </select>
        )}
      </div>
      <div class="row numbers">
        {numbersOfKind(of.kind).map((key) => (
          <label key={key} title={numbers[key].what}>
            {numbers[key].title}
            <TypedInput
              label={`${numbers[key].title} ${about}`}
              value={of.numbers?.[key]}
              placeholder={numbers[key].usual}
              take={(value) => {
                const { [key]: _, ...others } = of.numbers ?? {};
                changeObservation(index, { numbers: typeof value === 'number' ? { ...others, [key]: value } : others });
              }}
            />
          </label>
        ))}
      </div>
      {hasPlaces(of) &&
        problemsOfFile(of.file).map((problem) => (
          <span key={problem.text} class={`problem ${problem.severity}`} role="alert">
            {problem.text}
          </span>
        ))}
      <ProblemsAt path={`observations.${index}`} except={hasPlaces(of) ? problemsOfFile(of.file) : []} />
    </li>
  );
}

function Import({ kind, title }: { kind: ObservationKind; title: string }) {
  const input = useRef<HTMLInputElement>(null);
  return (
    <>
      <button class="button" onClick={() => input.current?.click()}>
        {title}
      </button>
      <input
        ref={input}
        type="file"
        hidden
        multiple
        aria-label={`Import ${kinds[kind].toLowerCase()}`}
        onChange={(event) => void takeObserved(chosenFiles(event.currentTarget), kind).catch(reportFailure)}
      />
    </>
  );
}

export function ObservationList() {
  useEffect(() => void loadFiles(), []);
  const { observations } = form.value;
  const project = file.value ?? '';
  const taken = new Set(observations.map((one) => one.file));
  const others = fittingFiles('table', files.value)
    .map(({ name }) => relativeTo(project, name))
    .filter((name) => !taken.has(name));
  return (
    <section aria-label="Observations">
      <h3>Observations</h3>
      <p class="faint">
        A CSV file with columns x_m and y_m (in a section x_m alone), or points of a GeoPackage, Shapefile or GeoJSON. You
        may also drop a file on the page.
      </p>
      {observations.length > 0 && (
        <ul class="observations">
          {observations.map((of, index) => (
            <ObservationRow key={`${of.file} ${index}`} index={index} of={of} />
          ))}
        </ul>
      )}
      <div class="row">
        <Import kind="stops" title="Import stops…" />
        <Import kind="marks" title="Import marks…" />
        {others.length > 0 && (
          <select
            aria-label="Add a file of the folder"
            value=""
            onChange={(event) => event.currentTarget.value && addObservation(event.currentTarget.value, 'stops')}
          >
            <option value="">From the folder…</option>
            {others.map((name) => (
              <option key={name} value={name}>
                {name}
              </option>
            ))}
          </select>
        )}
      </div>
    </section>
  );
}
