import { useState } from 'preact/hooks';
import { file } from '../state/document';
import { sayFailure } from '../state/messages';
import { conflict, overwrite, readAgain, saveAs, savingAs } from '../state/saving';
import { Dialog } from './Dialog';

/// What saving asks the user.
export function SavingDialogs() {
  return (
    <>
      {conflict.value !== null && <Conflict why={conflict.value} />}
      {savingAs.value && <SaveAs />}
    </>
  );
}

function Conflict({ why }: { why: string }) {
  const close = () => (conflict.value = null);
  const act = (what: () => Promise<unknown>) => {
    close();
    void what().catch(sayFailure);
  };
  return (
    <Dialog title="Not saved" close={close}>
      <p>{why}</p>
      <p class="faint">Reading it again replaces what is on this page; that can be undone.</p>
      <div class="choices">
        <button class="button" onClick={() => act(readAgain)}>
          Read it again
        </button>
        <button class="button danger" onClick={() => act(overwrite)}>
          Overwrite it
        </button>
        <button
          class="button first"
          onClick={() => {
            close();
            savingAs.value = true;
          }}
        >
          Save as…
        </button>
      </div>
    </Dialog>
  );
}

function SaveAs() {
  const [name, setName] = useState((file.value ?? 'project.toml').replace(/\.toml$/, ' copy.toml'));
  const [isThere, setIsThere] = useState(false);
  // Said here: messages of the page lie below a dialog.
  const [failure, setFailure] = useState<string | null>(null);
  const close = () => (savingAs.value = false);
  const full = /\.toml$/i.test(name.trim()) ? name.trim() : `${name.trim()}.toml`;
  const act = async (replace: boolean) => {
    setFailure(null);
    if (await saveAs(full, replace)) close();
    else setIsThere(true);
  };
  return (
    <Dialog title="Save as" close={close}>
      <form
        onSubmit={(event) => {
          event.preventDefault();
          act(isThere).catch((error: unknown) => setFailure(error instanceof Error ? error.message : String(error)));
        }}
      >
        <label for="save-as-name">Name of the file in the folder</label>
        <input
          id="save-as-name"
          autofocus
          size={44}
          value={name}
          onInput={(event) => {
            setName(event.currentTarget.value);
            setIsThere(false);
            setFailure(null);
          }}
        />
        {isThere && <span class="problem">There is a file {full} already.</span>}
        {failure !== null && (
          <span class="problem" role="alert">
            {failure}
          </span>
        )}
        <div class="choices">
          <button class={`button ${isThere ? 'danger' : 'first'}`} disabled={name.trim() === ''}>
            {isThere ? 'Replace it' : 'Save'}
          </button>
        </div>
      </form>
    </Dialog>
  );
}
