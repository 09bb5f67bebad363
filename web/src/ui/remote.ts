// Data that a component loads from the server.

import { useEffect, useState } from 'preact/hooks';

export interface Remote<T> {
  /// The last response, also while the next one is loading.
  value: T | null;
  error: string | null;
  /// Whether loading takes so long that it should be shown.
  isSlow: boolean;
  again: () => void;
}

interface State<T> {
  value: T | null;
  error: string | null;
  isSlow: boolean;
  subject: string | null;
}

/// Loads whenever `key` changes (null: nothing to load). A response stays until the next one for the same `subject` (a
/// run) arrives, so that nothing flickers; responses for another subject are dropped at once.
export function useRemote<T>(
  subject: string,
  key: string | null,
  load: (signal: AbortSignal) => Promise<T>,
): Remote<T> {
  const [state, setState] = useState<State<T>>({ value: null, error: null, isSlow: false, subject: null });
  const [round, setRound] = useState(0);
  useEffect(() => {
    if (key === null) return;
    const own = new AbortController();
    const slow = setTimeout(() => setState((now) => ({ ...now, isSlow: true })), 250);
    const end = (next: Pick<State<T>, 'value' | 'error'>) => {
      clearTimeout(slow);
      if (!own.signal.aborted) setState({ ...next, isSlow: false, subject });
    };
    load(own.signal).then(
      (value) => end({ value, error: null }),
      (error: unknown) => end({ value: null, error: error instanceof Error ? error.message : String(error) }),
    );
    return () => {
      clearTimeout(slow);
      own.abort();
    };
  }, [subject, key, round]);
  const isOwn = state.subject === subject && key !== null;
  return {
    value: isOwn ? state.value : null,
    error: isOwn ? state.error : null,
    isSlow: state.isSlow,
    again: () => setRound(round + 1),
  };
}
