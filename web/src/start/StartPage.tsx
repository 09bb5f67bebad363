// What a new user sees first: examples that are one click from rocks in motion, the folder's projects, a new one.

import { useEffect } from 'preact/hooks';
import { signal } from '@preact/signals';
import { about } from '../app';
import { api } from '../api/client';
import type { Example, FolderFile } from '../api/types';
import { open } from '../state/document';
import { sayFailure } from '../state/messages';

const examples = signal<Example[]>([]);
const projects = signal<FolderFile[]>([]);

async function load() {
  examples.value = await api.examples();
  projects.value = (await api.files()).filter(({ kind }) => kind === 'project');
}

export function StartPage() {
  useEffect(() => void load().catch(sayFailure), []);
  const openExample = (id: string) =>
    api.openExample(id).then(({ project }) => open(project)).catch(sayFailure);
  return (
    <main class="start">
      <h1>Talus</h1>
      <p class="faint">
        Rockfall on your own slopes: where rocks go, how fast, how high, and what stops them.
        {about.value && ` Version ${about.value.version}, in ${about.value.folder}.`}
      </p>
      <h2 style={{ marginTop: 24 }}>Try an example</h2>
      <div class="cards">
        {examples.value.map(({ id, title, what }) => (
          <button key={id} class="card" onClick={() => void openExample(id)}>
            <span class="name">{title}</span>
            <span class="faint">{what}</span>
          </button>
        ))}
      </div>
      {projects.value.length > 0 && <h2>Projects in this folder</h2>}
      <div class="cards">
        {projects.value.map(({ name, modified }) => (
          <button key={name} class="card" onClick={() => void open(name).catch(sayFailure)}>
            <span class="name">{name}</span>
            <span class="faint">{new Date(modified).toLocaleString()}</span>
          </button>
        ))}
      </div>
    </main>
  );
}
