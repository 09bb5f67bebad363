// Opens a 2D project of the ground section.

import type { GroundSection, Point2 } from '../api/types';
import { freshStem, openDerived } from '../project/derivedProject';
import { file, fileStem, text, values } from '../project/document';
import { notify } from '../state/messages';
import { model } from '../project/model';
import { corridorWidth } from './corridorSettings';
import { longestPart, sectionProject } from './sectionProject';

export async function makeSectionProject(section: GroundSection, line: readonly Point2[]) {
  const [project, now] = [file.value, model.value];
  if (project === null || now === null) return;
  if (longestPart(section).vertices.length < 2) return notify('error', 'There is no terrain along this line.', 'section project');
  const name = typeof values.value.name === 'string' ? values.value.name : fileStem();
  const made = sectionProject(text.value, values.value, now, section, line, corridorWidth.value, `${name}, section`);
  const stem = await freshStem(project, 'section');
  await openDerived(`${stem}.toml`, made.text);
  notify('note', [`Opened ${stem}.toml: the section, with x along the line.`, ...made.notes].join(' '));
}
