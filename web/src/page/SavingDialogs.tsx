import { useState } from 'preact/hooks';
import { file } from '../project/document';
import { reportFailure } from '../state/messages';
import { askName, conflict, overwrite, reload, saveAs, savingAs, setConflict } from '../project/saving';
import { Dialog } from '../ui/Dialog';

/// The dialogs of saving.
export function SavingDialogs() {
  return (
    <>
      {conflict.value !== null && <Conflict why={conflict.value} />}
      {savingAs.value && <SaveAs />}
    </>
  );
}

function Conflict({ why }: { why: string }) {
  const close = () => setConflict(null);
  const act = (what: () => Promise<unknown>) => {
    close();
    void what().catch(reportFailure);
  };
  return (
    <Dialog title="Not saved" close={close}>
      <p>{why}</p>
      <p class="faint">Reloading replaces what is on this page; this can be undone.</p>
      <div class="choices">
        <button class="button" onClick={() => act(reload)}>
          Reload the file
        </button>
        <button class="button danger" onClick={() => act(overwrite)}>
          Overwrite the file
        </button>
        <button
          class="button first"
          onClick={() => {
            close();
            askName(true);
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
  const [exists, setExists] = useState(false);
  // Shown in the dialog, which covers the messages of the page.
  const [failure, setFailure] = useState<string | null>(null);
  const close = () => askName(false);
  const full = /\.toml$/i.test(name.trim()) ? name.trim() : `${name.trim()}.toml`;
  const act = async (replace: boolean) => {
    setFailure(null);
    if (await saveAs(full, replace)) close();
    else setExists(true);
  };
  return (
    <Dialog title="Save as" close={close}>
      <form
        onSubmit={(event) => {
          event.preventDefault();
          act(exists).catch((error: unknown) => setFailure(error instanceof Error ? error.message : String(error)));
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
            setExists(false);
            setFailure(null);
          }}
        />
        {exists && <span class="problem">A file {full} already exists.</span>}
        {failure !== null && (
          <span class="problem" role="alert">
            {failure}
          </span>
        )}
        <div class="choices">
          <button class={`button ${exists ? 'danger' : 'first'}`} disabled={name.trim() === ''}>
            {exists ? 'Replace the file' : 'Save'}
          </button>
        </div>
      </form>
    </Dialog>
  );
}
