// The observations of the open project: chosen and imported files, and their places in the views.

import { computed, effect, signal } from '@preact/signals';
import { observing, type ObservedPlace } from '../api/calibration';
import { Refused } from '../api/client';
import type { Point3, Problem } from '../api/types';
import { fittingName, files, inFolder, uploadFiles } from '../project/files';
import { file, fileStem } from '../project/document';
import { reportFailure } from '../state/messages';
import { model } from '../project/model';
import { keptOfProject } from '../project/ofProject';
import { counted } from '../units/numbers';
import { markColours } from '../view/colours';
import type { LegendData } from '../view/legends';
import { layers } from '../view/settings';
import { emptyStudy, type Observation, type ObservationKind, type StudyForm } from './study';

/// The form as the browser keeps it for each project.
const keptForm = keptOfProject<string>('calibration', '');
export const form = computed<StudyForm>(() => {
  void file.value;
  return keptForm.value === '' ? emptyStudy(fileStem()) : (JSON.parse(keptForm.value) as StudyForm);
});
export const setForm = (next: StudyForm) => (keptForm.value = JSON.stringify(next));
export const changeForm = (change: Partial<StudyForm>) => setForm({ ...form.peek(), ...change });

/// Whether the file has places that the views show.
export const hasPlaces = (one: Observation): one is Observation & { kind: 'stops' | 'marks' } =>
  one.kind === 'stops' || one.kind === 'marks';

export const observedStops = computed(() => form.value.observations.filter(({ kind }) => kind === 'stops'));

export function addObservation(name: string, kind: ObservationKind) {
  const { observations } = form.peek();
  if (observations.some((one) => one.file === name && one.kind === kind)) return void ++version.value; // a new version of the file
  changeForm({ observations: [...observations, { kind, file: name }] });
}
export const changeObservation = (index: number, change: Partial<Observation>) =>
  changeForm({ observations: form.peek().observations.map((one, k) => (k === index ? { ...one, ...change } : one)) });
export const removeObservation = (index: number) =>
  changeForm({ observations: form.peek().observations.filter((_, k) => k !== index) });

/// Uploads files beside the project and adds the one with the places.
export async function takeObserved(list: readonly File[], kind: ObservationKind) {
  const project = file.value;
  if (project === null) return;
  const uploaded = await uploadFiles(project, list);
  if (file.value !== project) return;
  const name = fittingName('table', uploaded, files.value);
  if (name !== undefined) addObservation(name, kind);
}

export interface ObservedPlaces {
  kind: 'stops' | 'marks';
  /// On the ground.
  places: Point3[];
}
interface ReadFile {
  places: ObservedPlace[];
  problems: Problem[];
}
const read = signal<Record<string, ReadFile>>({});
/// Incremented when a file may have changed.
const version = signal(0);
let asking: AbortController | undefined;

/// The problems of an observation's file.
export const problemsOfFile = (name: string): Problem[] => read.value[name]?.problems ?? [];
/// The number of places in a file; null while it is unknown.
export const countOf = (name: string): number | null => {
  const known = read.value[name];
  return known && known.places.length > 0 ? known.places.length : null;
};

async function readFiles(id: string, names: readonly string[]) {
  asking?.abort();
  const own = (asking = new AbortController());
  const answers = await Promise.all(
    names.map(async (name): Promise<[string, ReadFile]> => {
      try {
        return [name, await observing.places(id, inFolder(name), own.signal)];
      } catch (error) {
        if (!(error instanceof Refused) || error.problems.length === 0) throw error;
        return [name, { places: [], problems: error.problems }];
      }
    }),
  );
  if (!own.signal.aborted) read.value = Object.fromEntries(answers);
}

effect(() => {
  const [shown] = [model.value, version.value];
  const names = form.value.observations.filter(hasPlaces).map((one) => one.file);
  if (!shown || file.value === null || names.length === 0) {
    asking?.abort();
    if (Object.keys(read.peek()).length > 0) read.value = {};
    return;
  }
  readFiles(shown.id, [...new Set(names)]).catch((error: unknown) => {
    if (!(error instanceof DOMException && error.name === 'AbortError')) reportFailure(error);
  });
});

/// What the views show.
export const shownObserved = computed<ObservedPlaces[]>(() =>
  !layers.observed.value
    ? []
    : form.value.observations.filter(hasPlaces).map(({ kind, file: name }) => ({
        kind,
        places: (read.value[name]?.places ?? []).flatMap(([x, y, z]): Point3[] => (z === null ? [] : [[x, y, z]])),
      })),
);

export function observedLegends(): LegendData[] {
  const kinds = (['stops', 'marks'] as const).flatMap((kind) => {
    const count = shownObserved.value.reduce((sum, one) => sum + (one.kind === kind ? one.places.length : 0), 0);
    const [one, sign] = kind === 'stops' ? ['stop', '◆'] : ['impact mark', '✕'];
    return count > 0 ? [{ name: `${sign} ${counted(count, one)}`, colour: markColours[kind] }] : [];
  });
  return kinds.length > 0 ? [{ kind: 'kinds', title: 'Observed', kinds }] : [];
}
