// Requests that write into the folder go one after the other, so that none overtakes another.

let last: Promise<unknown> = Promise.resolve();

export function writeInTurn<T>(request: () => Promise<T>): Promise<T> {
  const turn = last.then(request);
  last = turn.catch(() => undefined);
  return turn;
}

/// When all that were asked for so far are answered.
export const allWritten = () => last.then(() => undefined);
