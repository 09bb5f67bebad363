// Runs the study of the panel, and opens studies of the folder.

import { signal } from '@preact/signals';
import { api, Refused } from '../api/client';
import type { Problem } from '../api/types';
import { files, loadFiles, relativeTo } from '../project/files';
import { file, fileStem, isChanged, opening } from '../project/document';
import { reportFailure, resolve } from '../state/messages';
import { ofProject } from '../project/ofProject';
import { showCalibration, takeAnswer } from '../runs/runs';
import { save } from '../project/saving';
import { valuesOf } from '../toml/values';
import { changeForm, form, setForm } from './observations';
import { formOf, studyEnding, studyText } from './study';

/// The problems of the study that was last sent.
export const studyProblems = ofProject<Problem[]>([]);
export const isSending = signal(false);

const baseName = (name: string) => name.split('/').at(-1)!;
const besideProject = (name: string) => [...(file.peek() ?? '').split('/').slice(0, -1), name].join('/');

/// Saves the project, writes the study file beside it, and calibrates.
export async function calibrate() {
  const project = file.value;
  if (project === null) return;
  const asked = opening.value;
  if (isChanged.value) await save();
  if (isChanged.value || opening.value !== asked) return; // the reason is shown
  const study = form.value;
  const name = study.name + studyEnding;
  isSending.value = true;
  try {
    const run = await api.calibrate(besideProject(name), studyText(study, baseName(project)), study.written === name);
    if (opening.value !== asked) return;
    resolve('calibrate');
    studyProblems.value = [];
    takeAnswer(run);
    showCalibration(run.id);
    changeForm({ written: name });
    void loadFiles();
  } catch (error) {
    if (opening.value !== asked) return;
    if (error instanceof Refused && error.problems.length > 0) studyProblems.value = error.problems;
    else reportFailure(error, 'calibrate');
  } finally {
    isSending.value = false;
  }
}

/// The studies beside the project, by the names of their files.
export const studiesBeside = () =>
  files.value
    .filter(({ kind }) => kind === 'study')
    .map(({ name }) => relativeTo(file.value ?? '', name))
    .filter((name) => !name.includes('/'));

export async function openStudy(name: string) {
  try {
    const { text } = await api.project(besideProject(name));
    setForm(formOf(valuesOf(text), name.slice(0, -studyEnding.length), `${fileStem()}.toml`));
    studyProblems.value = [];
    resolve('calibrate');
  } catch (error) {
    reportFailure(error, 'calibrate');
  }
}
