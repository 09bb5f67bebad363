// The display of trajectories, in a popover of each view's toolbar.

import { OverMap } from '../maps/OverMap';
import { shownMap } from '../maps/shownMap';
import { layers, showLayer } from '../view/settings';
import { Popover } from '../ui/Popover';
import { counted } from '../units/numbers';
import { colourBy, pathColour, pathColours, type PathColour } from './colouring';
import { comparedPaths, shownPaths } from './drawnPaths';

export function PathChoices() {
  const paths = shownPaths.value;
  if (!paths) return null;
  const { total } = paths.header;
  return (
    <Popover title="Trajectories">
      <label>
        <input type="checkbox" checked={layers.paths.value} onChange={(event) => showLayer('paths', event.currentTarget.checked)} />
        Show trajectories
      </label>
      {shownMap.value && <OverMap />}
      <fieldset disabled={comparedPaths.value !== null}>
        <legend>{comparedPaths.value ? 'Coloured by run while two runs are compared' : 'Coloured by'}</legend>
        {(Object.keys(pathColours) as PathColour[]).map((by) => (
          <label key={by}>
            <input type="radio" name="path colour" checked={pathColour.value === by} onChange={() => colourBy(by)} />
            {pathColours[by]}
          </label>
        ))}
      </fieldset>
      {paths.rocks.length < total && (
        <span class="faint">
          {paths.rocks.length.toLocaleString('en')} of {counted(total, 'trajectory', 'trajectories')} are drawn, evenly selected.
        </span>
      )}
    </Popover>
  );
}
