import { defineConfig } from 'vitest/config';
import { fileURLToPath } from 'node:url';

// Tests are next to the tested files in web/src and use its libraries.
const support = (name: string) => fileURLToPath(new URL(`./support/${name}`, import.meta.url));
const web = fileURLToPath(new URL('../../web/', import.meta.url));

export default defineConfig({
  root: web,
  server: { fs: { allow: [fileURLToPath(new URL('../../', import.meta.url))] } },
  // Files share their modules, as they do in the page: to load them anew for each file takes six times as long.
  test: { include: ['*.test.ts', 'src/**/*.test.ts'], cache: false, isolate: false, setupFiles: [support('storage.ts')] },
});
