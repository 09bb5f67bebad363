import { defineConfig, loadEnv } from 'vite';

// For development: `talus serve --port 8425`, then `npm run dev` in this folder. Requests are forwarded to the server as
// if the page came from there; TALUS_SERVER is the address of another one.
const server = loadEnv('', '.', 'TALUS_')['TALUS_SERVER'] ?? 'http://127.0.0.1:8425';

export default defineConfig({
  esbuild: { jsx: 'automatic', jsxImportSource: 'preact' },
  build: { target: 'es2022', chunkSizeWarningLimit: 1500 },
  server: {
    fs: { allow: ['..'] }, // docs
    proxy: {
      '/api': { target: server, changeOrigin: true, headers: { origin: server } },
    },
  },
});
