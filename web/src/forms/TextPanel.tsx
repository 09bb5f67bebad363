// A text editor for the project file.

import { useLayoutEffect, useRef } from 'preact/hooks';
import { replaceText, syntaxError, text } from '../project/document';
import { asTyped, withTyped } from '../toml/lineEnds';
import { endOfChange, stepOf } from './textSteps';

export function TextPanel() {
  const field = useRef<HTMLTextAreaElement>(null);
  const shown = asTyped(text.value);
  const last = useRef(shown);
  // After a change from elsewhere, such as Undo, the caret is at the change.
  useLayoutEffect(() => {
    const before = last.current;
    last.current = shown;
    if (before === shown || document.activeElement !== field.current) return;
    const place = endOfChange(before, shown);
    field.current!.setSelectionRange(place, place);
  }, [shown]);
  const take = (typed: string) => {
    const step = stepOf(last.current, typed);
    last.current = typed;
    replaceText(withTyped(text.value, typed), 'edit the text', step);
  };
  return (
    <div style={{ display: 'flex', flexDirection: 'column', height: '100%', padding: 8, gap: 6 }}>
      {syntaxError.value && (
        <span class="problem">
          Line {syntaxError.value.line}: {syntaxError.value.message}
        </span>
      )}
      <textarea
        ref={field}
        class="mono"
        aria-label="Project file"
        // Always shows the project's text, so Undo is that of the project.
        data-clean=""
        spellcheck={false}
        wrap="off"
        style={{ flex: 1, resize: 'none', fontSize: 12 }}
        value={shown}
        onInput={(event) => take(event.currentTarget.value)}
      />
    </div>
  );
}
