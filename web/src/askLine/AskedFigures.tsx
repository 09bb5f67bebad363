// The figures of an answer, as the card and its sheet show them.

import type { AskedAnswer, LineAnswer, PolygonAnswer } from '../api/line';
import { displayOf } from '../state/displayUnits';
import { counted, numberText } from '../ui/format';
import { intervalText, percentText } from './kit';

function BigShare({ share, interval, confidence, what }: { share: string; interval: string; confidence: number; what: string }) {
  return (
    <p class="big-share">
      <strong>{share}</strong> {what}
      {interval !== '' && <span class="interval">{interval}, with {percentText(confidence)} confidence</span>}
    </p>
  );
}

function ShareOfArea({ of: { share, rocks }, confidence, what }: { of: PolygonAnswer['entering']; confidence: number; what: string }) {
  return <BigShare share={share ? percentText(share.value) : ''} interval={share ? intervalText(share) : ''} confidence={confidence} what={`${what}: ${rocks.toLocaleString('en')}`} />;
}

interface Figure {
  title: string;
  value: string;
  interval: string;
}

/// `height`: what it is the height of.
const quantities = (height: string) =>
  [
    ['energy', 'ke_translational_J', 'J'],
    [`height of the ${height}`, 'height_m', 'm'],
    ['velocity', 'velocity_m_s', 'm/s'],
  ] as const;

/// The percentile of the design with its confidence interval: 95 % of the rocks have less.
function percentilesIn({ percentiles }: Pick<PolygonAnswer, 'percentiles'>, percentile: string, height: string): Figure[] {
  return quantities(height).flatMap(([title, key, metric]) => {
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
  return [{ title: `class by ${standard}`, value: name(needs), interval: `needs ${rest}${atUpper}` }];
}

export function Figures({ of }: { of: Figure[] }) {
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

/// The rocks that were asked: those whose trajectories are stored.
const storedText = ({ run: { stored, rocks } }: Pick<LineAnswer, 'run'>) =>
  stored < rocks ? `of the ${stored.toLocaleString('en')} stored of ${counted(rocks, 'rock')}` : `of ${counted(rocks, 'rock')}`;

/// Of a line: percentiles and the class.
export const figuresOfLine = (of: LineAnswer) => [...percentilesIn(of.whole, String(of.design_percentile), "block's top"), ...classOf(of)];

/// Of an area, by the 95th percentile if there is one.
export function figuresOfArea(of: PolygonAnswer) {
  const known = Object.keys(of.percentiles.ke_total_J ?? {});
  return percentilesIn(of, known.includes('95') ? '95' : (known[0] ?? '95'), 'lowest point');
}

/// The share that crosses, or the shares that enter and end inside.
export function Shares({ of }: { of: AskedAnswer }) {
  if (of.kind === 'polygon')
    return (
      <>
        <ShareOfArea of={of.entering} confidence={of.confidence} what="enter" />
        <ShareOfArea of={of.stopping} confidence={of.confidence} what="end inside" />
        <p class="faint">{storedText(of)}</p>
      </>
    );
  const { rocks } = of.whole;
  return (
    <BigShare
      share={of.card.share}
      interval={of.card.share_interval}
      confidence={of.confidence}
      what={`${rocks === 1 ? 'crosses' : 'cross'}: ${rocks.toLocaleString('en')} ${storedText(of)}`}
    />
  );
}
