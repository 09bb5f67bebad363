// The projects of the folder as cards with pictures.

import { useState } from 'preact/hooks';
import { hasMoreFiles } from '../project/files';
import { MoreFiles } from '../forms/MoreFiles';
import { stateText } from '../runList/RunStateText';
import { reportFailure } from '../state/messages';
import { open } from '../project/opening';
import { runs } from '../runs/runs';
import { bytesText, momentText } from '../units/texts';
import { counted } from '../units/numbers';
import { Popover } from '../ui/Popover';
import { ProjectDialog, type ProjectAction } from './ProjectDialogs';
import { isFound, type ListedProject } from './projectList';
import { deleted, eraseProject, pictureOf, projectsNow, restoreProject } from './projects';

const searchable = 6; // from so many projects on, they can be searched

const actions: Record<ProjectAction, string> = { rename: 'Rename…', duplicate: 'Duplicate…', delete: 'Delete…' };

function facts({ saved, hasDraft, last, runs }: ListedProject): string[] {
  if (saved === null) return ['draft, never saved'];
  const file = `${momentText(saved.modified)} · ${bytesText(saved.bytes)}${hasDraft ? ', with an unsaved draft' : ''}`;
  return last === null ? [file] : [file, `${stateText(last)}, ${counted(last.rocks, 'rock')} · ${counted(runs, 'run')}`];
}

function ProjectCard({ project, ask }: { project: ListedProject; ask: (action: ProjectAction) => void }) {
  const { file, last } = project;
  const at = file.lastIndexOf('/') + 1;
  return (
    <li class="project-card">
      <button class="card" onClick={() => void open(file).catch(reportFailure)}>
        <CardPicture address={pictureOf(project)} />
        <span class="name">
          <span class="faint">{file.slice(0, at)}</span>
          {file.slice(at)}
        </span>
        {last && last.project !== '' && <span>{last.project}</span>}
        {facts(project).map((fact) => (
          <span key={fact} class="faint">
            {fact}
          </span>
        ))}
      </button>
      <Popover title="⋯" label={`Rename, duplicate or delete ${file}`}>
        {(Object.keys(actions) as ProjectAction[]).map((action) => (
          <button
            key={action}
            class={`button plain ${action === 'delete' ? 'danger' : ''}`}
            onClick={(event) => {
              event.currentTarget.closest('details')!.open = false;
              ask(action);
            }}
          >
            {actions[action]}
          </button>
        ))}
      </Popover>
    </li>
  );
}

/// A picture, or an empty place for it.
export function CardPicture({ address }: { address: string | null }) {
  return <span class="card-picture">{address !== null && <img src={address} alt="" loading="lazy" />}</span>;
}

export function ProjectList() {
  const [search, setSearch] = useState('');
  const [asked, ask] = useState<{ project: ListedProject; action: ProjectAction } | null>(null);
  const all = projectsNow(runs.value);
  const found = all.filter((project) => isFound(project, search));
  return (
    <>
      {(all.length > 0 || hasMoreFiles.value) && (
        <section aria-labelledby="projects">
          <div class="projects-head">
            <h2 id="projects">Projects in this folder</h2>
            {(all.length >= searchable || search !== '') && (
              <input
                type="search"
                aria-label="Search projects"
                placeholder="Search"
                value={search}
                onInput={(event) => setSearch(event.currentTarget.value)}
              />
            )}
          </div>
          <MoreFiles />
          {all.length > 0 && found.length === 0 && <p class="faint">No project has “{search}” in its name.</p>}
          <ul class="cards">
            {found.map((project) => (
              <ProjectCard key={project.file} project={project} ask={(action) => ask({ project, action })} />
            ))}
          </ul>
        </section>
      )}
      {asked && <ProjectDialog {...asked} close={() => ask(null)} />}
    </>
  );
}

export function DeletedProjects() {
  if (deleted.value.length === 0) return null;
  return (
    <details class="deleted">
      <summary>Deleted projects ({deleted.value.length})</summary>
      <ul>
        {deleted.value.map(({ id, file, deleted: when, runs }) => (
          <li key={id}>
            <span class="mono">{file}</span>
            <span class="faint">
              deleted {momentText(when)}
              {runs > 0 && `, with ${counted(runs, 'run')}`}
            </span>
            <button class="button" aria-label={`Restore ${file}`} onClick={() => restoreProject(id)}>
              Restore
            </button>
            <button class="button plain danger" aria-label={`Delete ${file} for good`} onClick={() => eraseProject(id)}>
              Delete for good
            </button>
          </li>
        ))}
      </ul>
    </details>
  );
}
