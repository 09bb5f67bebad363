// Finds the triangle that a ray meets.

import type { Ray } from 'three';
import { meet, walk, type PlanGrid } from './gridWalk';

/// A grid on plan with the triangles that overlap each cell.
export class TriangleBins {
  readonly grid: PlanGrid;
  private readonly starts: Uint32Array;
  private readonly members: Uint32Array;

  constructor(
    private readonly positions: Float32Array,
    private readonly triangles: Uint32Array,
  ) {
    let [x, y, X, Y] = [Infinity, Infinity, -Infinity, -Infinity];
    for (let k = 0; k < positions.length; k += 3) {
      x = Math.min(x, positions[k]!);
      X = Math.max(X, positions[k]!);
      y = Math.min(y, positions[k + 1]!);
      Y = Math.max(Y, positions[k + 1]!);
    }
    const count = triangles.length / 3;
    const side = Math.max(1e-6, Math.sqrt(((X - x) * (Y - y)) / Math.max(1, count / 2)));
    const columns = Math.min(2048, Math.max(1, Math.ceil((X - x) / side)));
    const rows = Math.min(2048, Math.max(1, Math.ceil((Y - y) / side)));
    this.grid = { x, y, dx: Math.max(1e-9, (X - x) / columns), dy: Math.max(1e-9, (Y - y) / rows), columns, rows };
    this.starts = new Uint32Array(columns * rows + 1);
    this.eachCell((cell) => void this.starts[cell + 1]!++);
    for (let k = 0; k < columns * rows; ++k) this.starts[k + 1]! += this.starts[k]!;
    const next = this.starts.slice();
    this.members = new Uint32Array(this.starts.at(-1)!);
    this.eachCell((cell, t) => void (this.members[next[cell]!++] = t));
  }

  private eachCell(visit: (cell: number, triangle: number) => void) {
    const { x, y, dx, dy, columns, rows } = this.grid;
    const p = this.positions;
    const within = (value: number, count: number) => Math.min(count - 1, Math.max(0, Math.floor(value)));
    for (let t = 0; t < this.triangles.length / 3; ++t) {
      const [a, b, c] = [3 * this.triangles[3 * t]!, 3 * this.triangles[3 * t + 1]!, 3 * this.triangles[3 * t + 2]!];
      const i0 = within((Math.min(p[a]!, p[b]!, p[c]!) - x) / dx, columns);
      const i1 = within((Math.max(p[a]!, p[b]!, p[c]!) - x) / dx, columns);
      const j0 = within((Math.min(p[a + 1]!, p[b + 1]!, p[c + 1]!) - y) / dy, rows);
      const j1 = within((Math.max(p[a + 1]!, p[b + 1]!, p[c + 1]!) - y) / dy, rows);
      for (let j = j0; j <= j1; ++j) for (let i = i0; i <= i1; ++i) visit(j * columns + i, t);
    }
  }

  pick(ray: Ray): { distance: number; triangle: number } | null {
    let triangle = -1;
    let least = Infinity;
    const slack = 1e-6 * (this.grid.dx + this.grid.dy);
    const distance = walk(ray, this.grid, (column, row, _, leave) => {
      const cell = row * this.grid.columns + column;
      for (let k = this.starts[cell]!; k < this.starts[cell + 1]!; ++k) {
        const t = this.members[k]!;
        const [a, b, c] = [this.triangles[3 * t]!, this.triangles[3 * t + 1]!, this.triangles[3 * t + 2]!];
        const found = meet(ray, this.positions, 3 * a, 3 * b, 3 * c);
        if (found !== null && found < least) [least, triangle] = [found, t];
      }
      return least <= leave + slack ? least : null;
    });
    const at = distance ?? (triangle >= 0 ? least : null);
    return at === null ? null : { distance: at, triangle };
  }
}
