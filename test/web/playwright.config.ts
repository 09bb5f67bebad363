import { defineConfig } from '@playwright/test';

const isRoot = process.getuid?.() === 0;

export default defineConfig({
  testDir: 'pages',
  outputDir: 'results',
  workers: 2,
  fullyParallel: true,
  retries: 1, // on a busy machine a test may be too slow once; it is reported as flaky
  timeout: 90_000,
  expect: { timeout: 15_000 },
  reporter: [['list']],
  use: {
    viewport: { width: 1366, height: 768 },
    trace: 'on-first-retry', // tracing every test takes a tenth of the time
    contextOptions: { reducedMotion: 'reduce' }, // playing rocks is slow without a graphics card
    launchOptions: {
      executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
      args: [
        // WebGL is drawn by software, and the page is composed without it, which takes half the time. Root, as on build
        // machines, has no sandbox.
        '--use-gl=angle',
        '--use-angle=swiftshader',
        '--enable-unsafe-swiftshader',
        '--disable-gpu-compositing',
        '--disable-background-networking',
        ...(isRoot ? ['--no-sandbox'] : []),
      ],
    },
  },
});
