// What was asked of a run, its answers and the view, on a sheet of A4.

import type { AskedAnswer } from '../api/line';
import type { Point2 } from '../api/types';
import { about } from '../state/about';
import { file } from '../state/document';
import { displayOf } from '../state/displayUnits';
import { model } from '../state/model';
import { shown } from '../state/runs';
import { fixedText, numberText } from '../ui/format';
import { projectTitle, titleBlockFacts } from '../view/sheet';
import { asked, kitEnergy, kitHeight } from './asked';
import { Figures, figuresOfArea, figuresOfLine, Shares } from './AskedFigures';
import { pointsOf } from './askTools';
import { kitSentence, kitShare, nearestIndex } from './kit';
import { sourcePlaces, sourceText } from './sources';
import { changeText, figureTitle, nameOf } from './tornadoOf';
import { unitOfChange, whatIf, whatIfFigure } from './whatIf';

const [mostCorners, mostPlaces] = [8, 8];

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

function Kit({ of }: { of: AskedAnswer }) {
  if (of.kind === 'polygon') return null;
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

export function AnswerSheet({ of, picture }: { of: AskedAnswer; picture: string | null }) {
  const run = shown.value!;
  const length = displayOf('m').unit;
  return (
    <>
      <header>
        <h1>{projectTitle()}</h1>
        <p>{titleBlockFacts().join(' · ')}</p>
      </header>
      {picture && <img src={picture} alt="The view" />}
      <h2>What passes</h2>
      <Place of={of} />
      <div class="columns">
        <div>
          <Shares of={of} />
          <Figures of={of.kind === 'polygon' ? figuresOfArea(of) : figuresOfLine(of)} />
          <Kit of={of} />
          {of.enough.text !== '' && <p>{of.enough.text}.</p>}
          <Places />
        </div>
        <Changes />
      </div>
      <footer>
        {[file.value, `run ${run.name}`, run.begun.slice(0, 10), length !== 'm' && 'place in metres', `Talus ${about.value?.version ?? ''}`].filter(Boolean).join(' · ')}
      </footer>
    </>
  );
}
