// One setting: label, value, problems and help.

import type { ComponentChildren } from 'preact';
import { useState } from 'preact/hooks';
import { valueAt } from '../../project/document';
import { explainsAll } from './explaining';
import { problemsOf, sentenceOf, toneOf } from '../../project/awaited';
import { pathText, put, rockModel } from '../../project/place';
import { wordText } from '../../settings/words';
import type { Field as Setting } from '../../settings/schema';
import { Control } from './Control';
import { idOf, type FieldProps } from './fieldProps';
import { Help } from './Help';

/// Whether a field has a single control, which its label refers to. Other fields are labelled groups.
const isSingle = ({ type }: Setting) =>
  ['number', 'whole', 'boolean', 'choice', 'text', 'file', 'files', 'word or number', 'list'].includes(type.kind);

export function Field({ field, path, before }: FieldProps & { before?: ComponentChildren }) {
  const [open, setOpen] = useState(false);
  const value = valueAt(path);
  const problems = problemsOf(path);
  const isEmpty = value === undefined || (Array.isArray(value) && value.length === 0);
  const isWanted = isEmpty && problems.length > 0;
  const id = idOf(path);
  const isHelped = open || explainsAll.value;
  const isIdle = field.onlyFor !== '' && field.onlyFor !== rockModel.value;
  const label = (
    <>
      {field.title}
      {field.unit && <span class="unit"> {field.unit}</span>}
    </>
  );
  return (
    <div
      class={`field ${isWanted ? 'wanted' : ''} ${isIdle ? 'idle' : ''} ${field.type.kind === 'boolean' ? 'beside' : ''}`}
      data-path={pathText(path)}
      role={isSingle(field) ? undefined : 'group'}
      aria-labelledby={isSingle(field) ? undefined : `${id}-label`}
    >
      <div class="head">
        {before}
        {isSingle(field) ? (
          <label for={id} title={field.description}>
            {label}
          </label>
        ) : (
          <span id={`${id}-label`} class="label" title={field.description}>
            {label}
          </span>
        )}
        {value !== undefined && !field.required && (
          <button
            class="mini"
            title="Reset to the default"
            aria-label={`Clear ${field.title}`}
            onClick={() => put(path, undefined, field.title)}
          >
            ↺
          </button>
        )}
        <button
          class="mini"
          aria-expanded={isHelped}
          aria-label={`About ${field.title}`}
          title="What is this?"
          onClick={() => setOpen(!open)}
        >
          ?
        </button>
      </div>
      {isIdle ? (
        <>
          <fieldset disabled aria-describedby={`${id}-idle`}>
            <Control field={field} path={path} />
          </fieldset>
          <p id={`${id}-idle`} class="faint">
            Applies only to the {wordText(field.onlyFor)} model; the rock model is {wordText(rockModel.value)}.
          </p>
        </>
      ) : (
        <Control field={field} path={path} />
      )}
      {problems.length > 0 && (
        <div id={`${id}-problems`}>
          {problems.map((problem) => (
            <span key={problem.text} class={`problem ${isWanted ? 'warning' : toneOf(problem)}`}>
              {sentenceOf(problem)}
            </span>
          ))}
        </div>
      )}
      {isHelped && <Help field={field} path={path} />}
    </div>
  );
}
