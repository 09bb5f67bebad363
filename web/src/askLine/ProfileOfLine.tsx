// The profile along the asked line.

import { mostNeeded, mostNeededText } from './stretches';
import { useCallback, useMemo } from 'preact/hooks';
import type { LineAnswer } from '../api/line';
import { lineProfile, lineProfileRows } from '../figures/lineProfile';
import type { Room } from '../figures/plot';
import { Chart } from '../charts/Chart';
import { shownColour } from '../charts/colours';
import { fileName } from '../charts/save';
import { shown } from '../runs/runs';
import { displayOf } from '../state/displayUnits';
import { kept } from '../state/kept';
import { pointAt } from './askedOverlay';
import { hasPercentile, profileChoices, stretchesOf, type ProfileChoice } from './quantities';

const choice = kept<ProfileChoice>('profile of a line', 'ke_translational_J');

export function ProfileOfLine({ of }: { of: LineAnswer }) {
  const by = choice.value;
  const { title } = profileChoices[by];
  const stretches = useMemo(() => stretchesOf(of.sections, by, of.design_percentile), [of, by]);
  const whole = hasPercentile(by) ? `${title}, ${of.design_percentile} %` : title;
  const draw = useCallback(
    (element: SVGSVGElement, room: Room) =>
      lineProfile(element, room, {
        title: whole,
        ...displayOf(profileChoices[by].unit),
        stretches,
        worst: of.worst?.section ?? null,
        colour: shownColour,
        hover: (k) => pointAt(k === null ? null : [stretches[k]!.from, stretches[k]!.to]),
      }),
    [stretches, of],
  );
  if (stretches.length < 2) return null;
  const most = mostNeeded(of);
  return (
    <div class="asked-profile">
      <Chart
        title="Along the line"
        description={`${whole} in stretches of the line. The CSV button saves the numbers.`}
        file={fileName(shown.value?.name ?? '', 'asked line', by)}
        draw={draw}
        rows={() => lineProfileRows(by, stretches)}
        tools={
          <select aria-label="Quantity along the line" value={by} onChange={(event) => (choice.value = event.currentTarget.value as ProfileChoice)}>
            {Object.entries(profileChoices).map(([key, each]) => (
              <option key={key} value={key}>
                {hasPercentile(key as ProfileChoice) ? `${each.title}, ${of.design_percentile} %` : each.title}
              </option>
            ))}
          </select>
        }
      />
      {most.length > 0 && <p class="faint">A fence needs {mostNeededText(most)}.</p>}
    </div>
  );
}
