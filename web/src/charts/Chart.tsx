// A figure with its title and buttons to save it as PNG, SVG or CSV.

import type { ComponentChildren } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { saveCsv, savePng, saveSvg, type Cell } from '../figures/files';
import { hideTip } from '../figures/tip';
import type { Room } from '../figures/plot';
import '../figures/figures.css';
import { reportFailure } from '../state/messages';
import { shown } from '../runs/runs';

/// Highlights a point of a figure without the pointer; null: none.
type Point = (place: number | null) => void;

interface Props {
  title: string;
  /// A description for screen readers.
  description: string;
  file: string;
  /// Draws into an element of the given size.
  draw: (element: SVGSVGElement, room: Room) => Point | void;
  /// The drawn numbers; the first row has the column names.
  rows: () => Cell[][];
  /// Controls next to the title.
  tools?: ComponentChildren;
  /// A remark on the saved numbers.
  saving?: string | undefined;
  /// An error.
  note?: string | null;
  /// The point to highlight without the pointer.
  pointed?: number | null;
}

export function Chart({ title, description, file, draw, rows, tools, saving, note, pointed = null }: Props) {
  const box = useRef<HTMLDivElement>(null);
  const drawing = useRef<SVGSVGElement>(null);
  const point = useRef<Point | null>(null);
  const [{ width, height }, setRoom] = useState<Room>({ width: 0, height: 0 });

  useEffect(() => {
    const watch = new ResizeObserver(([entry]) => {
      if (entry) setRoom({ width: entry.contentRect.width, height: entry.contentRect.height });
    });
    watch.observe(box.current!);
    return () => watch.disconnect();
  }, []);

  useEffect(() => {
    if (width === 0 || height === 0) return;
    point.current = draw(drawing.current!, { width, height }) ?? null;
    return hideTip;
  }, [draw, width, height]);

  useEffect(() => point.current?.(pointed), [pointed]);

  const of = shown.peek()?.name;
  const fullTitle = of ? `${title}: ${of}` : title;
  return (
    <figure class="chart">
      <figcaption>
        <h3>{title}</h3>
        {tools}
        <span class="chart-buttons" role="group" aria-label={`Save: ${title}`}>
          <button class="button plain" onClick={() => void savePng(file, drawing.current!, fullTitle).catch(reportFailure)}>
            PNG
          </button>
          <button class="button plain" onClick={() => saveSvg(file, drawing.current!, fullTitle)}>
            SVG
          </button>
          <button class="button plain" title={saving} onClick={() => saveCsv(file, rows())}>
            CSV
          </button>
        </span>
      </figcaption>
      <div ref={box} class="chart-picture" role="img" aria-label={description}>
        <svg ref={drawing} class="drawing" />
      </div>
      {note && <span class="problem">{note}</span>}
    </figure>
  );
}
