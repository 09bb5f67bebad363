// Pastes rows into an edit table and asks how to read ambiguous numbers.

import { useState } from 'preact/hooks';
import { Dialog } from './Dialog';
import { counted } from '../units/numbers';
import { readPasted, withoutNames, type Commas } from '../settings/pasted';

export interface Cell {
  row: number;
  column: number;
}

interface Props {
  columns: string[];
  hasRows: boolean;
  /// The text that was pasted into a cell.
  begun: (Cell & { text: string }) | null;
  close: () => void;
  take: (rows: string[][], where: 'instead' | 'below' | Cell) => void;
}

const meanings: Record<Commas, (number: string) => string> = {
  'separate thousands': (number) => `${number.replaceAll(',', '')}: commas separate thousands`,
  'are decimal': (number) => `${number.replace(',', '.')}: commas are decimal`,
  'separate columns': (number) => `${number.split(',').join(' and ')}: commas separate columns`,
};

export function PasteDialog({ columns, hasRows, begun, close, take }: Props) {
  const [text, setText] = useState(begun?.text ?? '');
  const [commas, setCommas] = useState<Commas | null>(null);
  const { open, rows: unresolved } = readPasted(text);
  const chosen = open && commas && open.readings.includes(commas) ? commas : undefined;
  const block = chosen ? readPasted(text, chosen).rows : unresolved;
  const rows = withoutNames(block, columns.length);
  const wrong = rows.findIndex((row) => row.length > columns.length);
  const fits = begun && begun.column + Math.max(...block.map((row) => row.length)) <= columns.length;
  const at = begun && { row: begun.row, column: fits ? begun.column : 0 };
  const isOpen = rows.length === 0 || (open !== null && chosen === undefined);
  return (
    <Dialog title="Paste rows" close={close}>
      <p class="faint">
        Columns {columns.join(', ')}: copied from a spreadsheet, or separated by commas, semicolons or spaces. A heading
        is skipped.
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
          <legend>How should {open.number} be read?</legend>
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
            Row {wrong + 1} has {rows[wrong]!.length} columns; only the first {columns.length} are used.
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
            {hasRows ? 'Replace all rows' : 'Add the rows'}
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
