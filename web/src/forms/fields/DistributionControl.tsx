// A random property: a number, or a mean with a distribution and its parameters, and its density.

import { edit, valueAt } from '../../project/document';
import type { Problem } from '../../api/types';
import { applies } from '../../settings/applies';
import type { TomlTable, TomlValue } from '../../toml/format';
import { problemsOf } from '../../project/awaited';
import { inheritedText, inheritedAt } from '../../project/library';
import { constantKind, sampleKind } from '../../settings/names';
import { pathText, put, thingOf } from '../../project/place';
import { isTable } from '../../settings/tables';
import { absentText, valueText } from '../../settings/words';
import { Choice } from './Choice';
import { Curve } from './Curve';
import { FileControl } from './FileControl';
import { idOf, problemsId, type FieldProps } from './fieldProps';
import { TypedInput } from '../../ui/TypedInput';

const kindTitles: Record<string, string> = { [constantKind]: 'constant' };

export function DistributionControl({ field, path }: FieldProps) {
  if (field.type.kind !== 'distribution') return null;
  const value = valueAt(path);
  const given: TomlTable | null = isTable(value) ? value : null;
  const standard = isTable(field.default) ? field.default : null;
  const mean = given ? given.mean : (value as TomlValue | undefined);
  const kind = String(given?.distribution ?? constantKind);
  const kinds = field.type.parts.find(({ key }) => key === 'distribution')?.type;
  const id = idOf(path);
  const parts = field.type.parts.map(({ key }) => key);
  /// The part that a problem is about, by its path or by its words.
  const partOf = ({ path: at, what }: Problem) =>
    parts.find((key) => at === pathText([...path, key])) ?? parts.find((key) => what.includes(` ${key} `)) ?? 'mean';
  const problemsOfPart = (key: string) => problemsOf(path).filter((problem) => partOf(problem) === key);
  const marks = (key: string) => ({
    invalid: value !== undefined && problemsOfPart(key).some(({ severity }) => severity === 'error'),
    describedBy: problemsOfPart(key).length > 0 ? problemsId(path) : undefined,
  });

  const inherited = inheritedAt(path);
  const chooseKind = (next: string | undefined) => {
    const kindText = next === undefined || next === constantKind ? 'constant' : next;
    const what = `change ${field.title.toLowerCase()} of ${thingOf(path)} to ${kindText}`;
    const now = mean ?? (isTable(inherited) ? inherited.mean : inherited) ?? standard?.mean;
    const isConstant = next === undefined || next === constantKind;
    if (next === sampleKind || (kind === sampleKind && !isConstant)) {
      // A sample has none of the parameters of the others.
      edit(what, [{ set: path, value: { distribution: next } }]);
    } else if (next === undefined || next === constantKind) {
      edit(what, [now === undefined ? { remove: path } : { set: path, value: now }]);
    } else if (given) edit(what, [{ set: [...path, 'distribution'], value: next }]);
    else edit(what, [{ set: path, value: { ...(now !== undefined && { mean: now }), distribution: next } }]);
  };
  return (
    <>
      <div class="distribution">
        {kind !== sampleKind && (
          <TypedInput
            id={id}
            label={`${field.title}: mean`}
            value={mean}
            {...marks('mean')}
            placeholder={inheritedText(path) ?? absentText(field)}
            take={(next) => put(given ? [...path, 'mean'] : path, next, field.title, { merge: pathText(path) })}
          />
        )}
        {kinds?.kind === 'choice' && (
          <Choice
            label={`${field.title}: distribution`}
            words={kinds.words}
            titles={kindTitles}
            value={kind}
            absent=""
            take={chooseKind}
          />
        )}
      </div>
      {given && kind !== constantKind && (
        <>
          <div class="tuple">
            {field.type.parts
              .filter(({ key, needs }) => key !== 'mean' && key !== 'distribution' && applies(needs, '', given, {}))
              .map((part) => (
                <label key={part.key} title={part.description}>
                  <span class="faint">{part.title}</span>
                  {part.type.kind === 'file' ? (
                    <FileControl field={part} path={[...path, part.key]} />
                  ) : (
                    <TypedInput
                      label={`${field.title}: ${part.title.toLowerCase()}`}
                      isText={part.type.kind === 'text'}
                      value={given[part.key]}
                      {...marks(part.key)}
                      placeholder={part.key === 'std_dev' ? '' : valueText(part.default)}
                      take={(next) =>
                        put(
                          [...path, part.key],
                          next,
                          `${part.title.toLowerCase()} of ${field.title.toLowerCase()}`,
                        )
                      }
                    />
                  )}
                </label>
              ))}
          </div>
          <Curve distribution={given} path={path} unit={field.unit} title={field.title} />
        </>
      )}
    </>
  );
}
