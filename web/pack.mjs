// Prepares the built page for embedding in the program: adds the licences, compresses each file, and lists the types.
// Usage: node pack.mjs FOLDER
import { readdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { extname, join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { licences } from './licences.mjs';

const types = {
  '.css': 'text/css; charset=utf-8',
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.json': 'application/json',
  '.svg': 'image/svg+xml',
  '.txt': 'text/plain; charset=utf-8',
  '.webp': 'image/webp',
  '.woff2': 'font/woff2',
};

const folder = process.argv[2];
if (!folder) throw new Error('usage: node pack.mjs FOLDER');
writeFileSync(join(folder, 'licences.txt'), licences(fileURLToPath(new URL('.', import.meta.url))));
const files = readdirSync(folder, { recursive: true })
  .map((name) => join(folder, String(name)))
  .filter((file) => statSync(file).isFile())
  .sort();

const lines = files.map((file) => {
  const type = types[extname(file)];
  if (!type) throw new Error(`${file}: no media type for this extension`);
  writeFileSync(file, gzipSync(readFileSync(file), { level: 9 }));
  return `${relative(folder, file)}\t${type}\n`;
});
writeFileSync(join(folder, 'types.txt'), lines.join(''));
