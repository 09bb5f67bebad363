// The inputs of a run on paper: rock model and laws, blocks and releases, materials with their sources, and the files
// with their checksums.

import type { Summary } from '../api/results';
import { entriesIn } from '../archive/summary';
import { counted, numberText } from '../units/numbers';
import { bytesText } from '../units/texts';
import { firstOf } from './firstOf';
import { blocksText, forestsOf, lawsOf, materialsOf, modelOf, originText, type MaterialRow } from './sheetInputs';
import { blockShape, releaseText } from './sheetReleases';

const [mostSeeders, mostMaterials, mostForests, mostSources, mostFiles] = [4, 5, 4, 4, 5];
const inReport = 'in report.html of the run';

/// The sources of values of the library, in the order of their numbers.
const sourcesOf = ({ inputs }: Summary) => [...new Set((inputs?.material_sources ?? []).map(({ source }) => source))];

/// How many of the lines that the inputs may take on paper they leave; a row of a table has two.
export function spareLines(of: Summary): number {
  const left = (most: number, list: readonly unknown[]) => Math.max(0, most - list.length);
  return 2 * left(mostSeeders, entriesIn(of.project, 'seeder')) + 2 * left(mostMaterials, entriesIn(of.project, 'material')) + left(mostSources, sourcesOf(of));
}

/// "and 3 more files, in report.html of the run": how many are left out after the first ones.
function Rest({ of, after, what }: { of: readonly unknown[]; after: number; what: string }) {
  if (of.length <= after) return null;
  return (
    <p>
      and {counted(of.length - after, `more ${what}`)}, {inReport}
    </p>
  );
}

function Model({ of: { project, rocks, seed } }: { of: Summary }) {
  const part = rocks.done !== rocks.planned ? ` of ${numberText(Number(rocks.planned))} planned` : '';
  return (
    <section>
      <h3>Rock model and laws</h3>
      <p>
        <strong>{modelOf(project)}</strong>: {lawsOf(project).join(', ')}. {counted(Number(rocks.done), 'rock')}
        {part}, seed {seed}.
      </p>
    </section>
  );
}

function Blocks({ of: { project, releases } }: { of: Summary }) {
  const seeders = entriesIn(project, 'seeder');
  return (
    <section>
      <h3>Blocks and releases</h3>
      <table class="blocks">
        <thead>
          <tr>
            {['Seeder', 'Size', 'Shape', 'Release', 'Rocks'].map((title) => (
              <th key={title} scope="col">
                {title}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {seeders.slice(0, mostSeeders).map((seeder, k) => (
            <tr key={k}>
              <th scope="row">{String(seeder.name)}</th>
              <td>{blocksText(seeder)}</td>
              <td>{blockShape(project, seeder)}</td>
              <td>{releaseText(seeder)}</td>
              <td>{numberText(Number(releases?.[k]?.rocks ?? seeder.rocks))}</td>
            </tr>
          ))}
        </tbody>
      </table>
      <Rest of={seeders} after={mostSeeders} what="seeder" />
    </section>
  );
}

function Ground({ of }: { of: Summary }) {
  const { project, inputs } = of;
  const { columns, rows } = materialsOf(project);
  const forests = forestsOf(project);
  const sources = inputs?.material_sources ?? [];
  const texts = sourcesOf(of);
  const origin = (row: MaterialRow) => {
    const own = sources.filter(({ material }) => material === row.name);
    const marks = new Set(own.map(({ source }) => texts.indexOf(source) + 1));
    return originText(row, columns, new Set(own.flatMap(({ keys }) => keys)), [...marks]);
  };
  return (
    <section>
      <h3>Ground</h3>
      <table class="materials">
        <thead>
          <tr>
            {['Material', ...columns.map(([, title]) => title), 'Source'].map((title) => (
              <th key={title} scope="col">
                {title}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {rows.slice(0, mostMaterials).map((row) => (
            <tr key={row.name}>
              <th scope="row">{row.name}</th>
              {row.values.map((value, k) => (
                <td key={k}>{value}</td>
              ))}
              <td>{origin(row)}</td>
            </tr>
          ))}
        </tbody>
      </table>
      <Rest of={rows} after={mostMaterials} what="material" />
      {forests.length > 0 && <p>Forests over it: {firstOf(forests, mostForests, inReport).join('; ')}.</p>}
      {firstOf(texts.map((text, k) => `[${k + 1}] ${text}`), mostSources, inReport).map((text) => (
        <p key={text} class="source">
          {text}
        </p>
      ))}
    </section>
  );
}

function Files({ of: { inputs } }: { of: Summary }) {
  const files = inputs?.files ?? [];
  if (files.length === 0) return null;
  return (
    <section>
      <h3>Files, as the run began</h3>
      <table class="checksums">
        <tbody>
          {files.slice(0, mostFiles).map(({ name, bytes, sha256 }) => (
            <tr key={name}>
              <th scope="row">{name}</th>
              <td>{bytesText(Number(bytes))}</td>
              <td class="mono">{sha256}</td>
            </tr>
          ))}
        </tbody>
      </table>
      <Rest of={files} after={mostFiles} what="file" />
    </section>
  );
}

export function PrintedInputs({ of }: { of: Summary }) {
  return (
    <>
      <Model of={of} />
      <Blocks of={of} />
      <Ground of={of} />
      <Files of={of} />
    </>
  );
}
