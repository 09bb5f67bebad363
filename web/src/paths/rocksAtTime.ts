// The rocks at a time, interpolated between the points of their trajectories.

import type { DrawnPaths } from './drawnPaths';

export class RocksAtTime {
  /// Rock k is between the points `after[k] - 1` and `after[k]`, at the fraction `shares[k]`.
  readonly after: Uint32Array;
  readonly shares: Float32Array;

  constructor(private readonly paths: DrawnPaths) {
    this.after = paths.starts.slice(0, -1);
    this.shares = new Float32Array(this.after.length);
  }

  /// Finds the points around a time. A rock that has stopped stays at its last point.
  find(time: number) {
    const { starts, times } = this.paths;
    for (let k = 0; k < this.after.length; ++k) {
      const [first, last] = [starts[k]!, starts[k + 1]! - 1];
      let at = Math.max(first, this.after[k]!);
      // The time usually increases a little; after a step back the search restarts.
      if (at > first && times[at - 1]! > time) at = first;
      while (at < last && times[at]! < time) ++at;
      this.after[k] = at;
      const [from, to] = at > first ? [times[at - 1]!, times[at]!] : [0, 0];
      this.shares[k] = to > from ? Math.min(1, Math.max(0, (time - from) / (to - from))) : 1;
    }
  }

  /// Interpolates a quantity, such as `speeds`, with `size` numbers per point, into `result`.
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
