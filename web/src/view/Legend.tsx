// Legends over a view: a colour scale, a list of categories, or classes.

import { endsOf, type ClassesOfValues, type KindsOfThings, type LegendData, type ScaleOfColours } from './legends';
import './legend.css';

function ScaleLegend({ of }: { of: ScaleOfColours }) {
  const gradient = of.stops.map(([at, colour]) => `${colour} ${(100 * at).toFixed(1)}%`).join(', ');
  return (
    <figure class="legend">
      <figcaption>{of.title}</figcaption>
      <div class="ramp" style={{ background: `linear-gradient(to right, ${gradient})` }} />
      <div class="ends mono">
        {endsOf(of).map((text, k) => (
          <span key={k} title={of.isClipped && k === 2 ? 'or more' : undefined}>
            {text}
          </span>
        ))}
      </div>
    </figure>
  );
}

function KindsLegend({ of }: { of: KindsOfThings }) {
  return (
    <figure class="legend">
      <figcaption>{of.title}</figcaption>
      <ul>
        {of.kinds.map(({ name, colour }) => (
          <li key={name}>
            <i style={{ background: colour }} />
            <span title={name}>{name}</span>
          </li>
        ))}
      </ul>
    </figure>
  );
}

/// With the highest class on top.
function ClassesLegend({ of }: { of: ClassesOfValues }) {
  return (
    <figure class="legend classes">
      <figcaption>{of.title}</figcaption>
      <ul>
        {of.classes.toReversed().map(({ text, colour, isUsed }) => (
          <li key={text} class={isUsed ? '' : 'faint'}>
            <i style={{ background: colour }} />
            <span class="mono">{text}</span>
          </li>
        ))}
      </ul>
      <p class="faint">{of.note}</p>
    </figure>
  );
}

function Legend({ of }: { of: LegendData }) {
  switch (of.kind) {
    case 'scale':
      return <ScaleLegend of={of} />;
    case 'kinds':
      return <KindsLegend of={of} />;
    case 'classes':
      return <ClassesLegend of={of} />;
    case 'remark':
      return <p class={of.isWarning ? 'legend outdated-paths' : 'legend'} role="status">{of.text}</p>;
  }
}

export function Legends({ list }: { list: readonly LegendData[] }) {
  return (
    <div class="legends">
      {list.map((of) => (
        <Legend key={of.kind === 'remark' ? of.text : of.title} of={of} />
      ))}
    </div>
  );
}
