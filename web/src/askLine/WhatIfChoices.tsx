// Choices of what if: the material, and each input with its step.

import type { WhatIfChoices as Choices, WhatIfFactor } from '../api/whatIf';
import { chooseMaterial, chooseStep, chosenSteps, isLeftOut, material } from './whatIfChoices';

function Factor({ of: { factor, title, usual_percent } }: { of: WhatIfFactor }) {
  const step = chosenSteps.value[factor];
  const isOff = isLeftOut(chosenSteps.value, factor);
  return (
    <li>
      <label class="choice">
        <input type="checkbox" checked={!isOff} onChange={(event) => chooseStep(factor, event.currentTarget.checked ? undefined : false)} />
        {title}
      </label>
      <label>
        ±{' '}
        <input
          type="text"
          inputMode="decimal"
          aria-label={`Step of ${title.toLowerCase()}`}
          disabled={isOff}
          value={typeof step === 'string' ? step : String(usual_percent)}
          onInput={({ currentTarget: { value } }) => chooseStep(factor, value === String(usual_percent) ? undefined : value)}
        />{' '}
        %
      </label>
    </li>
  );
}

export function WhatIfChoices({ of: { materials, factors } }: { of: Choices }) {
  return (
    <details class="what-if-choices">
      <summary>
        Inputs and steps{material.value !== '' && `: ${material.value}`}
      </summary>
      {materials.length > 1 && (
        <label class="choice">
          Ground
          <select value={material.value} onChange={(event) => chooseMaterial(event.currentTarget.value)}>
            <option value="">All materials</option>
            {materials.map((name) => (
              <option key={name}>{name}</option>
            ))}
          </select>
        </label>
      )}
      <ul>
        {factors.map((factor) => (
          <Factor key={factor.factor} of={factor} />
        ))}
      </ul>
    </details>
  );
}
