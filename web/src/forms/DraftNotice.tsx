// Notices about unsaved drafts of earlier sessions and about concurrent changes of the project.

import { file, fileStem, isChanged, noteRestored, replaceText, restored, savedHash, text } from '../project/document';
import { discard, dismissElsewhere, draftsAside, isChangedElsewhere } from '../project/drafts';
import { reportFailure } from '../state/messages';
import type { LocalDraft } from '../project/revisions';
import { reload } from '../project/saving';

export function DraftNotice() {
  const aside = draftsAside.value.filter((draft) => draft.text !== text.value);
  return (
    <>
      <Restored />
      {aside.map((draft) => (
        <Aside key={draft.revision} draft={draft} />
      ))}
      {isChangedElsewhere.value && <Elsewhere />}
    </>
  );
}

const notes = {
  'of the file': '',
  'of an earlier file': ' Another program has changed the file since. Saving will ask which version to keep.',
  'of a deleted file': ' The file no longer exists. Saving creates it again.',
};

function Restored() {
  const state = restored.value;
  if (state === null || !isChanged.value) return null;
  const dismiss = () => noteRestored(null);
  const hasFile = state === 'of an earlier file' || savedHash.value !== null;
  return (
    <div class="problem warning" role="status">
      This is an unsaved draft.{notes[state]}
      <div class="row">
        <button class="button" onClick={dismiss}>
          Keep the draft
        </button>
        {hasFile && (
          <button class="button" onClick={() => void reload().catch(reportFailure)}>
            Back to the file
          </button>
        )}
      </div>
    </div>
  );
}

const momentOf = (time: number) =>
  new Date(time).toLocaleString('en-GB', { dateStyle: 'medium', timeStyle: 'short' });

function Aside({ draft }: { draft: LocalDraft }) {
  const remove = () => discard(file.value!, [draft]);
  const use = () => replaceText(draft.text, 'use the other draft');
  return (
    <div class="problem warning" role="status">
      There is another draft of {fileStem()}, stored in this browser on {momentOf(draft.time)}. Neither is based on the
      other. Switching to it can be undone.
      <div class="row">
        <button class="button" onClick={use}>
          Use the other draft
        </button>
        <button class="button danger" onClick={remove}>
          Delete the other draft
        </button>
      </div>
    </div>
  );
}

function Elsewhere() {
  return (
    <div class="problem warning" role="status">
      This project is also being edited in another tab or browser. Each keeps its own draft; the second to save is asked
      which version to keep.
      <div class="row">
        <button class="button" onClick={dismissElsewhere}>
          Continue here
        </button>
      </div>
    </div>
  );
}
