// Requests to the server of the page.

import { readArrays, type Arrays } from './arrays';
import type { TomlTable } from '../toml/format';
import { jsonText } from '../toml/json';
import { noticingDelay } from './patience';
import type {
  About,
  DeletedProject,
  Draft,
  Example,
  FolderFile,
  LibraryMaterial,
  ModelAnswer,
  Point2,
  PolygonsAnswer,
  Problem,
  ProjectText,
  Revision,
  Run,
  Verification,
} from './types';

/// An error response with the problems that the server reports.
export class Refused extends Error {
  constructor(
    readonly status: number,
    readonly problems: Problem[],
  ) {
    super(problems.map((problem) => problem.text).join('\n') || `the server responded with ${status}`);
  }
}

/// The server was stopped, or the connection is broken.
class Unreachable extends Error {
  constructor() {
    super('The server does not respond. Start talus serve again and open the address it prints. Nothing on this page is lost.');
  }
}

async function ask(method: string, path: string, body?: unknown, signal?: AbortSignal): Promise<Response> {
  let response: Response;
  try {
    response = await noticingDelay(
      fetch(path, {
        method,
        ...(body !== undefined && { headers: { 'Content-Type': 'application/json' }, body: jsonText(body) }),
        ...(signal && { signal }),
      }),
    );
  } catch (error) {
    if (error instanceof DOMException && error.name === 'AbortError') throw error;
    throw new Unreachable();
  }
  if (response.ok) return response;
  const answer = (await response.json().catch(() => null)) as { problems?: Problem[] } | null;
  throw new Refused(response.status, answer?.problems ?? []);
}

export async function getJson<T>(path: string, signal?: AbortSignal): Promise<T> {
  return (await ask('GET', path, undefined, signal)).json() as Promise<T>;
}
export async function getText(path: string, signal?: AbortSignal): Promise<string> {
  return (await ask('GET', path, undefined, signal)).text();
}
export async function getBlob(path: string, signal?: AbortSignal): Promise<Blob> {
  return (await ask('GET', path, undefined, signal)).blob();
}
export async function sendJson<T>(method: 'POST' | 'PUT' | 'PATCH', path: string, body: unknown, signal?: AbortSignal) {
  return (await ask(method, path, body, signal)).json() as Promise<T>;
}
export async function getArrays<Header>(path: string, signal?: AbortSignal): Promise<Arrays<Header>> {
  return readArrays<Header>(await (await ask('GET', path, undefined, signal)).arrayBuffer());
}
export async function askArrays<Header>(path: string, body: unknown, signal?: AbortSignal): Promise<Arrays<Header>> {
  return readArrays<Header>(await (await ask('POST', path, body, signal)).arrayBuffer());
}

const name = (file: string) => file.split('/').map(encodeURIComponent).join('/');

export const api = {
  about: () => getJson<About>('/api/about'),
  materials: async () => (await getJson<{ materials: LibraryMaterial[] }>('/api/materials')).materials,
  /// The probability density of a random property; its limits depend on the key.
  distribution: (key: string, property: TomlTable, signal?: AbortSignal) =>
    sendJson<{ density: Point2[]; problems: Problem[] }>('POST', '/api/distribution', { key, ...property }, signal),
  polygons: (asked: { polylines: unknown; tolerance_m: number }, signal?: AbortSignal) =>
    sendJson<PolygonsAnswer>('POST', '/api/geometry/polygons', asked, signal),
  newAddress: async () => (await sendJson<{ address: string }>('POST', '/api/tokens', {})).address,
  examples: async () => (await getJson<{ examples: Example[] }>('/api/examples')).examples,
  openExample: (id: string) => sendJson<{ project: string }>('POST', `/api/examples/${id}`, {}),
  /// The files of the folder, and the projects that have a draft.
  folder: () => getJson<{ files: FolderFile[]; drafts: string[]; more: boolean }>('/api/files'),
  /// Saves a picture of a project, also while the page closes.
  keepPicture: (file: string, picture: Blob) =>
    fetch(`/api/pictures/${name(file)}`, {
      method: 'PUT',
      headers: { 'Content-Type': 'application/octet-stream' },
      body: picture,
      keepalive: true,
    }),
  pictureAddress: (file: string, time: number) => `/api/pictures/${name(file)}?time=${time}`,
  /// Renames a project with its runs; returns its new name in the folder.
  renameProject: async (file: string, newName: string) =>
    (await sendJson<{ file: string }>('PATCH', `/api/projects/${name(file)}`, { name: newName })).file,
  /// Moves a project with its runs to the deleted ones.
  deleteProject: (file: string) => ask('DELETE', `/api/projects/${name(file)}`),
  deleted: async () => (await getJson<{ deleted: DeletedProject[] }>('/api/deleted')).deleted,
  restore: async (id: string) => (await sendJson<{ file: string }>('POST', `/api/deleted/${id}/restore`, {})).file,
  /// Deletes a project for good.
  erase: (id: string) => ask('DELETE', `/api/deleted/${id}`),
  verification: () => getJson<Verification>('/api/verification'),
  upload: async (file: string, content: Blob, replace = false) => {
    let response: Response;
    try {
      const address = `/api/files/${name(file)}${replace ? '?replace=1' : ''}`;
      const headers = { 'Content-Type': 'application/octet-stream' };
      response = await noticingDelay(fetch(address, { method: 'PUT', headers, body: content }));
    } catch {
      throw new Unreachable();
    }
    if (response.ok) return;
    const answer = (await response.json().catch(() => null)) as { problems?: Problem[] } | null;
    throw new Refused(response.status, answer?.problems ?? []);
  },
  project: (file: string) => getJson<ProjectText>(`/api/project?file=${encodeURIComponent(file)}`),
  /// `saved` is the hash of the file to replace. Refused if the server now serves another folder (`workplace`).
  saveProject: (file: string, { text, saved }: Draft, of: Revision, workplace: string) =>
    sendJson<{ saved: string }>('PUT', '/api/project', { file, text, saved, ...of, workplace }),
  keepDraft: (file: string, draft: Draft | null, of: Revision, workplace: string) => {
    const { text, saved } = draft ?? { text: null, saved: null };
    return sendJson('PUT', '/api/draft', { file, text, saved, ...of, workplace });
  },
  model: (file: string, text: string, signal?: AbortSignal) =>
    sendJson<ModelAnswer>('POST', '/api/model', { file, text }, signal),
  runs: async () => (await getJson<{ runs: Run[] }>('/api/runs')).runs,
  compute: (file: string, text: string, more: { name?: string; rocks?: number; seed?: number } = {}) =>
    sendJson<Run>('POST', '/api/runs', { file, text, ...more }),
  calibrate: (file: string, text: string, replace: boolean) =>
    sendJson<Run>('POST', '/api/calibrations', { file, text, replace }),
  stopRun: (id: string) => sendJson<Run>('POST', `/api/runs/${id}/stop`, {}),
  writeRun: (id: string) => sendJson<Run>('POST', `/api/runs/${id}/write`, {}),
  resumeRun: (id: string) => sendJson<Run>('POST', `/api/runs/${id}/resume`, {}),
  renameRun: (id: string, newName: string) => sendJson<Run>('PATCH', `/api/runs/${id}`, { name: newName }),
  removeRun: (id: string) => ask('DELETE', `/api/runs/${id}`),
};
