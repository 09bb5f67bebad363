// A file that the project names: one of the folder, or one that is uploaded beside the project.

import { useEffect, useRef } from 'preact/hooks';
import { file, valueAt } from '../../state/document';
import { sayFailure } from '../../state/messages';
import { problemsAt } from '../../state/model';
import { files, fittingFiles, loadFiles, relativeTo, uploadBeside } from '../files';
import { cellText } from '../numbers';
import { pathText, put } from '../place';
import { absentText } from '../schema';
import { idOf, type FieldProps } from './Field';

export function FileControl({ field, path }: FieldProps) {
  useEffect(() => void loadFiles(), []);
  const input = useRef<HTMLInputElement>(null);
  const value = valueAt(path);
  const now = cellText(value);
  const project = file.value ?? '';
  const names = fittingFiles(field.key, files.value).map(({ name }) => relativeTo(project, name));
  // Of the keys that make a terrain the engine says that one is needed; here it is which file.
  const absent = field.excludes.length > 0 ? 'no file chosen' : absentText(field) || 'no file chosen';
  const emptyText = names.length > 0 || now ? absent : 'no fitting file in the folder yet';
  const problems = problemsAt(pathText(path));
  const upload = async (chosen: File) => {
    const name = await uploadBeside(project, chosen);
    if (name !== null) put(path, name, field.title);
  };
  return (
    <div class="file-control">
      <select
        id={idOf(path)}
        aria-invalid={value !== undefined && problems.some(({ severity }) => severity === 'error')}
        aria-describedby={problems.length > 0 ? `${idOf(path)}-problems` : undefined}
        value={now}
        onChange={(event) => put(path, event.currentTarget.value || undefined, field.title)}
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
        aria-label={`Upload a file for ${field.title}`}
        onChange={(event) => {
          const [first, ...others] = [...(event.currentTarget.files ?? [])];
          event.currentTarget.value = '';
          // What belongs to it, such as the .dbf of a Shapefile, goes along.
          const all = async () => {
            for (const other of others) await uploadBeside(project, other);
            if (first) await upload(first);
          };
          void all().catch(sayFailure);
        }}
      />
    </div>
  );
}
