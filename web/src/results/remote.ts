// What the server is asked for while something is looked at.

import { useEffect, useState } from 'preact/hooks';

export interface Remote<T> {
  /// The last answer; while another is on its way, that of before.
  value: T | null;
  error: string | null;
  /// Waiting long enough that it should be said.
  isSlow: boolean;
  again: () => void;
}

interface State<T> {
  value: T | null;
  error: string | null;
  isSlow: boolean;
  subject: string | null;
}

/// Asks whenever `key` changes; null: nothing to ask. Answers of one `subject` (a run) take each other's place when they
/// arrive, so that nothing flickers; those of another subject are not shown meanwhile.
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
