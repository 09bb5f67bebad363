// The control of a setting, by the kind of its value.

import { valueAt } from '../../project/document';
import { problemsAt } from '../../project/model';
import { pathText, put, underLaws } from '../../project/place';
import { absentText, valueText, wordText } from '../../settings/words';
import { Choice } from './Choice';
import { DistributionControl } from './DistributionControl';
import { idOf, problemsId, type FieldProps } from './fieldProps';
import { FileControl } from './FileControl';
import { FilesControl } from './FilesControl';
import { LineControl, RowsControl, TupleControl } from './geometry';
import { LibraryControl } from './LibraryControl';
import { ListControl } from './ListControl';
import { NamesControl } from './NamesControl';
import { PolylinesControl } from './PolylinesControl';
import { materialFields, NameChoice, NameList } from './references';
import { RowsOrFileControl } from './RowsOrFileControl';
import { SegmentList } from './SegmentList';
import { TypedInput } from '../../ui/TypedInput';
import { WordsControl } from './WordsControl';

export function Control({ field: declared, path }: FieldProps) {
  const field = underLaws(declared);
  const value = valueAt(path);
  const id = idOf(path);
  const invalid = value !== undefined && problemsAt(pathText(path)).some(({ severity }) => severity === 'error');
  const describedBy = problemsId(path);
  const take = (next: Parameters<typeof put>[1]) => put(path, next, field.title);
  const common = { id, invalid, describedBy };
  switch (field.type.kind) {
    case 'number':
    case 'whole':
      return <TypedInput {...common} value={value} placeholder={absentText(field)} take={take} />;
    case 'text':
      if (materialFields.has(pathText([path[0]!, field.key]))) return <NameChoice field={field} path={path} {...common} />;
      return <TypedInput {...common} isText value={value} placeholder={absentText(field)} take={take} />;
    case 'boolean':
      return (
        <input
          id={id}
          type="checkbox"
          aria-describedby={describedBy}
          checked={typeof value === 'boolean' ? value : field.default === true}
          onChange={(event) => take(event.currentTarget.checked)}
        />
      );
    case 'choice':
      if (field.key === 'like') return <LibraryControl field={field} path={path} {...common} />;
      return (
        <Choice
          {...common}
          words={field.type.words}
          value={value}
          absent={field.required ? '' : absentText(field)}
          take={take}
        />
      );
    case 'word or number':
      return (
        <>
          <TypedInput
            {...common}
            words={`${id}-words`}
            value={value}
            placeholder={`${absentText(field)}; ${field.type.words.map(wordText).join(', ')} or a number`}
            take={take}
          />
          <datalist id={`${id}-words`}>
            {field.type.words.map((word) => (
              <option key={word} value={word} />
            ))}
          </datalist>
        </>
      );
    case 'words':
      return <WordsControl field={field} path={path} words={field.type.words} />;
    case 'list':
      if (field.type.of === 'text' && path[0] === 'ground') return <SegmentList field={field} path={path} />;
      if (field.type.of === 'text') return <NameList field={field} path={path} />;
      return (
        <ListControl
          {...common}
          value={value}
          placeholder={valueText(field.default) || absentText(field)}
          take={take}
        />
      );
    case 'file':
      return <FileControl field={field} path={path} />;
    case 'files':
      return <FilesControl field={field} path={path} />;
    case 'distribution':
      return <DistributionControl field={field} path={path} />;
    case 'tuple':
      return <TupleControl field={field} path={path} />;
    case 'rows':
      return field.type.orFile ? <RowsOrFileControl field={field} path={path} /> : <RowsControl field={field} path={path} />;
    case 'lists of rows':
      return <PolylinesControl field={field} path={path} />;
    case 'line':
      return <LineControl field={field} path={path} />;
    case 'names':
      return <NamesControl field={field} path={path} />;
  }
}
