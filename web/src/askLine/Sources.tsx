// Where the rocks come from: a list of release places, as the scene colours them.

import { useState } from 'preact/hooks';
import { dimension } from '../project/place';
import { filter } from '../runs/filter';
import { counted } from '../units/numbers';
import { colourSources, sourceColour, type SourceColour } from './asked';
import { sourcePlaces, sourceText, sourceTitles, toggleRelease } from './sources';

const first = 5; // places that are listed without asking
const most = 200;

export function Sources({ hasKit }: { hasKit: boolean }) {
  const [isWhole, showWhole] = useState(false);
  const places = sourcePlaces.value;
  const is3d = dimension.value === 3;
  if (!places) return null;
  const chosen = new Set(filter.value.releases);
  const listed = places.slice(0, isWhole ? most : first);
  const others = [...chosen].filter((number) => !listed.some((place) => place.number === number));
  return (
    <div class="asked-sources">
      <h3>Where they start</h3>
      {(is3d || hasKit) && (
        <label class="choice">
          Release places
          <select value={sourceColour.value} onChange={(event) => colourSources(event.currentTarget.value as SourceColour)}>
            {(Object.keys(sourceTitles) as SourceColour[])
              .filter((key) => hasKit || key !== 'clearing')
              .map((key) => (
                <option key={key} value={key}>
                  {key === 'crossing' && !hasKit ? 'share that enters' : sourceTitles[key]}
                </option>
              ))}
          </select>
        </label>
      )}
      <ul>
        {listed.map((place) => (
          <li key={place.number}>
            <button
              class="button plain"
              aria-pressed={chosen.has(place.number)}
              title={chosen.has(place.number) ? 'Show the rocks of all places' : 'Show only the rocks of this place'}
              onClick={() => toggleRelease(place.number)}
            >
              {sourceText(place)}
            </button>
          </li>
        ))}
      </ul>
      {others.map((number) => (
        <button key={number} class="button plain" aria-pressed onClick={() => toggleRelease(number)}>
          Place {number + 1}: only its rocks are shown
        </button>
      ))}
      {places.length > first && (
        <button class="button plain" onClick={() => showWhole(!isWhole)}>
          {isWhole ? 'Fewer' : `All ${counted(places.length, 'place')}`}
        </button>
      )}
      {isWhole && places.length > most && <span class="faint">The first {most} are listed.</span>}
    </div>
  );
}
