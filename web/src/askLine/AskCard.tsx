// The docked card: what is asked, and the answer of the shown run.

import { useEffect, useRef } from 'preact/hooks';
import type { LineAnswer, PolygonAnswer } from '../api/line';
import { tool } from '../tools/tool';
import { crossingRocks, filter, filterBy } from '../runs/filter';
import { hasResults, shown } from '../runs/runs';
import { answer, asked, isWaiting, openCard, refusal } from './asked';
import { AskedChoices } from './AskedChoices';
import { Figures, figuresOfArea, figuresOfLine, Shares } from './AskedFigures';
import { AskedPoints } from './AskedPoints';
import { BuildHere } from './BuildHere';
import { EnoughRocks } from './EnoughRocks';
import { KitSlider } from './KitSlider';
import { ProfileOfLine } from './ProfileOfLine';
import { missingPoints } from './shape';
import { Sources } from './Sources';
import { WhatIf } from './WhatIf';
import './askedOverlay';
import './askLine.css';

function OnlyThese({ what }: { what: string }) {
  const isOn = filter.value.crossing !== null;
  return (
    <label class="choice" title="In the views, the sections, the tables and the figures">
      <input
        type="checkbox"
        checked={isOn}
        disabled={!answer.value || !crossingRocks.value}
        onChange={(event) => filterBy({ crossing: event.currentTarget.checked ? (answer.value?.selection ?? null) : null })}
      />
      Only rocks that {what}
    </label>
  );
}

function OfLine({ of }: { of: LineAnswer }) {
  const { rocks } = of.whole;
  return (
    <>
      <Shares of={of} />
      <EnoughRocks of={of} />
      {rocks > 0 && (
        <>
          <Figures of={figuresOfLine(of)} />
          <KitSlider of={of.kits} />
          <ProfileOfLine of={of} />
        </>
      )}
      <OnlyThese what="cross" />
      {of.sources && <Sources hasKit />}
      <WhatIf />
      {rocks > 0 && <BuildHere of={of} />}
    </>
  );
}

function OfPolygon({ of }: { of: PolygonAnswer }) {
  return (
    <>
      <Shares of={of} />
      <EnoughRocks of={of} />
      {of.entering.rocks > 0 && <Figures of={figuresOfArea(of)} />}
      <OnlyThese what="enter" />
      {of.sources && <Sources hasKit={false} />}
      <WhatIf />
    </>
  );
}

function Answer() {
  const [run, found] = [shown.value, answer.value];
  if (!asked.value) return null;
  if (!run || !hasResults(run)) return <p class="faint">Compute the project or choose a run, and the line is answered.</p>;
  const missing = missingPoints(asked.value, run.dimension);
  if (missing > 0) return <p class="faint">{missing === 1 ? 'One more point is' : `${missing} more points are`} needed.</p>;
  if (refusal.value !== null) return <p class="problem">{refusal.value}</p>;
  if (!found) return <p class="faint">{isWaiting.value ? 'Asking the run…' : ''}</p>;
  return (
    <div class="asked-answer" aria-busy={isWaiting.value}>
      {found.problems.map((problem) => (
        <p key={problem.text} class={`problem ${problem.severity}`}>
          {problem.text}
        </p>
      ))}
      {found.kind === 'polygon' ? <OfPolygon of={found} /> : <OfLine of={found} />}
    </div>
  );
}

export function AskCard() {
  const card = useRef<HTMLElement>(null);
  useEffect(() => {
    if (!asked.peek()) card.current?.focus();
  }, []);
  return (
    <section
      ref={card}
      class="ask-card"
      aria-label="Ask a line"
      tabIndex={-1}
      onKeyDown={(event) => {
        const isTyping = event.target instanceof HTMLInputElement && event.target.type === 'text';
        if (event.key === 'Escape' && !isTyping && !tool.value) openCard(false);
      }}
    >
      <header>
        <h2>Ask a line</h2>
        <button class="button plain icon" aria-label="Close" title="Close (Escape)" onClick={() => openCard(false)}>
          ×
        </button>
      </header>
      <AskedChoices />
      <Answer />
      <AskedPoints />
    </section>
  );
}
