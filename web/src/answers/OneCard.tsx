// An answer as a card: its figures, and below each its interval and its ranges.

import type { Card, CardFigure, CardRange } from './cards';

const rows: readonly { name: string; title: string; of: (figure: CardFigure) => CardRange | null }[] = [
  { name: 'sampling', title: 'By chance, with as many rocks as this run has', of: ({ sampling }) => ({ text: sampling, withChance: '', why: '' }) },
  { name: 'inputs', title: 'With each input a step lower or higher, the same rocks', of: ({ inputs }) => inputs },
  { name: 'models', title: 'With the other rock models, the same rocks', of: ({ models }) => models },
];

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
          {rows.map(({ name, title, of: rangeOf }) => (
            <tr key={name} class={name}>
              <th scope="row" title={title}>
                {name}
              </th>
              {of.figures.map((figure) => {
                const found = rangeOf(figure);
                return (
                  <td key={figure.name} title={found?.why || title} class={found === null ? 'faint' : isPart && name !== 'sampling' ? 'part' : ''}>
                    {found?.text ?? missing}
                    {found?.withChance && <span class="with-chance">{found.withChance}</span>}
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
