// When a run ends that the page has watched, its answers come first: forms and tables fold away, and the view shows the
// trajectories, unless the user has moved it meanwhile.

import { computed, effect, untracked } from '@preact/signals';
import { boundsOfPaths } from '../paths/bounds';
import { shownPaths } from '../paths/drawnPaths';
import { file } from '../project/document';
import { areKnown, shown } from '../runs/runs';
import { endedHere } from '../runs/watched';
import { foldForAnswers, unfoldForms } from '../state/panels';
import { camera, cameraText, wantCamera } from '../view/camera';

/// The view when the shown run began.
let begun: { run: string; camera: string | null } | null = null;
effect(() => {
  const run = shown.value;
  if (run && (run.state === 'waiting' || run.state === 'running') && begun?.run !== run.id) begun = { run: run.id, camera: camera.peek() };
});

effect(() => {
  if (endedHere.value !== null) untracked(foldForAnswers);
});

/// The run that ended, once its trajectories are there.
const arrived = computed(() => {
  const paths = shownPaths.value;
  return paths && !paths.header.so_far && paths.run === endedHere.value ? paths.run : null;
});
effect(() => {
  const [run, paths] = [arrived.value, shownPaths.peek()];
  // A view that was never moved shows them anyway.
  if (run === null || begun?.run !== run || begun.camera === null || begun.camera !== camera.peek()) return;
  const section = shown.peek()?.dimension === 2 && paths ? boundsOfPaths(paths) : null;
  // After the forms are folded, and the scene has the trajectories.
  setTimeout(() => wantCamera(section ? cameraText(section) : 'fit'), 100);
});

// A project without results needs its forms.
effect(() => {
  if (file.value !== null && areKnown.value && shown.value === null) untracked(unfoldForms);
});
