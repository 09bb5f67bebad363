import { zipSync, type Zippable } from 'fflate';
import { expect, test } from 'vitest';
import { unpacked } from './unzip';

const bytes = (text: string) => new TextEncoder().encode(text);
const archive = (members: Zippable) => zipSync(members) as Uint8Array<ArrayBuffer>;

/// Changes the size that the list of files claims for each member.
function claiming(zip: Uint8Array<ArrayBuffer>, size: number) {
  const view = new DataView(zip.buffer);
  for (let at = 0; at + 28 < zip.length; ++at) if (view.getUint32(at, true) === 0x02014b50) view.setUint32(at + 24, size, true);
  return zip;
}
const refusal = (zip: BlobPart) => unpacked([new File([zip], 'b.zip')]).catch((error: Error) => error.message);

test('the members of an archive take its place, without folders', async () => {
  const zip = archive({ gis: { 'roads.shp': bytes('shapes'), 'roads.dbf': [bytes('x'.repeat(5000)), { level: 9 }], '.hidden': bytes('') }, '__MACOSX/._roads.shp': bytes('') });
  const files = await unpacked([new File(['a'], 'a.tif'), new File([zip], 'roads.zip')]);
  expect(files.map(({ name }) => name)).toEqual(['a.tif', 'roads.shp', 'roads.dbf']);
  expect(await files[1]!.text()).toBe('shapes');
  expect((await files[2]!.text()).length).toBe(5000);
});

test('damaged archives are refused', async () => {
  expect(await refusal('PK')).toBe('b.zip could not be unpacked: invalid zip data');
  expect(await refusal(archive({ 'a.shp': bytes('x'.repeat(500)) }).slice(0, 60))).toBe('b.zip could not be unpacked: invalid zip data');
});

test('archives that would take all memory are refused before they are unpacked', async () => {
  const tooMuch = 'b.zip could not be unpacked: its files take more than 1 GB. Drop those that are needed';
  expect(await refusal(claiming(archive({ 'a.shp': bytes('a') }), 0xfffffff0))).toBe(tooMuch);
  expect(await refusal(claiming(archive({ 'a.shp': bytes('a'), 'b.shp': bytes('b') }), 6e8))).toBe(tooMuch);
  const many = Object.fromEntries(Array.from({ length: 1001 }, (_, k) => [`${k}`, new Uint8Array()]));
  expect(await refusal(archive(many))).toBe('b.zip could not be unpacked: it has more than 1,000 members');
});

test('a member that is longer than the archive claims gets no more memory', async () => {
  const [file] = await unpacked([new File([claiming(archive({ 'a.shp': bytes('x'.repeat(5000)) }), 10)], 'b.zip')]);
  expect(file!.size).toBe(10);
});
