// Rows for an edit table out of a text, and the questions that the text leaves open.

import { useState } from 'preact/hooks';
import { Dialog } from '../../ui/Dialog';
import { counted } from '../../ui/format';
import { readPasted, withoutNames, type Commas } from '../pasted';

export interface Cell {
  row: number;
  column: number;
}

interface Props {
  columns: string[];
  hasRows: boolean;
  /// What was pasted into a cell.
  begun: (Cell & { text: string }) | null;
  close: () => void;
  take: (rows: string[][], where: 'instead' | 'below' | Cell) => void;
}

const meanings: Record<Commas, (number: string) => string> = {
  'part thousands': (number) => `${number.replaceAll(',', '')}: commas part thousands`,
  'are decimal': (number) => `${number.replace(',', '.')}: commas are decimal`,
  'part columns': (number) => `${number.split(',').join(' and ')}: commas part columns`,
};

export function PasteDialog({ columns, hasRows, begun, close, take }: Props) {
  const [text, setText] = useState(begun?.text ?? '');
  const [commas, setCommas] = useState<Commas | null>(null);
  const { open, rows: asItStands } = readPasted(text);
  const chosen = open && commas && open.readings.includes(commas) ? commas : undefined;
  const block = chosen ? readPasted(text, chosen).rows : asItStands;
  const rows = withoutNames(block, columns.length);
  const wrong = rows.findIndex((row) => row.length > columns.length);
  const fits = begun && begun.column + Math.max(...block.map((row) => row.length)) <= columns.length;
  const at = begun && { row: begun.row, column: fits ? begun.column : 0 };
  const isOpen = rows.length === 0 || (open !== null && chosen === undefined);
  return (
    <Dialog title="Paste rows" close={close}>
      <p class="faint">
        Columns {columns.join(', ')}: copied from a spreadsheet, or apart by commas, semicolons or blanks. A heading is
        left out.
      </p>
      <textarea
        class="mono"
        aria-label="Rows"
        rows={10}
        cols={48}
        value={text}
        onInput={(event) => setText(event.currentTarget.value)}
      />
      {open && (
        <fieldset class="choices">
          <legend>What is {open.number}?</legend>
          {open.readings.map((reading) => (
            <label key={reading} class="check">
              <input
                type="radio"
                name="commas"
                checked={reading === chosen}
                onChange={() => setCommas(reading)}
              />
              {meanings[reading](open.number)}
            </label>
          ))}
        </fieldset>
      )}
      <p role="status">
        {counted(rows.length, 'row')}
        {wrong >= 0 && (
          <span class="problem">
            Row {wrong + 1} has {rows[wrong]!.length} columns; {columns.length} are taken, from the left.
          </span>
        )}
      </p>
      <div class="row">
        {at && (
          <button class="button first" disabled={isOpen} onClick={() => take(at.column === 0 ? rows : block, at)}>
            Paste from {columns[at.column]}, row {at.row + 1}
          </button>
        )}
        {(hasRows || !at) && (
          <button class={at ? 'button' : 'button first'} disabled={isOpen} onClick={() => take(rows, 'instead')}>
            {hasRows ? 'Replace all rows' : 'Take the rows'}
          </button>
        )}
        {hasRows && (
          <button class="button" disabled={isOpen} onClick={() => take(rows, 'below')}>
            Add below
          </button>
        )}
      </div>
    </Dialog>
  );
}
