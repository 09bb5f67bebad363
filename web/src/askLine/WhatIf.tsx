// What if an input were higher or lower: the change of each figure at the line, as a tornado and as a table.

import { useCallback, useState } from 'preact/hooks';
import { whatIfs, type Variation, type WhatIfAnswer, type WhatIfFigure, type WhatIfState } from '../api/whatIf';
import type { Room } from '../figures/plot';
import { tornado, type TornadoBar } from '../figures/tornado';
import { Chart } from '../charts/Chart';
import { useRemote } from '../ui/remote';
import { fileName } from '../charts/save';
import { unitSystem } from '../state/displayUnits';
import { shown } from '../runs/runs';
import { barsOf, changeText, figures, figureTitle, nameOf, type WhatIfBar } from './tornadoOf';
import { begin, chooseFigure, openAsRun, refusalOf, stop, unitOfChange, whatIf, whatIfFigure } from './whatIf';
import { asked } from './asked';
import { shapeOf } from './shape';
import { WhatIfChoices } from './WhatIfChoices';
import { chooseMaterial, chosenSteps, material, optionsOf } from './whatIfChoices';

function ProgressOf({ of }: { of: WhatIfState }) {
  const left = of.seconds_left === null ? '' : `, ${Math.ceil(of.seconds_left)} s left`;
  return (
    <div class="what-if-progress">
      <progress aria-label="What if" max={Math.max(of.planned, 1)} value={of.done} />
      <span class="faint">
        {of.done.toLocaleString('en')} of about {of.planned.toLocaleString('en')} rocks in each set{left}
      </span>
      <button class="button" onClick={() => void stop()}>
        Stop
      </button>
    </div>
  );
}

const rowsOf = (of: WhatIfAnswer) => [
  ['factor', 'step_percent', 'values', 'clipped', ...Object.keys(figures).flatMap((by) => [`${by}_change`, `${by}_change_low`, `${by}_change_high`])],
  ...of.variations.map((each) => [
    each.factor,
    each.step_percent ?? '',
    each.text,
    each.clipped,
    ...(Object.keys(figures) as WhatIfFigure[]).flatMap((by) => (each.difference[by] ?? [null, null, null]).map((end) => end ?? '')),
  ]),
];

function Table({ of, by, chosen, choose }: { of: WhatIfAnswer; by: WhatIfFigure; chosen: string; choose: (name: string) => void }) {
  return (
    <table class="what-if-table">
      <caption class="faint">Change of the {figureTitle(by, of).toLowerCase()}, for the same rocks</caption>
      <tbody>
        {of.variations.map((each) => (
          <tr key={nameOf(each)}>
            <th scope="row">
              <button class="button plain" aria-pressed={nameOf(each) === chosen} onClick={() => choose(nameOf(each))}>
                {nameOf(each)}
              </button>
            </th>
            <td>{changeText(each.difference[by], unitOfChange(by))}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function Chosen({ of, variation }: { of: WhatIfState; variation: Variation }) {
  return (
    <div class="what-if-chosen" aria-live="polite">
      <strong>{nameOf(variation)}</strong>
      <span>{variation.text}</span>
      {variation.clipped && <span class="problem warning">Clipped: {variation.clipped}</span>}
      {variation.changes.length > 0 && <button
        class="button"
        title="Computes the project of this run with these values, with the same rocks. The open project stays as it is"
        onClick={() => void openAsRun(of, variation)}
      >
        Open as a run of its own
      </button>}
    </div>
  );
}

function AnswerOf({ state, answer }: { state: WhatIfState; answer: WhatIfAnswer }) {
  const by = whatIfFigure.value;
  const [chosen, choose] = useState('');
  const title = figureTitle(by, answer);
  const draw = useCallback(
    (element: SVGSVGElement, room: Room) =>
      tornado(element, room, {
        title: `Change of the ${title.toLowerCase()}`,
        unit: unitOfChange(by).unit,
        per: 1,
        bars: barsOf(answer, by, unitOfChange(by)),
        choose: (bar: TornadoBar) => choose(nameOf((bar as WhatIfBar).variation)),
      }),
    [answer, by, unitSystem.value],
  );
  const variation = answer.variations.find((each) => nameOf(each) === chosen);
  return (
    <>
      <Chart
        title="Effect of each input"
        description={`Change of the ${title.toLowerCase()} by each step, with its interval. The table below has the numbers.`}
        file={fileName(shown.value?.name ?? '', 'what if', by)}
        draw={draw}
        rows={() => rowsOf(answer)}
        tools={
          <select aria-label="Figure of what if" value={by} onChange={(event) => chooseFigure(event.currentTarget.value as WhatIfFigure)}>
            {(Object.keys(figures) as WhatIfFigure[]).map((each) => (
              <option key={each} value={each}>
                {figureTitle(each, answer)}
              </option>
            ))}
          </select>
        }
      />
      <p class="faint what-if-legend">
        <span class="lower" /> lower <span class="higher" /> higher{state.question.material && `, ground of ${state.question.material} alone`}. {answer.rocks.toLocaleString('en')} rocks in each set
        {answer.rocks < answer.planned && `, a fair sample of ${answer.planned.toLocaleString('en')}`}
        {state.state === 'stopped' && '; stopped before its time'}. Choose a bar or a row to open it as a run.
      </p>
      {variation && <Chosen of={state} variation={variation} />}
      <Table of={answer} by={by} chosen={chosen} choose={choose} />
    </>
  );
}

export function WhatIf() {
  const now = whatIf.value;
  const run = shown.value!.id;
  const choices = useRemote(run, material.value, (signal) => whatIfs.choices(run, material.value, signal));
  const refusal = asked.value && refusalOf(shapeOf(asked.value));
  const options = choices.value && optionsOf(choices.value, chosenSteps.value, material.value);
  return (
    <div class="asked-what-if">
      <h3>What if</h3>
      {!now && <p class="faint">How the figures change if restitution, friction, roughness, forest or mass are a step lower or higher, and with the other rock models, for the same rocks.</p>}
      {now?.problems.map((problem) => (
        <p key={problem.text} class={`problem ${problem.severity}`}>
          {problem.text}
        </p>
      ))}
      {now?.state === 'running' && <ProgressOf of={now} />}
      {now?.answer && <AnswerOf state={now} answer={now.answer} />}
      {choices.error !== null && (
        <p class="problem">
          {choices.error}{' '}
          {material.value !== '' && (
            <button class="button" onClick={() => chooseMaterial('')}>
              All materials
            </button>
          )}
        </p>
      )}
      {choices.value && <WhatIfChoices of={choices.value} />}
      {choices.value && now?.state !== 'running' && (
        <button
          class="button"
          disabled={!options}
          title={options ? undefined : 'Choose an input above'}
          onClick={() => options && asked.value && void begin(shapeOf(asked.value), { ...options, models: true })}
        >
          {now ? 'Vary the inputs again' : 'Vary the inputs'}
        </button>
      )}
      {refusal !== null && (
        <p class="problem error" role="alert">
          {refusal}
        </p>
      )}
    </div>
  );
}
