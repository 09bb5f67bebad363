// The horizontal axis of the section: x if any run is two-dimensional, otherwise the mean direction of travel.

import * as d3 from '../figures/d3';
import { runs, type Run } from './run';

interface OnPlan {
  x: number;
  y: number;
}
/// A point of a line on plan, or of a section: its distance and elevation.
export type Point = [number, number];

export interface Travel {
  along: (place: OnPlan) => number;
  label: string;
  /// Clockwise from the y axis; empty if the axis is x.
  bearing: string;
  origin: OnPlan;
  direction: Point;
  isX: boolean;
}

export const meanOf = (places: readonly OnPlan[]): OnPlan => ({
  x: d3.mean(places, ({ x }) => x) ?? 0,
  y: d3.mean(places, ({ y }) => y) ?? 0,
});

/// The first rows of the trajectories shown.
export const releasesOf = ({ rocks }: Run) => rocks.flatMap(({ rows }) => rows.slice(0, 1));
const lastRowsOf = ({ rocks }: Run) => rocks.flatMap(({ rows }) => rows.slice(-1));

export const travel = ((): Travel => {
  const starts = runs.flatMap(releasesOf);
  if (runs.some(({ isSection }) => isSection) || starts.length === 0) {
    return { along: ({ x }) => x, label: 'x', bearing: '', origin: { x: 0, y: 0 }, direction: [1, 0], isX: true };
  }
  const [origin, end] = [meanOf(starts), meanOf(runs.flatMap(lastRowsOf))];
  const [dx, dy] = [end.x - origin.x, end.y - origin.y];
  const length = Math.hypot(dx, dy);
  const direction: Point = length > 0 ? [dx / length, dy / length] : [1, 0];
  const bearing = ((Math.atan2(direction[0], direction[1]) * 180) / Math.PI + 360) % 360;
  return {
    along: ({ x, y }) => (x - origin.x) * direction[0] + (y - origin.y) * direction[1],
    label: 'Distance along the mean direction of travel',
    bearing: `${bearing.toFixed(0).padStart(3, '0')}°`,
    origin,
    direction,
    isX: false,
  };
})();
