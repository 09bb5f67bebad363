// The start page: the projects of the folder, a new project, examples.

import { useEffect } from 'preact/hooks';
import { signal } from '@preact/signals';
import { api } from '../api/client';
import { listenToDrops } from '../project/terrainFile';
import { about } from '../state/about';
import { reportFailure } from '../state/messages';
import { open } from '../project/opening';
import { compute, ownRuns } from '../runs/runs';
import { showVerification, verifying } from './verifying';
import { beginWith, NewProject } from './NewProject';
import { CardPicture, DeletedProjects, ProjectList } from './ProjectList';
import { examplePicture, examples, loadProjects, setExamples } from './projects';
import { VerificationPage } from './VerificationPage';
import './start.css';

/// A requested address for another browser or a script.
const given = signal<string | null>(null);

async function load() {
  const [list] = await Promise.all([api.examples(), loadProjects()]);
  setExamples(list);
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
  if (verifying.value) return <VerificationPage close={() => showVerification(false)} />;
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
      <ProjectList />
      <NewProject />
      <section aria-labelledby="examples">
        <h2 id="examples">Try an example</h2>
        <div class="cards">
          {examples.value.map(({ id, title, what }) => (
            <button key={id} class="card" onClick={() => openExample(id)}>
              <CardPicture address={examplePicture(id)} />
              <span class="name">{title}</span>
              <span class="faint">{what}</span>
            </button>
          ))}
        </div>
      </section>
      <DeletedProjects />
      <footer class="faint">
        <p>
          Does Talus reproduce published results?{' '}
          <button class="button" onClick={() => showVerification(true)}>
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
