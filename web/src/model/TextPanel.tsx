// The project file as it is written, for who likes to.

import { replaceText, syntaxError, text } from '../state/document';
import { asTyped, withTyped } from '../toml/lineEnds';

export function TextPanel() {
  return (
    <div style={{ display: 'flex', flexDirection: 'column', height: '100%', padding: 8, gap: 6 }}>
      {syntaxError.value && (
        <span class="problem">
          Line {syntaxError.value.line}: {syntaxError.value.message}
        </span>
      )}
      <textarea
        class="mono"
        aria-label="Project file"
        spellcheck={false}
        wrap="off"
        style={{ flex: 1, resize: 'none', fontSize: 12 }}
        value={asTyped(text.value)}
        onInput={(event) => replaceText(withTyped(text.value, event.currentTarget.value), 'edit the text', 'text')}
      />
    </div>
  );
}
