// The terrain: its kind, its files or vertices, and its rotation.

import { useEffect, useRef, useState } from 'preact/hooks';
import { takeDropped, takeStored } from '../dropped/dropped';
import { edit, file } from '../project/document';
import { reportFailure } from '../state/messages';
import { model } from '../project/model';
import { chosenFiles, files, loadFiles, relativeTo } from '../project/files';
import { Field } from './fields/Field';
import { TableForm } from './fields/TableForm';
import { MoreFiles } from './MoreFiles';
import { tableAt } from '../project/place';
import { fieldOf } from '../settings/declared';
import { terrainOfFile } from '../project/terrainFile';
import { changeTo, kindOf, terrainKinds, type TerrainKind } from '../settings/terrainKinds';

export function TerrainForm() {
  const terrain = tableAt(['terrain']);
  const [picked, setPicked] = useState<TerrainKind | null>(null);
  const given = kindOf(terrain);
  const kind = given ?? picked;
  const pick = (next: TerrainKind) => {
    const edits = changeTo(next, terrain);
    setPicked(next);
    if (edits.length > 0) edit(`change the terrain to ${next.title.toLowerCase()}`, edits);
  };
  if (!kind) return <NoTerrain pick={pick} />;
  // Files of this kind that are not chosen yet.
  const missing = kind.keys.filter((key) => terrain[key] === undefined).flatMap((key) => fieldOf('terrain', key) ?? []);
  return (
    <>
      <div class="field">
        <div class="head">
          <label for="terrain-kind">Kind</label>
        </div>
        <select
          id="terrain-kind"
          value={kind.name}
          onChange={(event) => pick(terrainKinds.find(({ name }) => name === event.currentTarget.value)!)}
        >
          {terrainKinds.map(({ name, title }) => (
            <option key={name} value={name}>
              {title}
            </option>
          ))}
        </select>
        <p class="faint">{kind.what}.</p>
      </div>
      {missing.map((field) => (
        <Field key={field.key} field={field} path={['terrain', field.key]} />
      ))}
      <TableForm table="terrain" path={['terrain']} />
      {model.value?.terrain_report && (
        <section class="report" aria-label="Report of the terrain">
          <h3>Report</h3>
          <p>{model.value.terrain_report}</p>
        </section>
      )}
    </>
  );
}

const mostFiles = 12; // offered at once

/// The choices while there is no terrain.
function NoTerrain({ pick }: { pick: (kind: TerrainKind) => void }) {
  useEffect(() => void loadFiles(), []);
  const input = useRef<HTMLInputElement>(null);
  const fitting = files.value.filter(({ name }) => terrainOfFile(name)).map(({ name }) => relativeTo(file.value ?? '', name));
  return (
    <div class="no-terrain">
      <p>No terrain yet. Drop a file here, or choose:</p>
      <button class="button first" onClick={() => input.current?.click()}>
        Upload a terrain file…
      </button>
      <input
        ref={input}
        type="file"
        hidden
        multiple
        aria-label="Upload a terrain file"
        onChange={(event) => void takeDropped(chosenFiles(event.currentTarget)).catch(reportFailure)}
      />
      {fitting.length > 0 && (
        <>
          <h3>Files in the folder</h3>
          {fitting.slice(0, mostFiles).map((name) => (
            <button key={name} class="card" onClick={() => void takeStored([name]).catch(reportFailure)}>
              <span class="name">{name}</span>
            </button>
          ))}
          {fitting.length > mostFiles && <p class="faint">{`and ${fitting.length - mostFiles} more, listed under their kinds`}</p>}
        </>
      )}
      <MoreFiles />
      <h3>Kinds of terrain</h3>
      {terrainKinds.map((kind) => (
        <button key={kind.name} class="card" onClick={() => pick(kind)}>
          <span class="name">{kind.title}</span>
          <span class="faint">{kind.what}</span>
        </button>
      ))}
    </div>
  );
}
