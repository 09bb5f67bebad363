import { defineConfig } from 'vitest/config';
import { fileURLToPath } from 'node:url';

// Tests stand beside what they test, in web/src, whose own libraries they use.
const web = fileURLToPath(new URL('../../web/', import.meta.url));

export default defineConfig({
  root: web,
  server: { fs: { allow: [fileURLToPath(new URL('../../', import.meta.url))] } },
  test: { include: ['src/**/*.test.ts'], cache: false },
});
