// The view of a 2D model with its controls.

import { useEffect, useRef } from 'preact/hooks';
import { ToolHint } from '../drag/ToolHint';
import { model } from '../project/model';
import { Legends } from '../view/Legend';
import { showRock } from '../runs/chosenRock';
import { offerSheet } from '../view/sheet';
import { offerThumbnail } from '../project/thumbnail';
import { thumbnailOf } from '../view/thumbnail';
import { frame } from './framed';
import { blockUnder, keepDrawn, pathsToDraw, pointer } from './picture';
import { listen } from './pointing';
import { rockAt } from './pathLayer';
import { sectionPicture } from './sectionPrint';
import { sectionThumbnail } from './sectionThumbnail';
import { sectionLegends } from './sectionLegends';
import { SectionBar } from './SectionBar';
import '../scene/scene.css';

function Status() {
  const place = pointer.value;
  return (
    <div class="status-line">
      <ToolHint />
      {place && (
        <span class="mono">
          x {place.x.toFixed(2)} z {place.z.toFixed(2)} m
          {place.ground !== null && `, ground ${place.ground.toFixed(2)} m`}
        </span>
      )}
    </div>
  );
}

/// The rock of the block or the trajectory at a place of the canvas; null if there is none.
function rockOf(canvas: HTMLElement, event: MouseEvent): number | null {
  const [seen, now] = [pathsToDraw.value, frame.value];
  if (!now) return null;
  const box = canvas.getBoundingClientRect();
  const [left, top] = [event.clientX - box.left, event.clientY - box.top];
  return blockUnder(now, left, top) ?? (seen && rockAt(seen, now, left, top, 8));
}

/// A click on a block or a trajectory selects its rock; next to all trajectories it deselects.
function selectRock(canvas: HTMLElement, event: MouseEvent) {
  if (!pathsToDraw.value) return;
  showRock(rockOf(canvas, event));
}

export function SectionView() {
  const host = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const endDrawing = keepDrawn(host.current!, canvas.current!);
    const endOffering = offerThumbnail(() => thumbnailOf(sectionThumbnail));
    const endSheet = offerSheet(sectionPicture);
    const endListening = listen(canvas.current!, (event) => selectRock(canvas.current!, event), (event) => rockOf(canvas.current!, event));
    return () => {
      endOffering();
      endSheet();
      endDrawing();
      endListening();
    };
  }, []);
  const now = model.value;
  return (
    <div class="scene" ref={host}>
      <canvas
        ref={canvas}
        class="section-canvas"
        tabIndex={0}
        role="img"
        aria-label={`The slope in section, ${now?.seeders.length ?? 0} seeders, ${now?.barriers.length ?? 0} barriers and collectors. Arrow keys move the view, plus and minus zoom, 0 shows all.`}
      />
      <div class="above">
        <SectionBar />
        <Legends list={sectionLegends()} />
      </div>
      <Status />
    </div>
  );
}
