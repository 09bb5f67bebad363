/// The name and code of a coordinate system from its well-known text, where the name is first and the code last.
export function crsText(wkt: string): string {
  const name = /^\s*\w+\["((?:[^"]|"")*)"/.exec(wkt);
  const id = /(?:ID|AUTHORITY)\["([^"]+)",\s*"?(\w+)"?\]\s*\]\s*$/.exec(wkt);
  return (name ? name[1]!.replace(/""/g, '"') : 'unnamed') + (id ? ` (${id[1]}:${id[2]})` : '');
}
