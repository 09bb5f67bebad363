// An answer as a card: its figures, and below each its interval and its ranges.

import type { Card, CardFigure } from './cards';

interface Row {
  name: string;
  label: string;
  title: string;
  /// Null: unknown yet.
  text: (of: CardFigure) => string | null;
  why?: (of: CardFigure) => string | undefined;
}
const byChance = 'The same with the chance of the rocks of each set: to the outermost ends of their intervals of sampling';
const rows: readonly Row[] = [
  { name: 'sampling', label: 'sampling', title: 'By chance, with as many rocks as this run has', text: ({ sampling }) => sampling },
  { name: 'stretches', label: 'stretches', title: 'The most that a stretch of the line needs by itself', text: ({ stretches }) => stretches },
  { name: 'inputs', label: 'inputs', title: 'With each input a step lower or higher, the same rocks', text: ({ inputs }) => inputs && inputs.text, why: ({ inputs }) => inputs?.why },
  { name: 'inputs-chance', label: '+ chance', title: byChance, text: ({ inputs }) => inputs?.withChance ?? '' },
  { name: 'models', label: 'models', title: 'With the other rock models, the same rocks', text: ({ models }) => models && models.text, why: ({ models }) => models?.why },
  { name: 'models-chance', label: '+ chance', title: byChance, text: ({ models }) => models?.withChance ?? '' },
];

const isOfRun = new Set(['sampling', 'stretches']);

interface Props {
  of: Card;
  /// What a row says that has no range yet.
  missing: string;
  /// Whether ranges may still grow.
  isPart: boolean;
  isOnPaper?: boolean;
}

export function OneCard({ of, missing, isPart, isOnPaper = false }: Props) {
  const shown = rows.filter(({ text }) => of.figures.some((figure) => text(figure) !== ''));
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
          {shown.map(({ name, label, title, text, why }) => (
            <tr key={name} class={name}>
              <th scope="row" title={title}>
                {label}
              </th>
              {of.figures.map((figure) => {
                const found = text(figure);
                return (
                  <td key={figure.name} title={why?.(figure) || title} class={found === null ? 'faint' : isPart && !isOfRun.has(name) ? 'part' : ''}>
                    {found ?? missing}
                  </td>
                );
              })}
            </tr>
          ))}
        </tbody>
      </table>
      {[...of.notes, ...(isOnPaper ? of.printed : [])].map((note) => (
        <p key={note} class="faint note">
          {note}
        </p>
      ))}
    </section>
  );
}
