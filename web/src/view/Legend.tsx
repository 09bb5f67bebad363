// Legends: a scale with its ends and middle, or a list of kinds.

import { numberText } from '../ui/format';
import './legend.css';

interface Scale {
  title: string;
  gradient: string;
  low: number;
  high: number;
  /// On a logarithmic scale the middle is the geometric mean.
  logarithmic?: boolean;
  /// Greater values have the last colour.
  isClipped?: boolean;
}

export function ScaleLegend({ title, gradient, low, high, logarithmic = false, isClipped = false }: Scale) {
  const middle = logarithmic ? Math.sqrt(low * high) : (low + high) / 2;
  return (
    <figure class="legend">
      <figcaption>{title}</figcaption>
      <div class="ramp" style={{ background: gradient }} />
      <div class="ends mono">
        <span>{numberText(low, 3)}</span>
        <span>{numberText(middle, 3)}</span>
        <span>
          {isClipped && <span title="or more">≥ </span>}
          {numberText(high, 3)}
        </span>
      </div>
    </figure>
  );
}

/// Classes of values, the greatest on top.
export function ClassesLegend({ title, classes, note }: { title: string; classes: { text: string; colour: string; isThere: boolean }[]; note: string }) {
  return (
    <figure class="legend classes">
      <figcaption>{title}</figcaption>
      <ul>
        {classes
          .map(({ text, colour, isThere }) => (
            <li key={text} class={isThere ? '' : 'faint'}>
              <i style={{ background: colour }} />
              <span class="mono">{text}</span>
            </li>
          ))
          .reverse()}
      </ul>
      <p class="faint">{note}</p>
    </figure>
  );
}

export function KindsLegend({ title, kinds }: { title: string; kinds: { name: string; colour: string }[] }) {
  return (
    <figure class="legend">
      <figcaption>{title}</figcaption>
      <ul>
        {kinds.map(({ name, colour }) => (
          <li key={name}>
            <i style={{ background: colour }} />
            <span title={name}>{name}</span>
          </li>
        ))}
      </ul>
    </figure>
  );
}
