// A tool that measures distances on the ground.

import { signal } from '@preact/signals';
import type { Point3 } from '../api/types';
import { showOverlay, tool, useTool, type Tool } from './tool';
import { numberText } from '../units/numbers';

const places = signal<Point3[]>([]);
const owner = 'distance';

/// The length of the polyline on plan and in space, and the height difference and slope from its first to its last point.
function measured([first, ...rest]: Point3[]): string {
  let [plan, space, before] = [0, 0, first!];
  for (const now of rest) {
    const along = Math.hypot(now[0] - before[0], now[1] - before[1]);
    plan += along;
    space += Math.hypot(along, now[2] - before[2]);
    before = now;
  }
  const up = before[2] - first![2];
  const slope = (Math.atan2(up, plan) * 180) / Math.PI;
  return `${numberText(plan)} m on plan, ${numberText(up)} m up, ${numberText(space)} m in space, ${slope.toFixed(1)}°`;
}

function take(next: Point3[]) {
  places.value = next;
  showOverlay(owner, next.length > 0 ? [{ points: next, kind: next.length > 1 ? 'line' : 'points' }] : []);
}

const distance: Tool = {
  name: 'Distance',
  hint: () => (places.value.length > 1 ? measured(places.value) : 'Click two or more points. Escape ends.'),
  click: ({ point }) => take([...places.value, point]),
  back: () => take(places.value.slice(0, -1)),
  cancel: () => take([]),
};

export function DistanceButton() {
  const isOn = tool.value === distance;
  return (
    <button class="button" aria-pressed={isOn} title="Measure distances on the ground" onClick={() => useTool(isOn ? null : distance)}>
      Distance
    </button>
  );
}
