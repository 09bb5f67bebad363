// The cells of a regular grid on plan that a ray crosses, in order.

import type { Ray } from 'three';

export interface PlanGrid {
  x: number;
  y: number;
  dx: number;
  dy: number;
  columns: number;
  rows: number;
}

/// Calls `visit` for each cell with the range of the ray's parameter in it, until it returns a number, which is returned.
export function walk(
  ray: Ray,
  { x, y, dx, dy, columns, rows }: PlanGrid,
  visit: (column: number, row: number, enter: number, leave: number) => number | null,
): number | null {
  const { origin: o, direction: d } = ray;
  let [enter, leave] = [0, Infinity];
  for (const [from, along, low, high] of [
    [o.x, d.x, x, x + dx * columns],
    [o.y, d.y, y, y + dy * rows],
  ] as const) {
    if (Math.abs(along) < 1e-12) {
      if (from < low || from > high) return null;
      continue;
    }
    const [a, b] = [(low - from) / along, (high - from) / along];
    enter = Math.max(enter, Math.min(a, b));
    leave = Math.min(leave, Math.max(a, b));
  }
  if (enter > leave) return null;
  const clamp = (value: number, last: number) => Math.min(last, Math.max(0, Math.floor(value)));
  let column = clamp((o.x + d.x * enter - x) / dx, columns - 1);
  let row = clamp((o.y + d.y * enter - y) / dy, rows - 1);
  const [stepX, stepY] = [Math.sign(d.x), Math.sign(d.y)];
  const edge = (k: number, step: number) => k + (step > 0 ? 1 : 0);
  for (;;) {
    const toX = stepX === 0 ? Infinity : (x + edge(column, stepX) * dx - o.x) / d.x;
    const toY = stepY === 0 ? Infinity : (y + edge(row, stepY) * dy - o.y) / d.y;
    const next = Math.min(toX, toY, leave);
    const found = visit(column, row, enter, next);
    if (found !== null) return found;
    if (next >= leave) return null;
    if (toX <= toY) column += stepX;
    else row += stepY;
    if (column < 0 || row < 0 || column >= columns || row >= rows) return null;
    enter = next;
  }
}

/// The intersection of a ray and a triangle (from either side), as the ray's parameter. Moeller and Trumbore (1997).
export function meet(ray: Ray, p: ArrayLike<number>, a: number, b: number, c: number): number | null {
  const { origin: o, direction: d } = ray;
  const [ax, ay, az] = [p[a]!, p[a + 1]!, p[a + 2]!];
  const [ux, uy, uz] = [p[b]! - ax, p[b + 1]! - ay, p[b + 2]! - az];
  const [vx, vy, vz] = [p[c]! - ax, p[c + 1]! - ay, p[c + 2]! - az];
  const [hx, hy, hz] = [d.y * vz - d.z * vy, d.z * vx - d.x * vz, d.x * vy - d.y * vx];
  const det = ux * hx + uy * hy + uz * hz;
  if (Math.abs(det) < 1e-18) return null;
  const [sx, sy, sz] = [o.x - ax, o.y - ay, o.z - az];
  const u = (sx * hx + sy * hy + sz * hz) / det;
  if (u < -1e-9 || u > 1 + 1e-9) return null;
  const [qx, qy, qz] = [sy * uz - sz * uy, sz * ux - sx * uz, sx * uy - sy * ux];
  const v = (d.x * qx + d.y * qy + d.z * qz) / det;
  if (v < -1e-9 || u + v > 1 + 1e-9) return null;
  const t = (vx * qx + vy * qy + vz * qz) / det;
  return t >= 0 ? t : null;
}
