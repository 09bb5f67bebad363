// The outline of the project: its sections and entries, with problems and next steps.

import { rowsOf, values } from '../project/document';
import { realProblemsAt, toneOf } from '../project/awaited';
import { choose } from '../project/chosen';
import { NextSteps } from './NextSteps';
import { summaryOf } from './summaries';
import { sections, type Section } from '../settings/sections';
import { add, nextSteps } from '../project/things';
import { is2d, nameOf, materialNames } from '../project/place';
import { materialColour } from '../view/colours';
import { LibraryChoice } from './LibraryChoice';
import { cellText } from '../settings/numbers';
import type { Path } from '../settings/names';

function Badge({ path }: { path: string }) {
  const list = realProblemsAt(path);
  const errors = list.filter((problem) => toneOf(problem) === 'error').length;
  if (list.length === 0) return null;
  return (
    <span class={`badge ${errors > 0 ? 'error' : 'warning'}`} title={list.map(({ text }) => text).join('\n')}>
      {errors > 0 ? errors : list.length}
      <span class="visually-hidden">{errors > 0 ? ' errors' : ' warnings'}</span>
    </span>
  );
}

function Row({
  path,
  title,
  detail,
  colour,
}: {
  path: Path;
  title: string;
  detail: string;
  colour?: string;
}) {
  return (
    <button class="item" data-item={path.join('.')} onClick={() => choose(path)}>
      {colour && <span class="chip" style={{ background: colour }} />}
      <span class="name">{title}</span>
      <span class="faint detail">{detail}</span>
      <Badge path={path.join('.')} />
    </button>
  );
}

/// The colour of a material, or of an area's material.
function colourOf(key: string, index: number): string | undefined {
  if (key === 'material') return materialColour(index);
  const of = key === 'area' ? materialNames().indexOf(cellText(rowsOf(key)[index]?.material)) : -1;
  return of < 0 ? undefined : materialColour(of);
}

function SectionRows({ section }: { section: Section }) {
  const own = section.tables.length > 0 && (
    <Row path={[section.name]} title={section.title} detail={summaryOf(section.name)} />
  );
  const lists = section.lists.filter(({ key, only3d }) => !only3d || !is2d.value || rowsOf(key).length > 0);
  if (lists.length === 0) return own;
  const isAwaited = nextSteps(values.value).some(({ key }) => key === section.name);
  return (
    <section class={isAwaited ? 'awaited' : ''} aria-label={section.title}>
      {own || <h2>{section.title}</h2>}
      {lists.map(({ key }) =>
        rowsOf(key).map((_, index) => (
          <Row
            key={`${key}.${index}`}
            path={[key, index]}
            title={nameOf(key, index)}
            detail={summaryOf(key, index)}
            colour={colourOf(key, index)}
          />
        )),
      )}
      <div class="row adds">
        {lists.map(({ key, one }) => (
          <button key={key} class="button plain" onClick={() => add(key)}>
            + Add {one}
          </button>
        ))}
        {section.name === 'material' && <LibraryChoice />}
      </div>
    </section>
  );
}

export function Outline() {
  return (
    <>
      <NextSteps />
      <nav class="outline" aria-label="Model">
        {sections.map((section) => (
          <SectionRows key={section.name} section={section} />
        ))}
      </nav>
    </>
  );
}
