// What was asked of a run, its answers and the view, on a sheet of A4.

import type { AskedAnswer } from '../api/line';
import type { Summary } from '../api/results';
import type { Point2 } from '../api/types';
import { about } from '../state/about';
import { file } from '../project/document';
import { displayOf } from '../state/displayUnits';
import { model } from '../project/model';
import { shown } from '../runs/runs';
import { isOutdated } from '../runs/outdated';
import { counted, fixedText, numberText } from '../units/numbers';
import { projectTitle, titleBlockFacts } from '../view/sheet';
import { asked, kitEnergy, kitHeight } from './asked';
import { Figures, figuresOfArea, figuresOfLine, Shares } from './AskedFigures';
import { pointsOf } from './askTools';
import { kitSentence, kitShare, nearestIndex } from './kit';
import { materialsOf, modelOf, rocksOf } from './sheetInputs';
import { sourcePlaces, sourceText } from './sources';
import { changeText, figureTitle, nameOf } from './tornadoOf';
import { unitOfChange, whatIf, whatIfFigure } from './whatIf';

const [mostCorners, mostPlaces, mostSeeders, mostMaterials, mostWarnings] = [8, 6, 3, 5, 5];

/// ", 5 m high, 3,000 kJ"
function heightText(name: string): string {
  const barrier = model.value?.barriers.find((each) => each.name === name);
  if (!barrier) return '';
  const capacity = barrier.kind === 'collector' ? '' : barrier.capacity_kJ === null ? ', unlimited capacity' : `, ${numberText(barrier.capacity_kJ)} kJ`;
  return `, ${numberText(barrier.height_m)} m high${capacity}`;
}

const cornerText = (corner: Point2) => (model.value?.dimension === 2 ? `x ${corner[0].toFixed(2)} m` : `(${corner.map((each) => each.toFixed(2)).join(', ')})`);

function Place({ of }: { of: AskedAnswer }) {
  const now = asked.value!;
  const corners = pointsOf(now);
  const is2d = model.value?.dimension === 2;
  const kind = now.kind === 'polygon' ? 'Area' : is2d ? 'Place' : 'Line';
  return (
    <p>
      <strong>{now.kind === 'barrier' ? now.name : kind}</strong>
      {now.kind === 'barrier' && heightText(now.name)}
      {of.kind !== 'polygon' && !is2d && `, ${fixedText(of.length_m, 1)} m long`}
      {corners.length > 0 && `: ${is2d ? '' : 'x, y [m] '}${corners.slice(0, mostCorners).map(cornerText).join(' ')}`}
      {corners.length > mostCorners && ` and ${corners.length - mostCorners} more corners`}
      {model.value?.crs && ` (${model.value.crs})`}
    </p>
  );
}

/// A barrier is judged as it stands, any other line by the kit of the card.
function Kit({ of, asItStands }: { of: AskedAnswer; asItStands: string | null }) {
  if (of.kind === 'polygon') return null;
  if (asItStands !== null) return <p>As it stands: {asItStands}.</p>;
  const { kits } = of;
  const kit = kitShare(kits, nearestIndex(kits.heights_m, kitHeight.value), nearestIndex(kits.energies_kJ, kitEnergy.value));
  return kit && <p>{kitSentence(kit)}.</p>;
}

function Places() {
  const places = sourcePlaces.value;
  if (!places) return null;
  return (
    <section>
      <h3>Where they start</h3>
      <ul>
        {places.slice(0, mostPlaces).map((place) => (
          <li key={place.number}>{sourceText(place)}</li>
        ))}
      </ul>
      {places.length > mostPlaces && <p>and {places.length - mostPlaces} more places</p>}
    </section>
  );
}

