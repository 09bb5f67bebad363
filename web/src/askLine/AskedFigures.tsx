// The figures of an answer, as the card and its sheet show them.

import type { AskedAnswer, LineAnswer, LineQuantity, PolygonAnswer } from '../api/line';
import type { WhatIfAnswer } from '../api/whatIf';
import { displayOf } from '../state/displayUnits';
import { counted, numberText } from '../units/numbers';
import { intervalText, percentText } from './kit';
import { inputsOf, rangeOver, type SpreadFigure } from './spread';
import { whatIf } from './whatIf';

/// The answer of what if to the same question; null: it was not asked, or is under way.
const whatIfAnswer = () => (whatIf.value && whatIf.value.state !== 'running' ? whatIf.value.answer : null);

interface ShareProps {
  share: string;
  interval: string;
  confidence: number;
  what: string;
  /// With other inputs; null: unknown.
  range: [number, number] | null;
}

/// The interval is of the sampled rocks alone. What other inputs would give stands beside it.
function BigShare({ share, interval, confidence, what, range }: ShareProps) {
  return (
    <p class="big-share">
      <strong>{share}</strong> {what}
      {interval !== '' && <span class="interval">{interval} from sampling alone, with {percentText(confidence)} confidence</span>}
      {range && <span class="interval">{intervalText({ value: 0, low: range[0], high: range[1] })} with the inputs of what if</span>}
    </p>
  );
}

interface AreaProps {
  of: PolygonAnswer['entering'];
  confidence: number;
  what: string;
  range?: [number, number] | null;
}

function ShareOfArea({ of: { share, rocks }, confidence, what, range = null }: AreaProps) {
  return <BigShare share={share ? percentText(share.value) : ''} interval={share ? intervalText(share) : ''} confidence={confidence} what={`${what}: ${rocks.toLocaleString('en')}`} range={range} />;
}

interface Figure {
  title: string;
  value: string;
  /// Of sampling alone.
  interval: string;
  /// With the inputs of what if; empty: unknown.
  range: string;
}

/// `height`: what it is the height of.
const quantities = (height: string) =>
  [
    ['translational energy', 'ke_translational_J', 'J'],
    ['total energy', 'ke_total_J', 'J'],
    [`height of the ${height}`, 'height_m', 'm'],
    ['velocity', 'velocity_m_s', 'm/s'],
  ] as const;

/// Over the inputs of what if; null: unknown, or no input was varied.
function endsOver(answer: WhatIfAnswer, key: SpreadFigure): [number, number] | null {
  const found = rangeOver(answer.base, inputsOf(answer), key);
  return found && [found.low, found.high];
}
function rangeFor(key: LineQuantity, percentile: string): [number, number] | null {
  const answer = whatIfAnswer();
  if (!answer || String(answer.percentile) !== percentile) return null;
  return endsOver(answer, key);
}

/// The percentile of the design with its confidence interval: 95 % of the rocks have less.
function percentilesIn({ percentiles }: Pick<PolygonAnswer, 'percentiles'>, percentile: string, height: string): Figure[] {
  return quantities(height).flatMap(([title, key, metric]) => {
    const found = percentiles[key]?.[percentile];
    if (!found) return [];
    const { unit, per } = displayOf(metric);
    const text = (each: number) => numberText(each / per, 3);
    const [value, low, high] = found.map((each) => (each === null ? null : text(each)));
    const range = rangeFor(key, percentile);
    return [
      {
        title: `${percentile} % ${title}`,
        value: `${value} ${unit}`,
        interval: `${low ?? '–'} to ${high ?? 'unknown, too few rocks'}`,
        range: range ? `${text(range[0])} to ${text(range[1])}` : '',
      },
    ];
  });
}

/// The class of the kit that the standard asks for.
function classOf({ whole: { needs, needs_at_upper_end: upper }, standard, card }: LineAnswer): Figure[] {
  if (!needs || standard === null) return [];
  const rest = card.needs.replace(/^class [^:]*: /, '');
  const atUpper = upper && upper.class !== needs.class ? `; up to class ${upper.class}` : '';
  return [{ title: `class by ${standard}`, value: String(needs.class), interval: `needs ${rest}${atUpper}`, range: '' }];
}

export function Figures({ of }: { of: Figure[] }) {
  const hasRanges = of.some(({ range }) => range !== '');
  return (
    <>
      <dl class="asked-figures">
        {of.map(({ title, value, interval, range }) => (
          <div key={title}>
            <dt>{title}</dt>
            <dd>
              <strong>{value}</strong>
              <span class="interval">
                {interval}
                {range !== '' && <span class="range"> · {range}</span>}
              </span>
            </dd>
          </div>
        ))}
      </dl>
      {of.length > 0 && (
        <p class="faint">{hasRanges ? 'Small: from sampling alone · with the inputs of what if.' : 'Intervals are from sampling alone. What if shows what other inputs give.'}</p>
      )}
    </>
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

const shareRange = () => {
  const answer = whatIfAnswer();
  return answer && endsOver(answer, 'share');
};

/// The share that crosses, or the shares that enter and end inside.
export function Shares({ of }: { of: AskedAnswer }) {
  if (of.kind === 'polygon')
    return (
      <>
        <ShareOfArea of={of.entering} confidence={of.confidence} what="enter" range={shareRange()} />
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
      range={shareRange()}
    />
  );
}
