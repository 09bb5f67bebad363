// What is asked: drawn, taken from the project, or read from a file.

import { useRef } from 'preact/hooks';
import { dimension } from '../project/place';
import { chosenFiles } from '../project/files';
import { TypedInput } from '../ui/TypedInput';
import { ofProject } from '../project/ofProject';
import { reportFailure } from '../state/messages';
import { model } from '../project/model';
import { shownPaths } from '../paths/drawnPaths';
import { ask, asked, setKitEnergy, setKitHeight } from './asked';
import { drawAsked, isDrawing, lineOfBarrier } from './askTools';
import { isTaking, takeFromMap, vectorLayers } from './fromMap';
import { takeLineFiles } from './lineFiles';

/// Of the contour to take; null: that of the place.
const elevation = ofProject<number | null>(null);

/// A barrier that the run had is asked for its own hits; another one is asked as a line. The kit is that of the barrier.
function askBarrier(name: string) {
  const barrier = model.value?.barriers.find((each) => each.name === name);
  if (barrier?.kind === 'barrier') {
    setKitHeight(barrier.height_m);
    if (barrier.capacity_kJ !== null) setKitEnergy(barrier.capacity_kJ);
  }
  const isOfRun = shownPaths.value?.header.barriers.includes(name) ?? false;
  ask(isOfRun ? { kind: 'barrier', name } : { kind: 'line', points: lineOfBarrier(name) }, `ask ${name}`);
}

export function AskedChoices() {
  const input = useRef<HTMLInputElement>(null);
  const is2d = dimension.value === 2;
  const barriers = model.value?.barriers ?? [];
  const now = asked.value;
  return (
    <div class="asked-choices">
      <button class="button" aria-pressed={isDrawing('line')} onClick={() => drawAsked('line')}>
        {is2d ? 'Pick a place' : 'Draw a line'}
      </button>
      {!is2d && (
        <button class="button" aria-pressed={isDrawing('polygon')} onClick={() => drawAsked('polygon')}>
          Draw an area
        </button>
      )}
      {!is2d && (
        <>
          <button class="button" title="A line or an area of a GeoPackage, Shapefile, GeoJSON or DXF, or points of a CSV file; or drop one on the page" onClick={() => input.current?.click()}>
            From a file
          </button>
          <input
            ref={input}
            type="file"
            hidden
            multiple
            aria-label="File with a line"
            onChange={(event) => void takeLineFiles(chosenFiles(event.currentTarget)).catch(reportFailure)}
          />
        </>
      )}
      {!is2d && vectorLayers().length > 0 && (
        <button class="button" title="A road or another line of a reference layer: click it in the view" aria-pressed={isTaking('layer')} onClick={() => takeFromMap('layer')}>
          From a layer
        </button>
      )}
      {!is2d && (
        <button class="button" title="The contour through a place: click it in the view" aria-pressed={isTaking('contour')} onClick={() => takeFromMap('contour', () => elevation.peek() ?? undefined)}>
          A contour
        </button>
      )}
      {isTaking('contour') && (
        <label class="asked-elevation">
          at
          <TypedInput
            label="Elevation of the contour"
            placeholder="of the place"
            value={elevation.value ?? undefined}
            take={(value) => (elevation.value = typeof value === 'number' ? value : null)}
          />
          m
        </label>
      )}
      {barriers.length > 0 && (
        <select
          aria-label="Barrier or collector"
          value={now?.kind === 'barrier' ? now.name : ''}
          onChange={(event) => event.currentTarget.value !== '' && askBarrier(event.currentTarget.value)}
        >
          <option value="">Barrier or collector…</option>
          {barriers.map(({ name }) => (
            <option key={name} value={name}>
              {name}
            </option>
          ))}
        </select>
      )}
      {!now && (
        <p class="faint">
          {is2d
            ? 'Pick a place on the slope: which rocks pass it, how fast, how high, and what would stop them.'
            : 'Draw a line on the terrain: which rocks cross it, how fast, how high, where they start, and what would stop them. Then drag the line or its corners.'}
        </p>
      )}
    </div>
  );
}
