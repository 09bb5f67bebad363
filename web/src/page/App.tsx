// The whole page: the start page, or the workbench of the project that is open.

import { useEffect } from 'preact/hooks';
import { api } from '../api/client';
import { setAbout } from '../state/about';
import { file } from '../project/document';
import { goToAddress, listenToHistory } from './history';
import { reportFailure } from '../state/messages';
import { lastOpen, open } from '../project/opening';
import { follow } from '../runs/runs';
import { ReplaceDialog } from '../forms/ReplaceDialog';
import { StartPage } from '../start/StartPage';
import { Messages } from './Messages';
import { Workbench } from './Workbench';
import { listenToKeys } from './keys';
import { listenToTyping } from '../project/typing';

async function begin() {
  setAbout(await api.about());
  if (await goToAddress()) return;
  const name = lastOpen();
  if (name !== null) await open(name);
}

export function App() {
  useEffect(() => {
    const ends = [follow(), listenToKeys(), listenToTyping()];
    // The place of the address is opened first; the browser history starts there.
    void begin()
      .catch(reportFailure)
      .then(() => ends.push(listenToHistory()));
    return () => ends.forEach((end) => end());
  }, []);
  return (
    <>
      {file.value === null ? <StartPage /> : <Workbench />}
      <ReplaceDialog />
      <Messages />
    </>
  );
}
