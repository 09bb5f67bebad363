// How far the answers move, on paper: the figures of the same rocks with other rock models and other inputs.

import type { Interval } from '../api/line';
import type { Figures, WhatIfAnswer, WhatIfOptions } from '../api/whatIf';
import { percentText } from '../askLine/kit';
import { inputsOf, modelsOf } from '../askLine/spread';
import { nameOf } from '../askLine/tornadoOf';
import { displayOf } from '../state/displayUnits';
import { counted, numberText } from '../units/numbers';
import { modelName, modelText } from './models';

const mostRows = 13;

const inUnit = (metric: string) => (figure: Interval | null) => (figure ? numberText(figure[0] / displayOf(metric).per, 3) : '–');
const columns: readonly { title: () => string; text: (of: Figures) => string }[] = [
  { title: () => 'passes', text: ({ share }) => percentText(share?.[0] ?? 0) },
  { title: () => `transl., ${displayOf('J').unit}`, text: (of) => inUnit('J')(of.ke_translational_J) },
  { title: () => `total, ${displayOf('J').unit}`, text: (of) => inUnit('J')(of.ke_total_J) },
  { title: () => `height, ${displayOf('m').unit}`, text: (of) => inUnit('m')(of.height_m) },
];

export function PrintedMoves({ of, question: { material } }: { of: WhatIfAnswer; question: WhatIfOptions }) {
  const inputs = inputsOf(of);
  const sets = [
    { name: `${modelName(of.model)}, as in this run`, of: of.base as Figures },
    ...modelsOf(of).map((each) => ({ name: `rock model ${modelText(each)}`, of: each as Figures })),
    ...inputs.map((each) => ({ name: nameOf(each), of: each as Figures })),
  ];
  return (
    <section>
      <h3>How far the answers move</h3>
      <table class="moves">
        <caption>
          {of.percentile} % figures of {of.rocks < of.planned ? `${of.rocks.toLocaleString('en')} of ${counted(of.planned, 'rock')}, the same` : `the same ${counted(of.rocks, 'rock')}`}
          {' in each row'}
          {material && `; ground of ${material} alone`}
        </caption>
        <thead>
          <tr>
            <th scope="col">with</th>
            {columns.map(({ title }) => (
              <th key={title()} scope="col">
                {title()}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {sets.slice(0, mostRows).map(({ name, of: figures }) => (
            <tr key={name}>
              <th scope="row">{name}</th>
              {columns.map(({ title, text }) => (
                <td key={title()}>{text(figures)}</td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
      {sets.length > mostRows && <p>and {sets.length - mostRows} more, under What if of the workbench</p>}
    </section>
  );
}
