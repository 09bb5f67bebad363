// A file of the project: one of the folder, or an uploaded one.

import { useEffect, useRef } from 'preact/hooks';
import { file, valueAt } from '../../project/document';
import { reportFailure } from '../../state/messages';
import { problemsAt } from '../../project/model';
import { chosenFiles, files, fittingFiles, fittingName, loadFiles, relativeTo, uploadFiles } from '../../project/files';
import { MoreFiles } from '../MoreFiles';
import { cellText } from '../../settings/numbers';
import { pathText, put } from '../../project/place';
import { absentText } from '../../settings/words';
import { idOf, problemsId, type FieldProps } from './fieldProps';
import type { TomlValue } from '../../toml/format';

interface Props extends FieldProps {
  /// Of an entry of a list; otherwise the value is that at the path.
  entry?: { value: TomlValue; take: (next: TomlValue | undefined) => void; name: string };
}

export function FileControl({ field, path, entry }: Props) {
  useEffect(() => void loadFiles(), []);
  const input = useRef<HTMLInputElement>(null);
  const value = entry ? entry.value : valueAt(path);
  const take = entry?.take ?? ((next: TomlValue | undefined) => put(path, next, field.title));
  const now = cellText(value);
  const project = file.value ?? '';
  const names = fittingFiles(field.key, files.value, String(path[0])).map(({ name }) => relativeTo(project, name));
  // For alternative keys of a terrain the engine reports that one is needed; here only the file is missing.
  const absent = field.excludes.length > 0 ? 'no file chosen' : absentText(field) || 'no file chosen';
  const emptyText = names.length > 0 || now ? absent : 'no suitable file in the folder yet';
  const problems = problemsAt(pathText(path));
  const upload = async (list: File[]) => {
    const name = fittingName(field.key, await uploadFiles(project, list), files.value, String(path[0]));
    if (name !== undefined) take(name);
  };
  return (
    <div class="file-control">
      <select
        id={idOf(path)}
        aria-label={entry?.name}
        aria-invalid={value !== undefined && problems.some(({ severity }) => severity === 'error')}
        aria-describedby={problemsId(path)}
        value={now}
        onChange={(event) => take(event.currentTarget.value || undefined)}
      >
        <option value="">{emptyText}</option>
        {(now === '' || names.includes(now) ? names : [now, ...names]).map((name) => (
          <option key={name} value={name}>
            {name}
          </option>
        ))}
      </select>
      <button class="button" onClick={() => input.current?.click()}>
        Upload…
      </button>
      <input
        ref={input}
        type="file"
        hidden
        multiple
        aria-label={`Upload a file for ${entry?.name ?? field.title}`}
        onChange={(event) => void upload(chosenFiles(event.currentTarget)).catch(reportFailure)}
      />
      <MoreFiles />
    </div>
  );
}
