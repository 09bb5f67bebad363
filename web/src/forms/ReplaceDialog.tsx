import { Dialog } from '../ui/Dialog';
import { questions } from '../project/replacing';

/// Asks what to do with an uploaded file whose name exists already.
export function ReplaceDialog() {
  const question = questions.value[0];
  if (!question) return null;
  const { id, name, answer } = question;
  return (
    <Dialog key={id} title={`Replace ${name}?`} close={() => answer('cancel')}>
      <p>
        The folder already has a file <span class="mono">{name}</span>.
      </p>
      <div class="choices">
        <button class="button first" onClick={() => answer('use the existing file')}>
          Use the existing file
        </button>
        <button class="button danger" onClick={() => answer('replace')}>
          Replace the file
        </button>
      </div>
    </Dialog>
  );
}
