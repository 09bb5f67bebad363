// The files of a zip archive, such as a Shapefile is often sent in (APPNOTE.TXT of PKWARE, 6.3.10, sections 4.3.7, 4.3.12
// and 4.3.16). Folders and encrypted or unusually packed members are left out.

const endRecord = 0x06054b50;
const centralRecord = 0x02014b50;
const mostBytes = 2e9; // of one member, unpacked

async function inflated(packed: Uint8Array<ArrayBuffer>, size: number): Promise<Blob> {
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
  const parts: Uint8Array<ArrayBuffer>[] = [];
  let length = 0;
  for (const reader = stream.getReader(); ; ) {
    const { done, value } = await reader.read();
    if (done) break;
    length += value.length;
    if (length > size) {
      await reader.cancel();
      throw new Error('a member is longer than the archive says');
    }
    parts.push(value as Uint8Array<ArrayBuffer>);
  }
  return new Blob(parts);
}

export async function filesOfZip(archive: Blob): Promise<File[]> {
  const bytes = new Uint8Array(await archive.arrayBuffer());
  const view = new DataView(bytes.buffer);
  let end = bytes.length - 22;
  while (end >= 0 && view.getUint32(end, true) !== endRecord) --end;
  if (end < 0) throw new Error('it is not a zip archive, or not complete');
  const files: File[] = [];
  let at = view.getUint32(end + 16, true);
  for (let count = view.getUint16(end + 10, true); count > 0; --count) {
    if (view.getUint32(at, true) !== centralRecord) throw new Error('its list of files is damaged');
    const [flags, method] = [view.getUint16(at + 8, true), view.getUint16(at + 10, true)];
    const [packed, size] = [view.getUint32(at + 20, true), view.getUint32(at + 24, true)];
    const [nameLength, extra, comment] = [28, 30, 32].map((offset) => view.getUint16(at + offset, true)) as [number, number, number];
    const local = view.getUint32(at + 42, true);
    const path = new TextDecoder().decode(bytes.subarray(at + 46, at + 46 + nameLength));
    at += 46 + nameLength + extra + comment;
    const name = path.split(/[/\\]/).at(-1) ?? '';
    const isFile = name !== '' && !name.startsWith('.') && !path.startsWith('__MACOSX');
    if (!isFile || (flags & 1) !== 0 || (method !== 0 && method !== 8) || size > mostBytes) continue;
    const begin = local + 30 + view.getUint16(local + 26, true) + view.getUint16(local + 28, true);
    const content = bytes.slice(begin, begin + packed);
    files.push(new File([method === 0 ? content : await inflated(content, size)], name));
  }
  return files;
}

/// The files, with the members of archives in place of these.
export async function unpacked(list: readonly File[]): Promise<File[]> {
  const all: File[] = [];
  for (const one of list) {
    if (!/\.zip$/i.test(one.name)) {
      all.push(one);
      continue;
    }
    try {
      all.push(...(await filesOfZip(one)));
    } catch (error) {
      throw new Error(`${one.name} could not be unpacked: ${(error as Error).message}`);
    }
  }
  return all;
}
