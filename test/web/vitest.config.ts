import { defineConfig } from 'vitest/config';
import { fileURLToPath } from 'node:url';

// Tests are next to the tested files in web/src and use its libraries.
const web = fileURLToPath(new URL('../../web/', import.meta.url));

export default defineConfig({
  root: web,
  server: { fs: { allow: [fileURLToPath(new URL('../../', import.meta.url))] } },
  test: { include: ['src/**/*.test.ts'], cache: false },
});
