// The model as forms: an outline of the project, and the form of the selected entry.

import { useEffect, useLayoutEffect, useRef } from 'preact/hooks';
import { rowsOf } from '../project/document';
import { choose, chosen } from '../project/chosen';
import { explainsAll, toggleExplaining } from './fields/explaining';
import type { Path, TableName } from '../settings/names';
import { DraftNotice } from './DraftNotice';
import { TableForm } from './fields/TableForm';
import { Words } from './fields/Words';
import { tableOf } from '../settings/declared';
import { sectionOf } from '../settings/sections';
import { Outline } from './Outline';
import { problemsOfTable, sentenceOf, toneOf } from '../project/awaited';
import { DesignForm } from './DesignForm';
import { GroundForm } from './GroundForm';
import { LibraryNotice } from './LibraryNotice';
import { OwnMaterialButton } from './OwnMaterialButton';
import { followChosen } from '../tools/highlight';
import { TerrainForm } from './TerrainForm';
import { ProblemList } from './ProblemList';
import { UnfinishedList } from './UnfinishedList';
import { nameOf } from '../project/place';
import { copy, remove } from '../project/things';
import '../ui/forms.css';

export function ModelPanel() {
  useEffect(followChosen, []);
  const path = chosen.value;
  const exists = path !== null && (typeof path[1] !== 'number' || rowsOf(path[0] as TableName).length > path[1]);
  // Returning to the outline restores the keyboard focus.
  const last = useRef<string | null>(null);
  useEffect(() => {
    if (exists) last.current = path.join('.');
    else document.querySelector<HTMLElement>(`.outline [data-item="${last.current}"]`)?.focus();
  }, [exists]);
  return (
    <div class="model">
      <DraftNotice />
      <UnfinishedList />
      <ProblemList folded={exists} />
      {exists ? <FormPage key={path.join('.')} path={path} /> : <Outline />}
    </div>
  );
}

function FormPage({ path }: { path: Path }) {
  const section = sectionOf(path)!;
  const [key, index] = [path[0] as TableName, path[1]];
  const isEntry = typeof index === 'number';
  const title = isEntry ? nameOf(key, index) : section.title;
  const description = tableOf(isEntry ? key : section.tables.at(-1)!)?.description ?? '';
  const heading = useRef<HTMLHeadingElement>(null);
  useLayoutEffect(() => {
    heading.current?.closest('.body')?.scrollTo(0, 0);
    heading.current?.focus({ preventScroll: true });
  }, []);
  // Problems of the table as a whole, not of a field.
  const own = problemsOfTable(path, tableOf(key)?.fields.map((field) => field.key) ?? []);
  return (
    <section class="form-page" aria-label={title}>
      <header>
        <button class="button plain back" onClick={() => choose(null)}>
          ‹ Model
        </button>
        <h2 ref={heading} tabIndex={-1}>
          {title}
        </h2>
        <button
          class="button icon"
          aria-pressed={explainsAll.value}
          title="Explain every setting"
          aria-label="Explain every setting"
          onClick={toggleExplaining}
        >
          ?
        </button>
      </header>
      <p class="faint">
        <Words text={description.split(/(?<=\.) /)[0]!} />
      </p>
      {own.map((problem) => (
        <span key={problem.text} class={`problem ${toneOf(problem)}`}>
          {sentenceOf(problem)}
        </span>
      ))}
      {key === 'material' && <LibraryNotice path={path} />}
      {isEntry ? (
        <TableForm table={key} path={path} />
      ) : key === 'terrain' ? (
        <TerrainForm />
      ) : key === 'ground' ? (
        <GroundForm />
      ) : key === 'design' ? (
        <DesignForm />
      ) : (
        section.tables.map((table) => <TableForm key={table} table={table} path={table === '' ? [] : [table]} />)
      )}
      {isEntry && (
        <div class="row acts">
          <button class="button" onClick={() => copy(key, index)}>
            Copy
          </button>
          {key === 'material' && <OwnMaterialButton path={path} />}
          <button class="button danger" onClick={() => remove(key, index)}>
            Delete {key}
          </button>
        </div>
      )}
    </section>
  );
}
