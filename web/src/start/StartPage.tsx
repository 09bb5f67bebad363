// The start page: examples, a new project, the projects of the folder.

import { useEffect } from 'preact/hooks';
import { signal } from '@preact/signals';
import { api } from '../api/client';
import type { Example } from '../api/types';
import { files, hasMoreFiles, readFolder } from '../model/files';
import { MoreFiles } from '../model/MoreFiles';
import { listenToDrops } from '../model/terrainFile';
import { about } from '../state/about';
import { localDrafts } from '../state/localDrafts';
import { reportFailure } from '../state/messages';
import { open } from '../state/opening';
import { compute, ownRuns } from '../state/runs';
import { verifying } from '../state/view';
import { allWritten } from '../state/writes';
import { beginWith, NewProject } from './NewProject';
import { VerificationPage } from './VerificationPage';
import './start.css';

const examples = signal<Example[]>([]);
const drafts = signal<string[]>([]);
/// A requested address for another browser or a script.
const given = signal<string | null>(null);

async function load() {
  await allWritten(); // including the draft of the project that was just closed
  const [list, folder] = await Promise.all([api.examples(), readFolder()]);
  examples.value = list;
  drafts.value = folder.drafts;
}

/// Opens an example, and runs it if it has no run yet.
async function show(id: string) {
  const { project } = await api.openExample(id);
  await open(project);
  if (ownRuns.value.length === 0) await compute();
}

export function StartPage() {
  useEffect(() => void load().catch(reportFailure), []);
  useEffect(() => listenToDrops((list) => beginWith(list)), []);
  if (verifying.value) return <VerificationPage close={() => (verifying.value = false)} />;
  const openExample = (id: string) => void show(id).catch(reportFailure);
  return (
    <main class="start">
      <header>
        <img class="logo" src="/icon.svg" alt="" />
        <div>
          <h1>Talus</h1>
          <p class="faint">Rockfall on your own slopes: where rocks go, how fast, how high, and what stops them.</p>
        </div>
      </header>
      <section aria-labelledby="examples">
        <h2 id="examples">Try an example</h2>
        <div class="cards">
          {examples.value.map(({ id, title, what }) => (
            <button key={id} class="card" onClick={() => openExample(id)}>
              <span class="name">{title}</span>
              <span class="faint">{what}</span>
            </button>
          ))}
        </div>
      </section>
      <NewProject />
      <Projects />
      <footer class="faint">
        <p>
          Does Talus reproduce published results?{' '}
          <button class="button" onClick={() => (verifying.value = true)}>
            Run the verification cases
          </button>
        </p>
        <p>
          <button class="button" onClick={() => void api.newAddress().then((address) => (given.value = address), reportFailure)}>
            Address for another browser
          </button>{' '}
          {given.value && (
            <>
              <output class="mono">{given.value}</output> works once.
            </>
          )}
        </p>
        {about.value && (
          <p>
            Version {about.value.version}, working in <span class="mono">{about.value.folder}</span>
          </p>
        )}
      </footer>
    </main>
  );
}

function Projects() {
  const projects = files.value.filter(({ kind }) => kind === 'project');
  const drafted = [...new Set([...drafts.value, ...localDrafts()])];
  const unsaved = drafted.filter((draft) => !projects.some(({ name }) => name === draft));
  if (projects.length + unsaved.length === 0 && !hasMoreFiles.value) return null;
  const openFile = (name: string) => void open(name).catch(reportFailure);
  return (
    <section aria-labelledby="projects">
      <h2 id="projects">Projects in this folder</h2>
      <MoreFiles />
      <div class="cards">
        {unsaved.map((name) => (
          <button key={name} class="card" onClick={() => openFile(name)}>
            <span class="name">{name}</span>
            <span class="faint">draft, never saved</span>
          </button>
        ))}
        {projects.map(({ name, modified }) => (
          <button key={name} class="card" onClick={() => openFile(name)}>
            <span class="name">{name}</span>
            <span class="faint">
              {new Date(modified).toLocaleString('en-GB', { dateStyle: 'medium', timeStyle: 'short' })}
              {drafted.includes(name) && ', with an unsaved draft'}
            </span>
          </button>
        ))}
      </div>
    </section>
  );
}
