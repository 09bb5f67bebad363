// The answers of the shown run, above the view: what passes the chosen place, and how far to trust it.

import { stop } from '../askLine/whatIf';
import { placeName } from '../askLine/shape';
import { shown } from '../runs/runs';
import { Banner } from './Banner';
import { cardsOf } from './cards';
import { doubts } from './doubtsNow';
import { longerThan, ranges, vary } from './job';
import { lineAnswer } from './lineAnswer';
import { NoPlace } from './NoPlace';
import { OneCard } from './OneCard';
import { place, summary } from './place';
import { PlaceChoice } from './PlaceChoice';
import { missingText, type Ranges } from './ranges';
import { SheetWaits } from './SheetWaits';
import { wantSheet } from './sheetWaits';
import { counted } from '../units/numbers';
import { areOpen, openCards } from './shownCards';
import './placeOverlay';
import './answers.css';

function JobBar({ state, job: of }: Ranges) {
  if (of?.state === 'running') {
    const left = of.seconds_left === null ? '' : `, ${Math.ceil(of.seconds_left)} s left`;
    return (
      <span class="job-bar" title="The same rocks with other inputs and other rock models, in the background">
        <progress aria-label="Other inputs and rock models" max={Math.max(of.planned, 1)} value={of.done} />
        <span class="faint">inputs and models{left}</span>
        <button class="button" onClick={() => void stop()} title="What is done is kept. Another run or another line begins again">
          Stop
        </button>
      </span>
    );
  }
  const isWhole = of?.state === 'done' && of.answer?.variations.some(({ model }) => model !== undefined);
  const longer = isWhole ? longerThan(of) : null;
  if (longer !== null && of?.answer) {
    const { rocks, planned } = of.answer;
    return (
      <button class="button" onClick={() => vary(longer)} title={`The ranges are of ${rocks.toLocaleString('en')} of ${counted(planned, 'rock')}: runs more of them, for ${longer} s at most`}>
        More rocks for the ranges
      </button>
    );
  }
  if (isWhole || state === 'ahead') return null;
  return (
    <button class="button" onClick={() => vary()} title="Runs the same rocks with each input a step lower and higher, and with the other rock models, in the background">
      Vary inputs and models
    </button>
  );
}

export function AnswerCards() {
  const run = shown.value!;
  const [now, found, range] = [place.value, lineAnswer.value, ranges.value];
  const whatIf = range?.job?.answer ?? null;
  const isOpen = areOpen.value;
  const isWaiting = now ? found.value === null && found.error === null : summary.value === null;
  const cards = found.value && now && cardsOf(found.value, whatIf, placeName(now, run.dimension));
  return (
    <section class={`answers ${isOpen ? '' : 'folded'}`} aria-label="Answers" aria-busy={isWaiting}>
      <header>
        <h2>{run.name}</h2>
        <PlaceChoice />
        <span class="space" />
        {range && <JobBar {...range} />}
        {found.value && (
          <button class="button" title="Prints these answers, the view and all inputs, on two pages at most" onClick={wantSheet}>
            A4 sheet
          </button>
        )}
        <button class="button plain icon" aria-expanded={isOpen} aria-label="Answers" title={isOpen ? 'Fold the answers' : 'Show the answers'} onClick={() => openCards(!isOpen)}>
          {isOpen ? '▴' : '▾'}
        </button>
      </header>
      <SheetWaits />
      {isOpen && (
        <>
          {found.error !== null && <p class="problem">{found.error}</p>}
          {!now && summary.value && <NoPlace of={summary.value} />}
          {isWaiting && (
            <div class="answer-cards" aria-hidden="true">
              {['share', 'energy', 'height', 'fence'].map((key) => (
                <div key={key} class="answer-card waiting" />
              ))}
            </div>
          )}
          {cards && (
            <div class="answer-cards">
              {cards.map((card) => (
                <OneCard key={card.key} of={card} missing={missingText[range?.state ?? 'off']} isPart={range?.state === 'running'} />
              ))}
            </div>
          )}
          <Banner of={doubts.value} />
        </>
      )}
    </section>
  );
}
