// The points of what is asked, for typing and for exact numbers.

import { useState } from 'preact/hooks';
import type { Point2 } from '../api/types';
import { EditTable } from '../ui/EditTable';
import { dimension } from '../project/place';
import { cellsOf } from '../settings/rows';
import type { Waiting } from '../settings/waitingRows';
import { ofProject } from '../project/ofProject';
import { ask, askedNow } from './asked';
import { pointsOf } from './askTools';

const waiting = ofProject<readonly Waiting[]>([]);

export function AskedPoints() {
  const now = askedNow.value;
  const [isOpen, setOpen] = useState(false);
  const is2d = dimension.value === 2;
  const points = now ? pointsOf(now) : [];
  const kind = now?.kind === 'polygon' ? 'polygon' : 'line';
  const take = (rows: unknown[][]) => {
    if (!rows.flat().every((value) => typeof value === 'number' && Number.isFinite(value))) return;
    const next = rows.map(([x, y = 0]): Point2 => [x as number, y as number]);
    ask(next.length > 0 ? { kind, points: next } : null, `change the asked ${kind === 'polygon' ? 'area' : 'line'}`);
  };
  return (
    <details class="asked-points" open={isOpen} onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary>{is2d ? 'Place, x [m]' : 'Points, x and y [m]'}</summary>
      <EditTable
        label={kind === 'polygon' ? 'Asked area' : 'Asked line'}
        columns={is2d ? ['x'] : ['x', 'y']}
        cells={cellsOf(is2d ? points.map(([x]) => [x]) : points, is2d ? 1 : 2)}
        least={is2d ? 1 : 2}
        take={take}
        waiting={waiting.value}
        keepWaiting={(rows) => (waiting.value = rows)}
      >
        {now && (
          <button class="button" onClick={() => ask(null, 'remove the asked line')}>
            Remove
          </button>
        )}
      </EditTable>
    </details>
  );
}
