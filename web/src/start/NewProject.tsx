// A new project: its name and its terrain.

import { useRef, useState } from 'preact/hooks';
import { chosenFiles, files, uploadFiles } from '../project/files';
import { endingsOf } from '../settings/fileEndings';
import { terrainAmong, terrainOfFile } from '../project/terrainFile';
import { api } from '../api/client';
import { isTableOrLines, takeStored } from '../dropped/dropped';
import { localDrafts } from '../project/localDrafts';
import { notify, reportFailure } from '../state/messages';
import { start } from '../project/opening';
import { openForm } from '../project/chosen';
import { allWritten } from '../state/writes';
import { fileNameOf, firstText, type Beginning } from './newProject';

/// The names of all projects, including drafts that were never saved.
async function takenNames(): Promise<string[]> {
  await allWritten();
  const { files, drafts } = await api.folder();
  return [...files.map(({ name }) => name), ...drafts, ...localDrafts()];
}

/// Opens a new project. Without a name it is named after its terrain file. Of a file that can be several kinds of
/// terrain, the page asks which.
export async function begin(name: string, beginning: Beginning) {
  const projectName = name.trim() || (beginning.kind === 'file' ? beginning.name.replace(/\.[^.]+$/, '') : 'New slope');
  const asked = beginning.kind === 'file' && isTableOrLines(beginning.name) ? beginning.name : null;
  start(fileNameOf(projectName, await takenNames()), firstText(projectName, asked === null ? beginning : { kind: 'space' }));
  openForm(beginning.kind === 'file' && asked === null ? null : ['terrain']);
  if (asked !== null) await takeStored([asked]);
}

/// Uploads files, and opens a new project if one of them can be a terrain.
export async function beginWith(list: readonly File[], name = '') {
  const uploaded = await uploadFiles('', list);
  const terrain = terrainAmong(uploaded);
  if (terrain) await begin(name, { kind: 'file', name: terrain.name, key: terrain.key });
  else if (uploaded.length > 0)
    notify(
      'note',
      `Talus cannot read this file as terrain. It reads rasters (${endingsOf('raster')}), meshes (${endingsOf('mesh')}), points (${endingsOf('points')}) and lines (${endingsOf('vector')}).`,
    );
}

export function NewProject() {
  const [name, setName] = useState('');
  const input = useRef<HTMLInputElement>(null);
  const beginNow = (beginning: Beginning) => void begin(name, beginning).catch(reportFailure);
  const there = files.value.filter(({ name: file }) => terrainOfFile(file) !== null);
  return (
    <section aria-labelledby="new-project">
      <h2 id="new-project">New project</h2>
      <label class="new-name">
        Name
        <input value={name} placeholder="New slope" onInput={(event) => setName(event.currentTarget.value)} />
      </label>
      <div class="cards">
        <button class="card" onClick={() => beginNow({ kind: 'section' })}>
          <span class="name">Section, 2D</span>
          <span class="faint">Draw or paste a slope in section; it can be extruded later</span>
        </button>
        <button class="card" onClick={() => beginNow({ kind: 'space' })}>
          <span class="name">Empty, 3D</span>
          <span class="faint">Build the slope from closed polylines, or choose a terrain later</span>
        </button>
        <button class="card" onClick={() => input.current?.click()}>
          <span class="name">From a terrain file…</span>
          <span class="faint">A GeoTIFF, a mesh, surveyed points or contours: choose it, or drop it anywhere on this page</span>
        </button>
      </div>
      <input
        ref={input}
        type="file"
        hidden
        multiple
        aria-label="Terrain file"
        onChange={(event) => void beginWith(chosenFiles(event.currentTarget), name).catch(reportFailure)}
      />
      {there.length > 0 && (
        <label class="new-name">
          From a terrain file in the folder
          <select
            value=""
            onChange={(event) => {
              const file = event.currentTarget.value;
              const found = terrainOfFile(file);
              if (found) beginNow({ kind: 'file', name: file, key: found.key });
            }}
          >
            <option value="">choose…</option>
            {there.map(({ name: file }) => (
              <option key={file} value={file}>
                {file}
              </option>
            ))}
          </select>
        </label>
      )}
    </section>
  );
}
