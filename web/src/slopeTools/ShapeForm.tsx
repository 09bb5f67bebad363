// The form of a slope tool: its numbers, what it cuts and fills, Apply and Compare.

import { fixedText } from '../units/numbers';
import { Compared } from './Compared';
import { compare, comparing, mostRocks, setStation, station } from './compare';
import { NumberInput } from './NumberInput';
import { apply, kind, numbers, preview, problem, setElevation, setNumbers } from './state';
import { fieldsOf, type ToolKind } from './tools';

const hints: Record<ToolKind, string> = {
  bench: 'A bench is cut into the slope behind its outer edge.',
  ditch: 'A ditch is dug from its toe, at the foot of the slope, towards the road.',
  berm: 'A berm is raised on the ground. Its height is that of its crest above the ground below.',
  regrade: 'The slope becomes straight between two places, or rises from the second one at an angle until it meets the ground.',
};

function AngleChoice() {
  const { angle, ...others } = numbers.value;
  return (
    <label class="choice">
      <input type="checkbox" checked={angle !== undefined} onChange={(event) => setNumbers(event.currentTarget.checked ? { ...others, angle: 45 } : others)} />
      To an angle
    </label>
  );
}

export function ShapeForm() {
  const tool = kind.value!;
  const made = preview.value && 'value' in preview.value ? preview.value.value : null;
  const isRunning = comparing.value === 'running';
  return (
    <>
      <p class="faint">{hints[tool]} Drag its handles in the view, or type.</p>
      {tool === 'regrade' && <AngleChoice />}
      <div class="slope-numbers">
        {fieldsOf(tool, numbers.value).map(({ key, title, unit }) => (
          <NumberInput key={`${tool} ${key}`} title={title} unit={unit} value={numbers.value[key] ?? null} take={(value) => setNumbers({ ...numbers.value, [key]: value ?? NaN })} />
        ))}
      </div>
      {tool === 'bench' && (
        <NumberInput title="or at elevation z" unit="m" value={made ? Number(made.line.at(-1)![1].toFixed(2)) : null} take={(value) => value !== null && setElevation(value)} />
      )}
      {problem.value !== null ? (
        <p class="problem error" role="alert">
          {problem.value}
        </p>
      ) : (
        made && (
          <p class="slope-areas" role="status">
            Cut <strong>{fixedText(made.cut, 2)}</strong>, fill <strong>{fixedText(made.fill, 2)}</strong> m² per m. Tool from x {fixedText(made.line[0]![0], 2)} to{' '}
            {fixedText(made.line.at(-1)![0], 2)} m.
          </p>
        )
      )}
      <div class="slope-actions">
        <button class="button primary" disabled={!made} onClick={apply}>
          Apply
        </button>
        <button class="button" disabled={!made || isRunning} title={`Runs the same rocks, at most ${mostRocks.toLocaleString('en')}, on both slopes`} onClick={() => void compare()}>
          {isRunning ? 'Comparing…' : 'Compare'}
        </button>
      </div>
      <NumberInput
        title="Keeps rocks before x"
        unit="m"
        value={station.value}
        empty={made ? fixedText(made.keeps[1], 2) : ''}
        take={(value) => setStation(value !== null && Number.isFinite(value) ? value : null)}
      />
      <Compared />
    </>
  );
}