function Changes() {
  const [found, by] = [whatIf.value, whatIfFigure.value];
  if (!found?.answer) return null;
  const { answer, question } = found;
  return (
    <section>
      <h3>What if</h3>
      <table>
        <caption>
          Change of the {figureTitle(by, answer).toLowerCase()}, for the same {answer.rocks.toLocaleString('en')} rocks
          {question.material && `, ground of ${question.material} alone`}
        </caption>
        <tbody>
          {answer.variations.map((each) => (
            <tr key={nameOf(each)}>
              <th scope="row">{nameOf(each)}</th>
              <td>{changeText(each.difference[by], unitOfChange(by))}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  );
}

const first = (texts: readonly string[], most: number, what: string) =>
  texts.length > most ? [...texts.slice(0, most), `and ${texts.length - most} more ${what}`] : texts;

function Rocks({ of: { project, rocks, seed } }: { of: Summary }) {
  return (
    <section>
      <h3>Rocks</h3>
      <ul>
        <li>
          {modelOf(project)}, {counted(Number(rocks.done), 'rock')}, seed {seed}
        </li>
        {first(rocksOf(project), mostSeeders, 'seeders').map((text) => (
          <li key={text}>{text}</li>
        ))}
      </ul>
    </section>
  );
}

function Ground({ of: { project } }: { of: Summary }) {
  const { columns, rows } = materialsOf(project);
  return (
    <section>
      <h3>Ground</h3>
      <table class="materials">
        <thead>
          <tr>
            <th scope="col">Material</th>
            {columns.map((title) => (
              <th key={title} scope="col">
                {title}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {rows.slice(0, mostMaterials).map(({ name, values }) => (
            <tr key={name}>
              <th scope="row">{name}</th>
              {values.map((value, k) => (
                <td key={columns[k]}>{value}</td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
      {rows.length > mostMaterials && <p>and {counted(rows.length - mostMaterials, 'more material')}</p>}
    </section>
  );
}

/// "road.toml:31: warning: " of the command line is left out.
const warningText = (text: string) => text.replace(/^(?:.*?: )?warning: /, '');

function Warnings({ of, summary }: { of: AskedAnswer; summary: Summary }) {
  const texts = [
    ...(isOutdated.value ? ['The project has changed since this run.'] : []),
    ...of.problems.map(({ text }) => text),
    ...summary.warnings.map(warningText),
  ];
  if (texts.length === 0) return null;
  return (
    <section>
      <h3>Warnings</h3>
      <ul>
        {first(texts, mostWarnings, 'warnings, in the report').map((text) => (
          <li key={text}>{text}</li>
        ))}
      </ul>
    </section>
  );
}

interface Props {
  of: AskedAnswer;
  summary: Summary;
  /// What an asked barrier stops by its own height and capacity; null: none is asked.
  asItStands: string | null;
  picture: string | null;
}

export function AnswerSheet({ of, summary, asItStands, picture }: Props) {
  const run = shown.value!;
  const length = displayOf('m').unit;
  return (
    <>
      <header>
        <h1>{projectTitle()}</h1>
        <p>{titleBlockFacts().join(' · ')}</p>
      </header>
      {picture && (
        <div class="picture-of-view">
          <img src={picture} alt="The view" />
        </div>
      )}
      <h2>What passes</h2>
      <Place of={of} />
      <div class="columns">
        <div>
          <Shares of={of} />
          <Figures of={of.kind === 'polygon' ? figuresOfArea(of) : figuresOfLine(of)} />
          <Kit of={of} asItStands={asItStands} />
          {of.enough.text !== '' && <p>{of.enough.text}.</p>}
          <Places />
        </div>
        <div>
          <Rocks of={summary} />
          <Ground of={summary} />
          <Changes />
          <Warnings of={of} summary={summary} />
        </div>
      </div>
      <footer>
        {[file.value, `run ${run.name}`, run.begun.slice(0, 10), length !== 'm' && 'place in metres', `Talus ${about.value?.version ?? ''}`].filter(Boolean).join(' · ')}
      </footer>
    </>
  );
}
