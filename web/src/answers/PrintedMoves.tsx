// How far the answers move, on paper: the figures of the same rocks with other rock models and other inputs.

import type { Interval } from '../api/line';
import type { Figures, WhatIfAnswer, WhatIfState } from '../api/whatIf';
import { percentText } from '../askLine/kit';
import { inputsOf, modelsOf } from '../askLine/spread';
import { nameOf } from '../askLine/tornadoOf';
import { displayOf } from '../state/displayUnits';
import { counted, numberText } from '../units/numbers';
import { modelName, modelText } from './models';

/// Beside the longest inputs.
const leastRows = 13;

const inUnit = (metric: string) => (figure: Interval | null) => (figure ? numberText(figure[0] / displayOf(metric).per, 3) : '–');
const columns: readonly { title: () => string; text: (of: Figures) => string }[] = [
  { title: () => 'passes', text: ({ share }) => percentText(share?.[0] ?? 0) },
  { title: () => `transl., ${displayOf('J').unit}`, text: (of) => inUnit('J')(of.ke_translational_J) },
  { title: () => `total, ${displayOf('J').unit}`, text: (of) => inUnit('J')(of.ke_total_J) },
  { title: () => `height, ${displayOf('m').unit}`, text: (of) => inUnit('m')(of.height_m) },
];
const ofFence: typeof columns = [
  { title: () => `fence, ${displayOf('J').unit}`, text: (of) => inUnit('J')(of.needs && [of.needs.energy_J, null, null]) },
  { title: () => `fence, ${displayOf('m').unit}`, text: (of) => inUnit('m')(of.needs && [of.needs.height_m, null, null]) },
];

interface Props {
  of: WhatIfAnswer;
  question: WhatIfState['question'];
  /// The lines that are left on the page.
  spare: number;
}

export function PrintedMoves({ of, question, spare }: Props) {
  const mostRows = leastRows + spare;
  const inputs = inputsOf(of);
  const shown = question.polygon ? columns : [...columns, ...ofFence];
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
          {!question.polygon && (of.standard === null ? '; fence without factors' : `; fence by ${of.standard}`)}
          {question.material && `; ground of ${question.material} alone`}
        </caption>
        <thead>
          <tr>
            <th scope="col">with</th>
            {shown.map(({ title }) => (
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
              {shown.map(({ title, text }) => (
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
