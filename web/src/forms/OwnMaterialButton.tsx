import { useEffect, useState } from 'preact/hooks';
import { attempt, reportFailure } from '../state/messages';
import { Dialog } from '../ui/Dialog';
import type { Path } from '../settings/names';
import { loadOwn, namesFile, ownFile, ownMaterials, saveOwn } from '../project/ownMaterials';
import { nameOf, tableAt } from '../project/place';

/// Saves the material of a form in the library of one's own.
export function OwnMaterialButton({ path }: { path: Path }) {
  const [asks, ask] = useState(false);
  useEffect(() => void loadOwn().catch(reportFailure), []);
  const material = tableAt(path);
  const name = nameOf('material', path[1] as number);
  const save = () => {
    ask(false);
    void attempt('own materials', () => saveOwn(material, name));
  };
  const isThere = ownMaterials.value.some((own) => own.name === name);
  const reason = namesFile(material) ? 'It draws values from a file, which other projects would not find' : undefined;
  return (
    <>
      <button class="button" disabled={reason !== undefined} title={reason ?? `Copies its values to ${ownFile}`} onClick={() => (isThere ? ask(true) : save())}>
        Save to my materials
      </button>
      {asks && (
        <Dialog title={`Replace ${name}?`} close={() => ask(false)}>
          <p>My materials already have one of this name. Projects that use its values keep them.</p>
          <div class="dialog-buttons">
            <button class="button" onClick={() => ask(false)}>
              Keep
            </button>
            <button class="button danger" onClick={save}>
              Replace
            </button>
          </div>
        </Dialog>
      )}
    </>
  );
}
