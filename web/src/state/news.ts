// What the server tells of itself, once for all tabs of the workbench: a browser has few connections to a server, and a
// stream takes one for good. One tab listens and passes on what it hears; when it is closed, another one does.

export type News =
  | { kind: 'connected' | 'lost' }
  /// An event of the server, with its data as they came.
  | { kind: 'event'; event: string; data: string };

const again = 2000; // ms

/// Listens until `signal` says that it is enough.
function listen(events: readonly string[], tell: (news: News) => void, signal: AbortSignal) {
  const source = new EventSource('/api/events');
  signal.addEventListener('abort', () => source.close());
  source.onopen = () => tell({ kind: 'connected' });
  source.onerror = () => {
    tell({ kind: 'lost' });
    if (source.readyState === EventSource.CLOSED)
      setTimeout(() => !signal.aborted && listen(events, tell, signal), again);
  };
  for (const event of events)
    source.addEventListener(event, ({ data }: MessageEvent<string>) => tell({ kind: 'event', event, data }));
}

/// Hears events of these names, in this tab or through another one; ends with the function that is given back.
export function hearNews(events: readonly string[], hear: (news: News) => void): () => void {
  const end = new AbortController();
  // Only pages that came from the computer itself, or safely, have locks.
  if (!navigator.locks) {
    listen(events, hear, end.signal);
    return () => end.abort();
  }
  const channel = new BroadcastChannel('news of the server');
  channel.onmessage = ({ data }: MessageEvent<News>) => hear(data);
  const tell = (news: News) => {
    channel.postMessage(news);
    hear(news);
  };
  const turn = () => {
    listen(events, tell, end.signal);
    return new Promise<void>((done) => end.signal.addEventListener('abort', () => done()));
  };
  navigator.locks.request('listens to the server', { signal: end.signal }, turn).catch(() => undefined);
  return () => {
    end.abort();
    channel.close();
  };
}
