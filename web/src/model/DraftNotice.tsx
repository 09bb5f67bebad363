// What was not saved in an earlier session and was taken up, and what others did with the project meanwhile.

import { file, fileStem, isChanged, replaceText, savedHash, takenUp, text } from '../state/document';
import { draftsAside, isChangedElsewhere, letGo } from '../state/drafts';
import { sayFailure } from '../state/messages';
import type { LocalDraft } from '../state/revisions';
import { readAgain } from '../state/saving';

export function DraftNotice() {
  const aside = draftsAside.value.filter((draft) => draft.text !== text.value);
  return (
    <>
      <TakenUp />
      {aside.map((draft) => (
        <Aside key={draft.revision} draft={draft} />
      ))}
      {isChangedElsewhere.value && <Elsewhere />}
    </>
  );
}

const words = {
  'of the file': '',
  'of an earlier file':
    ' The file has been changed since by another program; saving will ask which of them is to stay.',
  'of a file that is gone': ' The file is no longer there; saving writes it again.',
};

function TakenUp() {
  const now = takenUp.value;
  if (now === null || !isChanged.value) return null;
  const leave = () => (takenUp.value = null);
  const hasFile = now === 'of an earlier file' || savedHash.value !== null;
  return (
    <div class="problem warning" role="status">
      This is a draft that was not saved.{words[now]}
      <div class="row">
        <button class="button" onClick={leave}>
          Go on with it
        </button>
        {hasFile && (
          <button class="button" onClick={() => void readAgain().catch(sayFailure)}>
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
  const drop = () => letGo(file.value!, [draft]);
  const take = () => replaceText(draft.text, 'take the other draft');
  return (
    <div class="problem warning" role="status">
      There is another draft of {fileStem()}, kept in this browser on {momentOf(draft.time)}. Neither comes from the
      other; taking it is a step that can be undone.
      <div class="row">
        <button class="button" onClick={take}>
          Take the other draft
        </button>
        <button class="button danger" onClick={drop}>
          Delete the other draft
        </button>
      </div>
    </div>
  );
}

function Elsewhere() {
  return (
    <div class="problem warning" role="status">
      This project is changed in another tab or browser, too. Each keeps what it has; who saves second is asked which of
      them is to stay.
      <div class="row">
        <button class="button" onClick={() => (isChangedElsewhere.value = false)}>
          Go on here
        </button>
      </div>
    </div>
  );
}
