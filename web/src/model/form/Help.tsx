import { reading } from '../../help/Document';
import { topicOf } from '../../help/topics';
import type { Path } from '../names';
import type { Field } from '../schema';
import { absentText, rangeText } from '../words';
import { Words } from './Words';

/// `max_time_s` in `[analysis]`, as the file has it.
function place(path: Path): string {
  const [table, next] = path;
  if (path.length === 1) return 'before the first table';
  return typeof next === 'number' ? `in [[${table}]]` : `in [${table}]`;
}

/// What a setting means, which values it may have, and where it comes from.
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
        <button class="button plain more" onClick={() => (reading.value = topic)}>
          {`Read more: ${topic.heading.replaceAll('`', '')}`}
        </button>
      )}
    </div>
  );
}
