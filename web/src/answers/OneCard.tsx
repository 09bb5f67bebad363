// An answer as a card: its figures, and below each its interval and its ranges.

import type { Card, CardFigure } from './cards';

const rows = [
  { name: 'sampling', title: 'By chance, with as many rocks as this run has', text: (of: CardFigure) => of.sampling, why: () => '' },
  { name: 'inputs', title: 'With each input a step lower or higher, the same rocks', text: (of: CardFigure) => of.inputs, why: (of: CardFigure) => of.inputsWhy },
  { name: 'models', title: 'With the other rock models, the same rocks', text: (of: CardFigure) => of.models, why: (of: CardFigure) => of.modelsWhy },
] as const;

interface Props {
  of: Card;
  /// What a row says that has no range yet.
  missing: string;
  /// Whether ranges may still grow.
  isPart: boolean;
}

export function OneCard({ of, missing, isPart }: Props) {
  return (
    <section class={`answer-card ${of.key}`} aria-label={of.title}>
      <h3>{of.title}</h3>
      <table>
        <thead>
          <tr>
            <td />
            {of.figures.map(({ name, value }) => (
              <th key={name} scope="col">
                <strong>{value}</strong>
                {name && <span class="faint"> {name}</span>}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {rows.map(({ name, title, text, why }) => (
            <tr key={name} class={name}>
              <th scope="row" title={title}>
                {name}
              </th>
              {of.figures.map((figure) => {
                const found = text(figure);
                return (
                  <td key={figure.name} title={why(figure) || title} class={found === null ? 'faint' : isPart && name !== 'sampling' ? 'part' : ''}>
                    {found ?? missing}
                  </td>
                );
              })}
            </tr>
          ))}
        </tbody>
      </table>
      {of.note && <p class="faint note">{of.note}</p>}
    </section>
  );
}
