// A new project beside the open one, made from it.

import { readFolder } from './files';
import { close, start } from './opening';
import { save } from './saving';
import { allWritten } from '../state/writes';

/// A name beside the project that no file has: "slope-posterior", without ending.
export async function freshStem(project: string, word: string): Promise<string> {
  const taken = new Set((await readFolder()).files.map(({ name }) => name));
  const stem = project.replace(/\.toml$/, '');
  for (let k = 1; ; ++k) {
    const name = `${stem}-${word}${k === 1 ? '' : `-${k}`}`;
    if (!taken.has(`${name}.toml`) && !taken.has(`${name}.csv`)) return name;
  }
}

/// Opens a new project and saves it. `opened` is called in between.
export async function openDerived(name: string, text: string, opened: () => void = () => {}) {
  close();
  await allWritten();
  start(name, text);
  opened();
  await save();
}
