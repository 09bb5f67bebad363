import { Dialog } from '../ui/Dialog';
import { questions } from './replacing';

/// Asks what becomes of a file whose name is taken.
export function ReplaceDialog() {
  const question = questions.value[0];
  if (!question) return null;
  const { id, name, answer } = question;
  return (
    <Dialog key={id} title={`Replace ${name}?`} close={() => answer('neither')}>
      <p>
        The folder has a file <span class="mono">{name}</span> already.
      </p>
      <div class="choices">
        <button class="button first" onClick={() => answer('take what is there')}>
          Take the one that is there
        </button>
        <button class="button danger" onClick={() => answer('replace')}>
          Replace it
        </button>
      </div>
    </Dialog>
  );
}
