// Renaming, duplicating and deleting a project.

import { useState } from 'preact/hooks';
import { files } from '../project/files';
import { counted } from '../units/numbers';
import { Dialog } from '../ui/Dialog';
import { copyName, type ListedProject } from './projectList';
import { deleteProject, duplicateProject, renameProject } from './projects';

export type ProjectAction = 'rename' | 'duplicate' | 'delete';

/// Runs a task of a dialog, which shows its failure, since it covers the messages of the page.
function useTask(close: () => void) {
  const [failure, setFailure] = useState<string | null>(null);
  const act = (task: () => Promise<void>) => {
    setFailure(null);
    task().then(close, (error: unknown) => setFailure(error instanceof Error ? error.message : String(error)));
  };
  const shown = failure !== null && (
    <p class="problem" role="alert">
      {failure}
    </p>
  );
  return { act, shown, clear: () => setFailure(null) };
}

function NameDialog({ title, first, verb, take, close, children }: {
  title: string;
  first: string;
  verb: string;
  take: (name: string) => Promise<void>;
  close: () => void;
  children?: preact.ComponentChildren;
}) {
  const [name, setName] = useState(first);
  const { act, shown, clear } = useTask(close);
  const full = /\.toml$/i.test(name.trim()) ? name.trim() : `${name.trim()}.toml`;
  return (
    <Dialog title={title} close={close}>
      <form
        onSubmit={(event) => {
          event.preventDefault();
          act(() => take(full));
        }}
      >
        <label for="project-name">Name of the file</label>
        <input
          id="project-name"
          autofocus
          size={44}
          value={name}
          onInput={(event) => {
            setName(event.currentTarget.value);
            clear();
          }}
        />
        {children}
        {shown}
        <div class="choices">
          <button class="button first" disabled={name.trim() === ''}>
            {verb}
          </button>
        </div>
      </form>
    </Dialog>
  );
}

function DeleteDialog({ project, close }: { project: ListedProject; close: () => void }) {
  const { act, shown } = useTask(close);
  const { file, runs, saved } = project;
  return (
    <Dialog title={`Delete ${file}?`} close={close}>
      <p>
        {saved === null ? 'The draft' : 'The project'}
        {runs > 0 && `, its ${counted(runs, 'run')}`} and its picture are moved to Deleted projects, at the end of this
        page. They can be restored from there. Terrain and other files that it names stay where they are.
      </p>
      {shown}
      <div class="dialog-buttons">
        <button class="button" onClick={close}>
          Keep
        </button>
        <button class="button danger" onClick={() => act(() => deleteProject(file))}>
          Delete
        </button>
      </div>
    </Dialog>
  );
}

export function ProjectDialog({ project, action, close }: { project: ListedProject; action: ProjectAction; close: () => void }) {
  const { file, runs } = project;
  const name = file.slice(file.lastIndexOf('/') + 1);
  if (action === 'delete') return <DeleteDialog project={project} close={close} />;
  if (action === 'duplicate')
    return (
      <NameDialog
        title={`Duplicate ${file}`}
        first={copyName(file, files.value.map((other) => other.name))}
        verb="Duplicate"
        take={(to) => duplicateProject(file, to)}
        close={close}
      >
        <p class="faint">The copy has no runs. It uses the same terrain and other files.</p>
      </NameDialog>
    );
  return (
    <NameDialog title={`Rename ${file}`} first={name} verb="Rename" take={(to) => renameProject(file, to)} close={close}>
      <p class="faint">
        {runs > 0 && `It keeps its ${counted(runs, 'run')}. `}
        Studies next to it follow. The title of the project, in its form, is not changed.
      </p>
    </NameDialog>
  );
}
