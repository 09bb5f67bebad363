// The address that a starting `talus serve` prints.

/// `server`: the process, whose standard output is piped.
export function addressOf(server) {
  let printed = '';
  return new Promise((found) =>
    server.stdout.on('data', (bytes) => {
      printed += bytes;
      const match = /http:\/\/127\.0\.0\.1:\d+\/\?token=\w+/.exec(printed);
      if (match) found(match[0]);
    }),
  );
}
