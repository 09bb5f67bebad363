// A server for each test, on an empty folder, and a page that is logged in.

import { test as base, expect, type Page } from '@playwright/test';
import { spawn, type ChildProcess } from 'node:child_process';
import { cpSync, existsSync, mkdtempSync, readFileSync, rmSync, utimesSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

export const program = process.env.TALUS_PROGRAM ?? join(import.meta.dirname, '../../../build/talus');
export const sources = process.env.TALUS_SOURCE_DIR ?? join(import.meta.dirname, '../../..');

export class Server {
  readonly folder = mkdtempSync(join(tmpdir(), 'talus-web-'));
  private child: ChildProcess | undefined;
  address = '';

  constructor(public port = 0) {}

  /// Starts the server, again on its previous port after a restart.
  async start(...more: string[]): Promise<string> {
    const arguments_ = ['serve', ...(more.length > 0 ? more : [this.folder]), '--port', String(this.port)];
    const child = spawn(program, arguments_, {
      cwd: this.folder,
      stdio: ['ignore', 'pipe', 'inherit'],
    });
    this.child = child;
    let output = '';
    this.address = await new Promise<string>((resolve, reject) => {
      child.stdout!.on('data', (bytes: Buffer) => {
        output += bytes.toString();
        const found = /http:\/\/127\.0\.0\.1:(\d+)\/\?token=\w+/.exec(output);
        if (!found) return;
        this.port = Number(found[1]);
        resolve(found[0]);
      });
      child.once('exit', (code) => reject(new Error(`talus serve ended with ${code}: ${output}`)));
    });
    return this.address;
  }

  /// Restarts the server and logs in the browser of an open page, because sessions end with their server.
  async startFor(page: Page) {
    await this.start();
    await page.request.get(this.address);
  }

  /// Ends the server: SIGKILL as in a crash, SIGTERM on request.
  async end(signal: NodeJS.Signals = 'SIGTERM') {
    const child = this.child;
    this.child = undefined;
    if (!child || child.exitCode !== null) return;
    const ended = new Promise((resolve) => child.once('exit', resolve));
    child.kill(signal);
    await ended;
  }

  async remove() {
    await this.end();
    rmSync(this.folder, { recursive: true, force: true });
  }

  read(name: string): string {
    return readFileSync(join(this.folder, name), 'utf8');
  }
  has(name: string): boolean {
    return existsSync(join(this.folder, name));
  }
  readBytes(name: string): Buffer {
    return readFileSync(join(this.folder, name));
  }
  write(name: string, content: string | Buffer) {
    writeFileSync(join(this.folder, name), content);
  }
  /// Sets the time of a file, in seconds from now.
  touch(name: string, seconds: number) {
    const time = Date.now() / 1000 + seconds;
    utimesSync(join(this.folder, name), time, time);
  }
  removeFile(name: string) {
    rmSync(join(this.folder, name));
  }
  copyExample(name: string) {
    cpSync(join(sources, 'examples', name), join(this.folder, name), { recursive: true });
  }
}

export const test = base.extend<{ answersFirst: boolean; server: Server; workbench: Page }>({
  /// Whether forms and tables fold away when a run ends, and inputs are varied by themselves, as for a new user. Otherwise
  /// as for one who has brought them back, has folded the answers, and has switched the variation off.
  answersFirst: [false, { option: true }],
  context: async ({ context, answersFirst }, use) => {
    if (!answersFirst)
      await context.addInitScript((values) => {
        if (!location.protocol.startsWith('http')) return; // an empty page has no storage
        for (const [key, value] of values) if (localStorage.getItem(key) === null) localStorage.setItem(key, value);
      }, [['side stays', 'true'], ['results stay', 'true'], ['vary inputs after runs', 'false'], ['answers open', 'false']] as const);
    await use(context);
  },
  server: async ({}, use) => {
    const server = new Server();
    await server.start();
    await use(server);
    await server.remove();
  },
  /// The start page. Errors in the console fail the test.
  workbench: async ({ page, server }, use) => {
    const faults: string[] = [];
    page.on('pageerror', (error) => faults.push(error.message));
    page.on('console', (message) => {
      if (message.type() === 'error' && /Content Security Policy|Uncaught/.test(message.text())) faults.push(message.text());
    });
    await page.goto(server.address);
    await use(page);
    expect(faults).toEqual([]);
  },
});

export { expect };
