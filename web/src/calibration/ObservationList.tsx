// The observations of the project: imported files, what they are, and their problems.

import { useEffect, useRef } from 'preact/hooks';
import { chosenFiles, files, fittingFiles, loadFiles, relativeTo } from '../model/files';
import { TypedInput } from '../model/form/TypedInput';
import { rowsOf, file } from '../state/document';
import { reportFailure } from '../state/messages';
import { counted } from '../ui/format';
import {
  addObservation,
  changeObservation,
  countOf,
  form,
  problemsOfFile,
  removeObservation,
  takeObserved,
} from './observations';
import { ProblemsAt } from './ProblemsAt';
import type { Observation, ObservationKind } from './study';

const kinds: Record<ObservationKind, string> = {
  stops: 'Stops',
  marks: 'Impact marks',
  values: 'Values at a line',
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
        <label>
          Accuracy, m
          <TypedInput
            label={`Accuracy in m ${about}`}
            value={of.accuracy_m}
            placeholder="0.5"
            take={(value) => changeObservation(index, { accuracy_m: value as number })}
          />
        </label>
        <label>
          Weight
          <TypedInput
            label={`Weight ${about}`}
            value={of.weight}
            placeholder="1"
            take={(value) => changeObservation(index, { weight: value as number })}
          />
        </label>
      </div>
      {of.kind !== 'values' &&
        problemsOfFile(of.file).map((problem) => (
          <span key={problem.text} class={`problem ${problem.severity}`} role="alert">
            {problem.text}
          </span>
        ))}
      <ProblemsAt path={`observations.${index}`} except={problemsOfFile(of.file)} />
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
