// The docked card of the slope tools.

import { tool } from '../tools/tool';
import { openPane, slopePane, type Pane } from './state';
import { ShapeForm } from './ShapeForm';
import { StaysPane } from './StaysPane';
import './overlay';
import './slopeTools.css';
import '../askLine/askLine.css';

const panes: { name: Pane; title: string }[] = [
  { name: 'bench', title: 'Bench' },
  { name: 'ditch', title: 'Ditch' },
  { name: 'berm', title: 'Berm' },
  { name: 'regrade', title: 'Regrade' },
  { name: 'stays', title: 'What stays' },
];

export function SlopeCard() {
  return (
    <section
      class="ask-card slope-card"
      aria-label="Slope tools"
      tabIndex={-1}
      onKeyDown={(event) => {
        const isTyping = event.target instanceof HTMLInputElement && event.target.type === 'text';
        if (event.key === 'Escape' && !isTyping && !tool.value) openPane(null);
      }}
    >
      <header>
        <h2>Slope tools</h2>
        <button class="button plain icon" aria-label="Close" title="Close (Escape)" onClick={() => openPane(null)}>
          ×
        </button>
      </header>
      <div class="slope-panes" role="group" aria-label="Tool">
        {panes.map(({ name, title }) => (
          <button key={name} class="button" aria-pressed={slopePane.value === name} onClick={() => openPane(name)}>
            {title}
          </button>
        ))}
      </div>
      {slopePane.value === 'stays' ? <StaysPane /> : <ShapeForm />}
    </section>
  );
}
