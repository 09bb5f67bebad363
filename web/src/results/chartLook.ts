// Colours of plots, taken from the page's theme.

import type { EChartsOption } from 'echarts/types/dist/shared';

export interface Look {
  text: string;
  faint: string;
  line: string;
  panel: string;
  /// Of what is shown.
  shown: string;
  /// Of the run that is shown and of the one compared with it, side by side.
  runs: { shown: string; compared: string };
  /// For several things in one plot; they differ in lightness, too.
  series: string[];
  font: string;
}

/// Of a plot, in pixels.
export interface Size {
  width: number;
  height: number;
}

const pageStyle = () => getComputedStyle(document.documentElement);

export function lookOfPage(): Look {
  const style = pageStyle();
  const value = (name: string) => style.getPropertyValue(name).trim();
  const isDark = value('color-scheme') === 'dark' || style.colorScheme === 'dark';
  return {
    text: value('--text'),
    faint: value('--faint'),
    line: value('--line'),
    panel: value('--panel'),
    shown: value('--accent'),
    runs: { shown: value('--run-shown'), compared: value('--run-compared') },
    series: isDark
      ? ['#6fc3e0', '#ffa45c', '#7fd39b', '#d9a7e8', '#f2e27a', '#ff9c92', '#a3afb5']
      : ['#1f5f78', '#c2570c', '#1d6b3a', '#7b3f98', '#8a6d00', '#b3261e', '#5a6468'],
    font: value('--font'),
  };
}

/// What all plots have in common.
export function frame(look: Look): EChartsOption {
  return {
    animation: false,
    color: look.series,
    textStyle: { color: look.text, fontFamily: look.font, fontSize: 12 },
    grid: { left: 12, right: 18, top: 14, bottom: 8, outerBoundsMode: 'same', outerBoundsContain: 'all' },
    tooltip: {
      trigger: 'axis',
      renderMode: 'richText',
      confine: true,
      backgroundColor: look.panel,
      borderColor: look.line,
      textStyle: { color: look.text, fontSize: 12 },
      axisPointer: { lineStyle: { color: look.faint } },
    },
  };
}

/// A legend above the plot, and the room that it takes.
export const withLegend = (look: Look): EChartsOption => ({
  legend: { top: 0, textStyle: { color: look.text }, itemWidth: 16, itemHeight: 10, type: 'plain' },
  grid: { left: 12, right: 18, top: 34, bottom: 8, outerBoundsMode: 'same', outerBoundsContain: 'all' },
});

/// An axis of numbers with its title.
export function axis(look: Look, title: string) {
  return {
    type: 'value' as const,
    name: title,
    nameLocation: 'middle' as const,
    nameGap: 8,
    scale: true,
    nameTextStyle: { color: look.text },
    axisLabel: { color: look.faint, hideOverlap: true },
    axisLine: { show: true, lineStyle: { color: look.faint } },
    axisTick: { show: true, lineStyle: { color: look.faint } },
    splitLine: { lineStyle: { color: look.line, opacity: 0.6 } },
  };
}
