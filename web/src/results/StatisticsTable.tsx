import type { FigureTexts } from '../api/results';
import { DataTable } from '../charts/DataTable';
import { DigitsSwitch } from '../charts/DigitsSwitch';
import { figureText, figuresOf, unitOfFigure } from './statisticsTable';

interface Props {
  caption: string;
  file: string;
  /// For each column: its name in the file, the column of the results if it has another name, its title, unit and values.
  columns: { key: string; quantity?: string; title: string; unit: string; figures: FigureTexts }[];
}

/// Descriptive statistics side by side, one statistic per row.
export function StatisticsTable({ caption, file, columns }: Props) {
  const first = columns[0];
  if (!first) return null;
  const shown = figuresOf(first.figures);
  return (
    <DataTable
      caption={caption}
      file={file}
      hasHeads
      tools={<DigitsSwitch />}
      columns={[
        { key: 'figure', title: 'Figure', isText: true },
        ...columns.map(({ figures: _, ...column }) => column),
      ]}
      unitAt={(row, c) => columns[c - 1] && unitOfFigure(shown[row]!.key, columns[c - 1]!.unit)}
      rows={shown.map(({ key, title }) => [
        title,
        ...columns.map(({ figures }) => figureText(figures, key)),
      ])}
    />
  );
}
