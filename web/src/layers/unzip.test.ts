import { expect, test } from 'vitest';
import { unpacked } from './unzip';

/// A member of an archive: its local header with the content, and its record in the directory.
function member(name: string, content: Uint8Array, size: number, method: number, offset: number): [Uint8Array, Uint8Array] {
  const letters = new TextEncoder().encode(name);
  const local = new DataView(new ArrayBuffer(30));
  local.setUint32(0, 0x04034b50, true);
  local.setUint16(26, letters.length, true);
  const central = new DataView(new ArrayBuffer(46));
  central.setUint32(0, 0x02014b50, true);
  central.setUint16(10, method, true);
  central.setUint32(20, content.length, true);
  central.setUint32(24, size, true);
  central.setUint16(28, letters.length, true);
  central.setUint32(42, offset, true);
  const join = (...parts: (Uint8Array | DataView)[]) => new Uint8Array(parts.flatMap((part) => [...(part instanceof DataView ? new Uint8Array(part.buffer) : part)]));
  return [join(local, letters, content), join(central, letters)];
}

async function zip(members: [string, string][], claims = (size: number) => size): Promise<File> {
  const locals: Uint8Array[] = [];
  const centrals: Uint8Array[] = [];
  let offset = 0;
  for (const [name, text] of members) {
    const plain = new TextEncoder().encode(text);
    const stream = new Blob([plain]).stream().pipeThrough(new CompressionStream('deflate-raw'));
    const packed = new Uint8Array(await new Response(stream).arrayBuffer());
    const [local, central] = member(name, packed, claims(plain.length), 8, offset);
    locals.push(local);
    centrals.push(central);
    offset += local.length;
  }
  const end = new DataView(new ArrayBuffer(22));
  end.setUint32(0, 0x06054b50, true);
  end.setUint16(10, members.length, true);
  end.setUint32(16, offset, true);
  return new File([...locals, ...centrals, end] as BlobPart[], 'roads.zip');
}

test('the members of an archive take its place, without folders', async () => {
  const archive = await zip([['gis/', ''], ['gis/roads.shp', 'shapes'], ['gis/roads.dbf', 'x'.repeat(5000)], ['__MACOSX/._roads.shp', '']]);
  const files = await unpacked([new File(['a'], 'a.tif'), archive]);
  expect(files.map(({ name }) => name)).toEqual(['a.tif', 'roads.shp', 'roads.dbf']);
  expect(await files[1]!.text()).toBe('shapes');
  expect((await files[2]!.text()).length).toBe(5000);
});

test('damaged archives are refused', async () => {
  await expect(unpacked([new File(['PK'], 'b.zip')])).rejects.toThrow('b.zip could not be unpacked: it is not a zip archive, or not complete');
  const bomb = await zip([['roads.shp', 'x'.repeat(5000)]], () => 10);
  await expect(unpacked([bomb])).rejects.toThrow('a member is longer than the archive says');
});
