// The answers of a run on paper: the cards, the doubts and the view on the first page with lines to sign; the inputs and
// how far the answers move on the second.

import type { AskedAnswer } from '../api/line';
import type { Summary } from '../api/results';
import type { Point2 } from '../api/types';
import { pointsOf } from '../askLine/askTools';
import { enoughText } from '../askLine/enoughText';
import { placeName, type Asked } from '../askLine/shape';
import { percentText } from '../askLine/kit';
import { sourcePlaces, sourceText } from '../askLine/sources';
import { file, savedHash } from '../project/document';
import { model } from '../project/model';
import { hasResults, shown } from '../runs/runs';
import { about } from '../state/about';
import { displayOf } from '../state/displayUnits';
import { counted, fixedText, numberText } from '../units/numbers';
import { projectTitle, titleBlock, titleBlockFacts } from '../view/sheet';
import { cardsOf } from './cards';
import type { Doubt } from './doubts';
import { OneCard } from './OneCard';
import { firstOf } from './firstOf';
import { PrintedInputs, spareLines } from './PrintedInputs';
import { modelOf } from './sheetInputs';
import { PrintedMoves } from './PrintedMoves';
import { arePending, missingOnPaper, printedText, type Ranges } from './ranges';

const [mostCorners, mostDoubts, mostPlaces] = [12, 6, 5];

/// ", 5 m high, 3,000 kJ"
function heightText(name: string): string {
  const barrier = model.value?.barriers.find((each) => each.name === name);
  if (!barrier) return '';
  const capacity = barrier.kind === 'collector' ? '' : barrier.capacity_kJ === null ? ', unlimited capacity' : `, ${numberText(barrier.capacity_kJ)} kJ`;
  return `, ${numberText(barrier.height_m)} m high${capacity}`;
}

const cornerText = (corner: Point2) => (model.value?.dimension === 2 ? `x ${corner[0].toFixed(2)} m` : `(${corner.map((each) => each.toFixed(2)).join(', ')})`);

function Place({ of, now, asItStands }: { of: AskedAnswer; now: Asked; asItStands: string | null }) {
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
      {asItStands !== null && `. As it stands: ${asItStands}`}.
    </p>
  );
}

/// Known while the card of the line is open.
function Places() {
  const places = sourcePlaces.value;
  if (!places || places.length === 0) return null;
  return (
    <section>
      <h3>Where they start</h3>
      <p>{firstOf(places.map(sourceText), mostPlaces, 'in the card of the line').join('; ')}</p>
    </section>
  );
}

function Signatures() {
  const { author, checked, date } = titleBlock();
  return (
    <table class="signatures">
      <tbody>
        <tr>
          {[
            ['Prepared', author],
            ['Checked', checked],
            ['Date', date],
            ['Signature', ''],
          ].map(([what, who]) => (
            <td key={what}>
              <span>{what}</span>
              {who}
            </td>
          ))}
        </tr>
      </tbody>
    </table>
  );
}

/// What stands below the cards: how far each row of theirs goes.
function rowsText(of: AskedAnswer, ranges: Ranges): string[] {
  const spread = of.ensembles;
  const answer = ranges.job?.answer;
  const part = answer && (answer.rocks < answer.planned ? `a fair sample of ${answer.rocks.toLocaleString('en')} of ${counted(answer.planned, 'rock')}` : `the same ${counted(answer.rocks, 'rock')}`);
  const ground = ranges.job?.question.material;
  return [
    `Sampling: with ${Math.round(100 * of.confidence)} % confidence, of the ${of.run.stored.toLocaleString('en')} rocks whose trajectories are stored.`,
    spread ? `Inputs: the range of ${percentText(spread.confidence)} of the ${spread.ensembles} ensembles of this run, each with its own parameters; the chance of their rocks is in it.` : '',
    part && !spread ? `Inputs: ${part}, with each input a step lower and higher${ground ? `, the ground of ${ground} alone` : ''}. Models: with the other rock models. Both in the table of the next page.` : '',
    part && spread ? `Models: ${part}, with the other rock models, in the table of the next page, which also has each input a step lower and higher.` : '',
    part ? '+ chance: to the outermost ends of the intervals of sampling of these sets.' : '',
    printedText(ranges),
  ].filter(Boolean);
}

function Foot({ page }: { page: number }) {
  const run = shown.value!;
  // A run of a text that is not the file's keeps its project in its own folder.
  const source = savedHash.value === null ? 'project not saved' : file.value;
  const facts = [source, `run ${run.name}`, run.begun.slice(0, 10), displayOf('m').unit !== 'm' && 'places and inputs metric', `Talus ${about.value?.version ?? ''}`];
  return (
    <footer>
      <span>{facts.filter(Boolean).join(' · ')}</span>
      <span>{page} of 2</span>
    </footer>
  );
}

export interface SheetProps {
  of: AskedAnswer;
  now: Asked;
  summary: Summary;
  ranges: Ranges;
  doubts: readonly Doubt[];
  /// What an asked barrier stops by its own height and capacity; null: none is asked.
  asItStands: string | null;
  picture: string | null;
}

export function AnswerSheet({ of, now, summary, ranges, doubts, asItStands, picture }: SheetProps) {
  const run = shown.value!;
  const head = (
    <header>
      <h1>{projectTitle()}</h1>
      <p>{titleBlockFacts().join(' · ')}</p>
    </header>
  );
  const { job } = ranges;
  const [remark, enough] = [titleBlock().text, enoughText(of)];
  const cards = cardsOf(of, job?.answer ?? null, placeName(now, run.dimension));
  return (
    <>
      <article>
        {head}
        <Place of={of} now={now} asItStands={asItStands} />
        <p>
          <strong>Rock model</strong> {modelOf(summary.project)}, {counted(Number(summary.rocks.done), 'rock')}.
        </p>
        {remark !== '' && (
          <p>
            <strong>Remark</strong> {remark}
          </p>
        )}
        <div class="answer-cards">
          {cards.map((card) => (
            <OneCard key={card.key} of={card} missing={missingOnPaper[ranges.state]} isPart={arePending(ranges)} isOnPaper />
          ))}
        </div>
        <p class="faint">{rowsText(of, ranges).join(' ')}</p>
        {doubts.length > 0 && (
          <div class="doubts">
            <ul>
              {firstOf(doubts.map(({ text, advice }) => `${text} ${advice}`), mostDoubts, 'in the results').map((text) => (
                <li key={text}>{text}</li>
              ))}
            </ul>
          </div>
        )}
        {enough !== '' && <p>{enough}.</p>}
        {picture && (
          <div class="picture-of-view">
            <img src={picture} alt="The view" />
          </div>
        )}
        <Signatures />
        <Foot page={1} />
      </article>
      <article>
        {head}
        <PrintedInputs of={summary} />
        {job?.answer && <PrintedMoves of={job.answer} question={job.question} spare={spareLines(summary)} />}
        <Places />
        <div class="space" />
        {hasResults(run) && <p class="faint">All results, figures and settings: report.html of the run, in {run.folder}.</p>}
        <Foot page={2} />
      </article>
    </>
  );
}
