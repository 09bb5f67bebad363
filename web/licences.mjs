// The licences of the packages in the built page: the text of `licences.txt` next to the page.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

/// The licences of all packages that are not only for development, from package-lock.json and node_modules.
export function licences(folder) {
  const lock = JSON.parse(readFileSync(join(folder, 'package-lock.json'), 'utf8'));
  const parts = Object.entries(lock.packages)
    .filter(([path, entry]) => path !== '' && !entry.dev && !entry.optional && !entry.peer)
    .map(([path, entry]) => {
      const home = join(folder, path);
      if (!existsSync(home)) throw new Error(`${path} is missing: run npm ci`);
      const files = readdirSync(home, { withFileTypes: true }).flatMap((entry) =>
        entry.isFile() && /^(licen[cs]e|notice)/i.test(entry.name) ? [entry.name] : [],
      );
      if (files.length === 0 && !entry.license) throw new Error(`${path} has no licence`);
      const texts = files.map((name) => readFileSync(join(home, name), 'utf8').trim());
      const title = `${path.slice('node_modules/'.length)} ${entry.version} (${entry.license})`;
      return [title, '='.repeat(title.length), ...texts].join('\n\n');
    });
  return ['The workbench is made with these packages.', ...parts].join('\n\n\n') + '\n';
}
