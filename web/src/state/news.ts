// Events of the server, received once for all tabs of the workbench: a browser has few connections to a server, and an
// event stream occupies one permanently. One tab listens and forwards events; when it is closed, another one takes over.

export type News =
  | { kind: 'connected' | 'lost' }
  /// An event of the server with its raw data.
  | { kind: 'event'; event: string; data: string };

const retryDelay = 2000; // ms

/// Listens until `signal` is aborted.
function listen(events: readonly string[], forward: (news: News) => void, signal: AbortSignal) {
  const source = new EventSource('/api/events');
  signal.addEventListener('abort', () => source.close());
  source.onopen = () => forward({ kind: 'connected' });
  source.onerror = () => {
    forward({ kind: 'lost' });
    if (source.readyState === EventSource.CLOSED)
      setTimeout(() => !signal.aborted && listen(events, forward, signal), retryDelay);
  };
  for (const event of events)
    source.addEventListener(event, ({ data }: MessageEvent<string>) => forward({ kind: 'event', event, data }));
}

/// Receives events of these names, directly or through another tab. Returns a function that ends this.
export function subscribe(events: readonly string[], receive: (news: News) => void): () => void {
  const end = new AbortController();
  // Locks exist only in secure contexts: localhost and HTTPS.
  if (!navigator.locks) {
    listen(events, receive, end.signal);
    return () => end.abort();
  }
  const channel = new BroadcastChannel('news of the server');
  channel.onmessage = ({ data }: MessageEvent<News>) => receive(data);
  const forward = (news: News) => {
    channel.postMessage(news);
    receive(news);
  };
  const turn = () => {
    listen(events, forward, end.signal);
    return new Promise<void>((done) => end.signal.addEventListener('abort', () => done()));
  };
  navigator.locks.request('listens to the server', { signal: end.signal }, turn).catch(() => undefined);
  return () => {
    end.abort();
    channel.close();
  };
}
