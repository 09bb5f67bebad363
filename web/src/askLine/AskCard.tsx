// The docked card: what is asked, and the answer of the shown run.

import { useEffect, useRef } from 'preact/hooks';
import type { LineAnswer, PolygonAnswer } from '../api/line';
import { tool } from '../scene/tool';
import { displayOf } from '../state/displayUnits';
import { crossingRocks, filter } from '../state/filter';
import { hasResults, shown } from '../state/runs';
import { isAsking } from '../state/view';
import { counted, numberText } from '../ui/format';
import { answer, asked, isWaiting, refusal } from './asked';
import { AskedChoices } from './AskedChoices';
import { AskedPoints } from './AskedPoints';
import { BuildHere } from './BuildHere';
import { EnoughRocks } from './EnoughRocks';
import { KitSlider } from './KitSlider';
import { intervalText, percentText } from './kit';
import { ProfileOfLine } from './ProfileOfLine';
import { missingPoints } from './shape';
import { Sources } from './Sources';
import { WhatIf } from './WhatIf';
import './askedOverlay';
import './askLine.css';

function BigShare({ share, interval, what }: { share: string; interval: string; what: string }) {
  return (
    <p class="big-share">
      <strong>{share}</strong> {what}
      <span class="interval">{interval}</span>
    </p>
  );
}

function ShareOfArea({ of: { share, rocks }, what }: { of: PolygonAnswer['entering']; what: string }) {
  return <BigShare share={share ? percentText(share.value) : ''} interval={share ? intervalText(share) : ''} what={`${what}: ${rocks.toLocaleString('en')}`} />;
}

interface Figure {
  title: string;
  value: string;
  interval: string;
}

const quantities = [
  ['energy', 'ke_translational_J', 'J'],
  ['height', 'height_m', 'm'],
  ['velocity', 'velocity_m_s', 'm/s'],
] as const;

/// The percentile of the design with its confidence interval: 95 % of the rocks have less.
function percentilesIn({ percentiles }: Pick<PolygonAnswer, 'percentiles'>, percentile: string): Figure[] {
  return quantities.flatMap(([title, key, metric]) => {
    const found = percentiles[key]?.[percentile];
    if (!found) return [];
    const { unit, per } = displayOf(metric);
    const [value, low, high] = found.map((each) => (each === null ? null : numberText(each / per, 3)));
    return [{ title: `${percentile} % ${title}`, value: `${value} ${unit}`, interval: `${low ?? '–'} to ${high ?? 'unknown, too few rocks'}` }];
  });
}

/// The class of the kit that the standard asks for.
function classOf({ whole: { needs, needs_at_upper_end: upper }, standard, card }: LineAnswer): Figure[] {
  if (!needs || standard === null) return [];
  const name = ({ class: number }: typeof needs) => (number === null ? 'none' : String(number));
  const rest = card.needs.replace(/^class [^:]*: /, '');
  const atUpper = upper && name(upper) !== name(needs) ? `; up to class ${name(upper)}` : '';
  return [{ title: `class by ${standard}`, value: name(needs), interval: `${rest}${atUpper}` }];
}

function Figures({ of }: { of: Figure[] }) {
  return (
    <dl class="asked-figures">
      {of.map(({ title, value, interval }) => (
        <div key={title}>
          <dt>{title}</dt>
          <dd>
            <strong>{value}</strong>
            <span class="interval">{interval}</span>
          </dd>
        </div>
      ))}
    </dl>
  );
}

function OnlyThese({ what }: { what: string }) {
  const isOn = filter.value.crossing !== null;
  return (
    <label class="choice" title="In the views, the sections, the tables and the figures">
      <input
        type="checkbox"
        checked={isOn}
        disabled={!answer.value || !crossingRocks.value}
        onChange={(event) => (filter.value = { ...filter.value, crossing: event.currentTarget.checked ? (answer.value?.selection ?? null) : null })}
      />
      Only rocks that {what}
    </label>
  );
}

/// The rocks that were asked: those whose trajectories are stored.
const storedText = ({ run: { stored, rocks } }: Pick<LineAnswer, 'run'>) =>
  stored < rocks ? `of the ${stored.toLocaleString('en')} stored of ${counted(rocks, 'rock')}` : `of ${counted(rocks, 'rock')}`;

function OfLine({ of }: { of: LineAnswer }) {
  const { rocks } = of.whole;
  return (
    <>
      <BigShare share={of.card.share} interval={of.card.share_interval} what={`${rocks === 1 ? 'crosses' : 'cross'}: ${rocks.toLocaleString('en')} ${storedText(of)}`} />
      <EnoughRocks of={of.enough} />
      {rocks > 0 && (
        <>
          <Figures of={[...percentilesIn(of.whole, String(of.design_percentile)), ...classOf(of)]} />
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
  const known = Object.keys(of.percentiles.ke_total_J ?? {});
  const percentile = known.includes('95') ? '95' : (known[0] ?? '95');
  return (
    <>
      <ShareOfArea of={of.entering} what="enter" />
      <ShareOfArea of={of.stopping} what="end inside" />
      <p class="faint">{storedText(of)}</p>
      <EnoughRocks of={of.enough} />
      {of.entering.rocks > 0 && <Figures of={percentilesIn(of, percentile)} />}
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
        if (event.key === 'Escape' && !isTyping && !tool.value) isAsking.value = false;
      }}
    >
      <header>
        <h2>Ask a line</h2>
        <button class="button plain icon" aria-label="Close" title="Close (Escape)" onClick={() => (isAsking.value = false)}>
          ×
        </button>
      </header>
      <AskedChoices />
      <Answer />
      <AskedPoints />
    </section>
  );
}
