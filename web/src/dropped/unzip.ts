// The files of a zip archive, such as a Shapefile is often sent in. Unpacked here and not in a worker, which the page's
// security policy forbids.

import { unzipSync, type UnzipFileInfo } from 'fflate';

const mostBytes = 1e9; // of all members, unpacked
const mostMembers = 1000;

const nameOf = (path: string) => path.split(/[/\\]/).at(-1) ?? '';
const isFile = (path: string) => nameOf(path) !== '' && !nameOf(path).startsWith('.') && !path.startsWith('__MACOSX');

/// Throws before anything is unpacked, by the sizes that the archive claims. No member gets more memory than that.
function checkSize(archive: Uint8Array) {
  let [bytes, members] = [0, 0];
  const add = ({ name, originalSize }: UnzipFileInfo) => {
    if (++members > mostMembers) throw new Error(`it has more than ${mostMembers.toLocaleString('en')} members`);
    if (isFile(name)) bytes += originalSize;
    return false;
  };
  unzipSync(archive, { filter: add });
  if (!(bytes <= mostBytes)) throw new Error(`its files take more than ${mostBytes / 1e9} GB. Drop those that are needed`);
}

async function filesOfZip(file: Blob): Promise<File[]> {
  const archive = new Uint8Array(await file.arrayBuffer());
  checkSize(archive);
  const found = unzipSync(archive, { filter: ({ name }) => isFile(name) });
  return Object.entries(found).map(([path, content]) => new File([content as Uint8Array<ArrayBuffer>], nameOf(path)));
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
