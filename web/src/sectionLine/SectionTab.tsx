// The ground along a drawn or typed line.

import { useCallback, useState } from 'preact/hooks';
import type { GroundSection, Point2 } from '../api/types';
import { cellsOf } from '../settings/rows';
import { EditTable } from '../ui/EditTable';
import { extentOfProfile, profile } from '../figures/profile';
import type { Room } from '../figures/plot';
import { shownPaths } from '../paths/drawnPaths';
import { saveCsv } from '../figures/files';
import { Chart } from '../charts/Chart';
import { shownColour } from '../charts/colours';
import { copyRows, fileName } from '../charts/save';
import { fileStem } from '../project/document';
import { notify, reportFailure, resolve } from '../state/messages';
import { counted, numberText } from '../units/numbers';
import { equalAxes, setEqualAxes } from '../view/settings';
import { CorridorChoices } from './CorridorChoices';
import { corridorTraces } from './corridorTraces';
import { equalRanges, gapsOf } from './groundSection';
import { makeSectionProject } from './makeSectionProject';
import { drawSection, groundSection, keepRows, mark, marked, refusal, removeSection, sectionLine, takeLine, waitingRows } from './sectionLine';
import { envelopeRows, placeText, sectionRows } from './sectionPlot';
import { useEnvelope } from './useEnvelope';
import './sectionLine.css';

/// A notice on parts of the line without terrain.
function Gaps({ of }: { of: GroundSection }) {
  const gaps = gapsOf(of);
  if (gaps.length === 0) return null;
  if (of.z_m.every((z) => z === null))
    return <p class="problem warning">There is no terrain anywhere along this line.</p>;
  const shown = gaps.slice(0, 4).map(([from, to]) => `${numberText(from)} m to ${to === null ? 'the end' : `${numberText(to)} m`}`);
  const more = gaps.length > shown.length ? ` and in ${counted(gaps.length - shown.length, 'more part')}` : '';
  return (
    <p class="problem warning">
      No terrain from {shown.join(', from ')}
      {more}.
    </p>
  );
}

function Plot({ of }: { of: GroundSection }) {
  const isEqual = equalAxes.value;
  const traces = corridorTraces.value;
  const { envelope, error } = useEnvelope();
  const draw = useCallback(
    (element: SVGSVGElement, room: Room) => {
      const shownNow = { distance: of.distance_m, z: of.z_m, traces };
      const [along, heights] = extentOfProfile(shownNow);
      return profile(element, room, {
        ...shownNow,
        colour: shownColour,
        envelope,
        fit: isEqual && heights[1] > heights[0] ? (width, height) => equalRanges(along, heights, width, height) : undefined,
        textOf: (place) => placeText(of, place, '\n'),
        hover: mark,
      });
    },
    [of, isEqual, traces, envelope],
  );
  const k = marked.value;
  const [slid, setSlid] = useState<number | null>(null);
  const slide = (place: number | null) => {
    setSlid(place);
    mark(place);
  };
  return (
    <div class="section-plot">
      <Chart
        title="Ground along the line"
        description="Elevation of the ground against the distance along the line, with the trajectories beside it. The CSV button saves the ground, the slider below moves along it."
        note={error}
        file={fileName(fileStem(), 'section')}
        draw={draw}
        rows={() => sectionRows(of)}
        pointed={slid}
        tools={
          <>
            {shownPaths.value && <CorridorChoices />}
            <label class="choice" title="The same scale on both axes">
              <input type="checkbox" checked={isEqual} onChange={(event) => setEqualAxes(event.currentTarget.checked)} />
              Equal axes
            </label>
            <span class="chart-buttons">
              {envelope && (
                <button
                  class="button plain"
                  title="Save the envelope as CSV"
                  onClick={() => saveCsv(fileName(fileStem(), 'section', 'envelope'), envelopeRows(envelope))}
                >
                  Envelope CSV
                </button>
              )}
              <button class="button plain" onClick={() => copyRows(sectionRows(of))}>
                Copy
              </button>
            </span>
          </>
        }
      />
      <div class="section-place">
        <label class="choice">
          Position
          <input
            type="range"
            min="0"
            max={of.distance_m.length - 1}
            step="1"
            value={k ?? 0}
            aria-valuetext={placeText(of, k ?? 0)}
            onInput={(event) => slide(Number(event.currentTarget.value))}
            onBlur={() => slide(null)}
          />
        </label>
        <output class="mono">{k === null ? counted(of.distance_m.length, 'point') : placeText(of, k)}</output>
      </div>
      <Gaps of={of} />
    </div>
  );
}

function Missing({ places }: { places: number }) {
  if (refusal.value !== null) return <p class="problem">{refusal.value}</p>;
  if (places >= 2) return <div class="empty">Loading the ground…</div>;
  return (
    <div class="empty">
      <p>
        {places === 0
          ? 'Click a line on the terrain, or type its points here, to see the ground along it.'
          : 'A line needs at least two points.'}
      </p>
      <button class="button" style={{ justifySelf: 'center' }} onClick={drawSection}>
        Draw a line
      </button>
    </div>
  );
}

export function SectionTab() {
  const line = sectionLine.value ?? [];
  const section = groundSection.value;
  const takeValid = (points: Point2[]) => {
    resolve('section line');
    takeLine(points);
  };
  const take = (rows: unknown[][]) => {
    if (rows.flat().every((value) => typeof value === 'number' && Number.isFinite(value))) takeValid(rows as Point2[]);
    else notify('error', 'Points of the line must be numbers: x and y in metres.', 'section line');
  };
  return (
    <div class="section-tab">
      {section ? <Plot of={section} /> : <Missing places={line.length} />}
      <section class="section-line" aria-label="Line of the section">
        <h3>Line, x and y [m]</h3>
        <EditTable
          label="Line of the section"
          columns={['x', 'y']}
          cells={cellsOf(line, 2)}
          least={2}
          take={take}
          waiting={waitingRows.value}
          keepWaiting={keepRows}
        >
          {section && (
            <button
              class="button"
              title="A new project with this section, the same materials, and the seeders and barriers of the corridor"
              onClick={() => void makeSectionProject(section, line).catch(reportFailure)}
            >
              Make a 2D project
            </button>
          )}
          {line.length > 0 && (
            <>
              <button class="button" onClick={drawSection}>
                Redraw
              </button>
              <button class="button" onClick={() => takeLine(line.toReversed())}>
                Reverse
              </button>
            </>
          )}
          <button class="button" onClick={removeSection}>
            {line.length > 0 ? 'Remove' : 'Close'}
          </button>
        </EditTable>
      </section>
    </div>
  );
}
