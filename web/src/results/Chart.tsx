// A plot with its title, and buttons that save it: as a picture, as a drawing, as the table that it draws.

import type { EChartsType } from 'echarts/core';
import type { EChartsOption } from 'echarts/types/dist/shared';
import type { ComponentChildren } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { sayFailure } from '../state/messages';
import { shown } from '../state/runs';
import { shade } from '../view/theme';
import { frame, lookOfPage, type Look, type Size } from './chartLook';
import { savePng, saveSvg } from './picture';
import { saveCsv, type Cell } from './save';

interface Props {
  title: string;
  /// What the plot shows, for who cannot see it.
  description: string;
  file: string;
  option: (look: Look, size: Size) => EChartsOption;
  /// Whether the option depends on the size.
  followsSize?: boolean;
  /// The numbers that are drawn; the first row names the columns.
  rows: () => Cell[][];
  /// Beside the title.
  tools?: ComponentChildren;
  /// What is said of the saved numbers.
  saving?: string;
  /// What is wrong with it.
  note?: string | null;
  choose?: (event: { seriesName?: string; dataIndex?: number; data?: unknown }) => void;
  /// Where on the first axis the pointer is; null: it left.
  hover?: (value: number | null) => void;
  /// A place of the first series that is pointed at without the pointer.
  pointed?: number | null;
}

export function Chart({ title, description, file, option, followsSize, rows, tools, saving, note, choose, hover, pointed = null }: Props) {
  const box = useRef<HTMLDivElement>(null);
  const [chart, setChart] = useState<EChartsType | null>(null);
  const look = shade.value;
  const chosen = useRef(choose);
  chosen.current = choose;
  const hovered = useRef(hover);
  hovered.current = hover;
  const isTold = useRef(false);
  const [size, setSize] = useState<Size>({ width: 0, height: 0 });

  useEffect(() => {
    let made: EChartsType | null = null;
    let isGone = false;
    const watch = new ResizeObserver(() => {
      made?.resize();
      if (followsSize && made) setSize({ width: made.getWidth(), height: made.getHeight() });
    });
    import('./echarts').then(({ init }) => {
      if (isGone || !box.current) return;
      made = init(box.current, null, { renderer: 'svg' });
      made.on('click', (event) => chosen.current?.(event as object));
      made.on('updateAxisPointer', (event) => {
        const value = (event as { axesInfo?: { value: number }[] }).axesInfo?.[0]?.value;
        if (value !== undefined && !isTold.current) hovered.current?.(value);
      });
      made.getZr().on('globalout', () => hovered.current?.(null));
      watch.observe(box.current);
      setChart(made);
    }, sayFailure);
    return () => {
      isGone = true;
      watch.disconnect();
      made?.dispose();
    };
  }, []);

  useEffect(() => {
    const now = lookOfPage();
    chart?.setOption({ ...frame(now), ...option(now, size) }, { notMerge: true });
  }, [chart, option, look, size]);

  useEffect(() => {
    isTold.current = true;
    chart?.dispatchAction(
      pointed === null ? { type: 'hideTip' } : { type: 'showTip', seriesIndex: 0, dataIndex: pointed },
    );
    isTold.current = false;
  }, [chart, pointed]);

  const heading = () => {
    const { panel, text } = lookOfPage();
    const of = shown.peek()?.name;
    return { title: of ? `${title}: ${of}` : title, ground: panel, text };
  };
  const drawing = () => box.current?.querySelector('svg') ?? null;
  return (
    <figure class="chart">
      <figcaption>
        <h3>{title}</h3>
        {tools}
        <span class="chart-buttons" role="group" aria-label={`Save: ${title}`}>
          <button class="button plain" onClick={() => savePng(`${file}.png`, drawing(), heading())}>
            PNG
          </button>
          <button class="button plain" onClick={() => saveSvg(`${file}.svg`, drawing(), heading())}>
            SVG
          </button>
          <button class="button plain" title={saving} onClick={() => saveCsv(file, rows())}>
            CSV
          </button>
        </span>
      </figcaption>
      <div ref={box} class="chart-picture" role="img" aria-label={description} />
      {note && <span class="problem">{note}</span>}
    </figure>
  );
}
