// Where rocks are at a moment, between the points of their paths.

import type { DrawnPaths } from './drawnPaths';

export class RocksAtTime {
  /// Of rock k: between the points `after[k] - 1` and `after[k]` of its path, at `shares[k]` of the way.
  readonly after: Uint32Array;
  readonly shares: Float32Array;

  constructor(private readonly paths: DrawnPaths) {
    this.after = paths.starts.slice(0, -1);
    this.shares = new Float32Array(this.after.length);
  }

  /// A rock whose path has ended stays at its last point.
  find(time: number) {
    const { starts, times } = this.paths;
    for (let k = 0; k < this.after.length; ++k) {
      const [first, last] = [starts[k]!, starts[k + 1]! - 1];
      let at = Math.max(first, this.after[k]!);
      // Mostly a little after the moment before; after a jump back, from the beginning.
      if (at > first && times[at - 1]! > time) at = first;
      while (at < last && times[at]! < time) ++at;
      this.after[k] = at;
      const [from, to] = at > first ? [times[at - 1]!, times[at]!] : [0, 0];
      this.shares[k] = to > from ? Math.min(1, Math.max(0, (time - from) / (to - from))) : 1;
    }
  }

  /// A quantity of the points, such as `speeds`, at the moment; `size` numbers a point, into `result`.
  read(values: Float32Array, size: number, result: Float32Array, shift: ArrayLike<number> = [0, 0, 0]) {
    const { starts } = this.paths;
    for (let k = 0; k < this.after.length; ++k) {
      const b = this.after[k]!;
      const a = Math.max(starts[k]!, b - 1);
      const share = this.shares[k]!;
      for (let axis = 0; axis < size; ++axis) {
        const from = values[size * a + axis]!;
        result[size * k + axis] = from + share * (values[size * b + axis]! - from) + shift[axis]!;
      }
    }
  }
}
