// The whole page: the start page, or the workbench of the project that is open.

import { useEffect } from 'preact/hooks';
import { signal } from '@preact/signals';
import { api } from './api/client';
import type { About } from './api/types';
import { file, open } from './state/document';
import { sayFailure } from './state/messages';
import { follow } from './state/runs';
import { StartPage } from './start/StartPage';
import { Messages } from './ui/Messages';
import { Workbench } from './Workbench';
import { listenToKeys } from './ui/keys';

export const about = signal<About | null>(null);

async function begin() {
  about.value = await api.about();
  const name = sessionStorage.getItem('file') ?? about.value.project;
  if (name !== null) await open(name);
}

export function App() {
  useEffect(() => {
    void begin().catch(sayFailure);
    follow();
    return listenToKeys();
  }, []);
  return (
    <>
      {file.value === null ? <StartPage /> : <Workbench />}
      <Messages />
    </>
  );
}
