// Sends requests that write to the folder one after the other.

let last: Promise<unknown> = Promise.resolve();

export function writeInTurn<T>(request: () => Promise<T>): Promise<T> {
  const turn = last.then(request);
  last = turn.catch(() => undefined);
  return turn;
}

/// Resolves when all requests so far are done.
export const allWritten = () => last.then(() => undefined);
