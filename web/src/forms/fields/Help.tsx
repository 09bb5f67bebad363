import { read } from '../../help/Document';
import { topicOf } from '../../help/topics';
import type { Path } from '../../settings/names';
import type { Field } from '../../settings/schema';
import { absentText, rangeText } from '../../settings/words';
import { Words } from './Words';

/// The location of a setting in the file: "in [analysis]".
function place(path: Path): string {
  const [table, next] = path;
  if (path.length === 1) return 'before the first table';
  return typeof next === 'number' ? `in [[${table}]]` : `in [${table}]`;
}

/// The meaning of a setting, its range, its default and its source.
export function Help({ field, path }: { field: Field; path: Path }) {
  const range = 'range' in field.type ? rangeText(field.type.range) : '';
  const absent = absentText(field);
  const topic = topicOf(path);
  return (
    <div class="help">
      <p>
        <Words text={field.description} />
      </p>
      <dl>
        {field.unit && (
          <>
            <dt>Unit</dt>
            <dd>{field.unit}</dd>
          </>
        )}
        {range && (
          <>
            <dt>Range</dt>
            <dd>{range}</dd>
          </>
        )}
        {absent && (
          <>
            <dt>If empty</dt>
            <dd>
              <Words text={absent.replace(/^default /, '')} />
            </dd>
          </>
        )}
        {field.source && (
          <>
            <dt>Source</dt>
            <dd>
              <Words text={field.source} />
            </dd>
          </>
        )}
        <dt>In the file</dt>
        <dd>
          <code>{field.key}</code> {place(path)}
        </dd>
      </dl>
      {topic && (
        <button class="button plain more" onClick={() => read(topic)}>
          {`Read more: ${topic.heading.replaceAll('`', '')}`}
        </button>
      )}
    </div>
  );
}
