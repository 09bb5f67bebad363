import { defineConfig, loadEnv, type Plugin } from 'vite';

// For development: `talus serve --port 8425`, then `npm run dev` in this folder. Requests are forwarded to the server as
// if the page came from there; TALUS_SERVER is the address of another one.
const server = loadEnv('', '.', 'TALUS_')['TALUS_SERVER'] ?? 'http://127.0.0.1:8425';

/// KaTeX names each font in three formats; browsers take the first.
const oneFormatOfFonts: Plugin = {
  name: 'one-format-of-fonts',
  enforce: 'pre',
  transform: (code, id) =>
    id.includes('katex.min.css') ? code.replace(/,url\([^)]*\.(woff|ttf)\) format\("\w+"\)/g, '') : undefined,
};

export default defineConfig({
  plugins: [oneFormatOfFonts],
  esbuild: { jsx: 'automatic', jsxImportSource: 'preact' },
  build: {
    target: 'es2022',
    chunkSizeWarningLimit: 1500,
    assetsInlineLimit: (file) => (file.endsWith('.woff2') ? false : undefined), // the server allows fonts as files only
  },
  server: {
    fs: { allow: ['..'] }, // docs
    proxy: {
      '/api': { target: server, changeOrigin: true, headers: { origin: server } },
    },
  },
});
