// What was not saved in an earlier session, and was taken up.

import { isChanged, savedHash, takenUp } from '../state/document';
import { sayFailure } from '../state/messages';
import { readAgain } from '../state/saving';

export function DraftNotice() {
  if (takenUp.value === null || !isChanged.value) return null;
  const isOutdated = takenUp.value === 'of an earlier file';
  const leave = () => (takenUp.value = null);
  return (
    <div class="problem warning" role="status">
      This is a draft that was not saved.
      {isOutdated && ' The file has been changed since by another program; saving will ask which of them is to stay.'}
      <div class="row">
        <button class="button" onClick={leave}>
          Go on with it
        </button>
        {(isOutdated || savedHash.value !== null) && (
          <button class="button" onClick={() => void readAgain().catch(sayFailure)}>
            Back to the file
          </button>
        )}
      </div>
    </div>
  );
}
