// Projects made from the results of a calibration.

import { api } from '../api/client';
import type { CalibrationSummary } from '../archive/calibration';
import { results } from '../api/results';
import type { Run } from '../api/types';
import type { Edit } from '../settings/names';
import { textOf } from '../runs/runText';
import { freshStem, openDerived } from '../project/derivedProject';
import { file } from '../project/document';
import { notify } from '../state/messages';
import { edited } from '../toml/edit';
import { editOf } from './bestFit';
import { form, setForm } from './observations';

export const ensembles = 50;
const rocksEach = 200;

/// Opens a new project and saves it, with the observations of the current one.
async function openNew(name: string, text: string) {
  const observed = form.value;
  await openDerived(name, text, () => setForm({ ...observed, name: name.split('/').at(-1)!.replace(/\.toml$/, '') }));
}

/// A project whose rocks draw their parameters from the posterior, which is copied beside it.
export async function predictWithPosterior(run: Run) {
  const project = file.value;
  if (project === null) return;
  const [text, posterior] = await Promise.all([textOf(run.id), results.fileText(run.id, 'posterior.csv')]);
  const stem = await freshStem(project, 'posterior');
  await api.upload(`${stem}.csv`, new Blob([posterior]));
  const edits: Edit[] = [
    { set: ['sampling', 'parameters'], value: `${stem.split('/').at(-1)!}.csv` },
    { set: ['sampling', 'ensembles'], value: ensembles },
  ];
  await openNew(`${stem}.toml`, edited(text, edits));
  notify(
    'note',
    `Opened ${stem}.toml. Compute it with ${(ensembles * rocksEach).toLocaleString('en')} rocks or more: ${ensembles} ensembles of ${rocksEach}.`,
  );
}

/// A project with the values of the set of least score.
export async function openBestFit(run: Run, summary: CalibrationSummary) {
  const project = file.value;
  if (project === null) return;
  const text = await textOf(run.id);
  const stem = await freshStem(project, 'best');
  const settings = Object.values(summary.best.settings)[0] ?? [];
  await openNew(`${stem}.toml`, edited(text, settings.map(editOf)));
  notify('note', `Opened ${stem}.toml. Its rocks spread less than the posterior's: predict with the posterior.`);
}
