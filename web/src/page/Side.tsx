// The panels at the left: unfolded with tabs, or folded into a strip with their names.

import { useRef } from 'preact/hooks';
import { CalibratePanel } from '../calibration/CalibratePanel';
import { ModelPanel } from '../forms/ModelPanel';
import { TextPanel } from '../forms/TextPanel';
import { RunsPanel } from '../runList/RunsPanel';
import { foldSide, isSideFolded, showPanel, sidePanel, turnToPanel, type SidePanel } from '../state/panels';
import { Tabs } from '../ui/Tabs';

const tabs: { name: SidePanel; title: string }[] = [
  { name: 'model', title: 'Model' },
  { name: 'runs', title: 'Runs' },
  { name: 'calibrate', title: 'Calibrate' },
  { name: 'text', title: 'Text' },
];

export function Side() {
  const side = useRef<HTMLElement>(null);
  // The keyboard stays where it was: at the tab, or at the button of the strip.
  const focusLater = (what: string) => requestAnimationFrame(() => side.current?.querySelector<HTMLElement>(what)?.focus());
  if (isSideFolded.value)
    return (
      <aside class="side folded" aria-label="Model and runs" ref={side}>
        {tabs.map(({ name, title }) => (
          <button
            key={name}
            class="button plain"
            aria-expanded={false}
            title={`Show ${title}`}
            onClick={() => {
              turnToPanel(name);
              foldSide(false);
              focusLater('[role="tab"][aria-selected="true"]');
            }}
          >
            {title}
          </button>
        ))}
      </aside>
    );
  return (
    <aside class="side" aria-label="Model and runs" ref={side}>
      <div class="side-head">
        <Tabs label="Model and runs" tabs={tabs} now={sidePanel.value} choose={showPanel} />
        <button
          class="button plain icon"
          aria-label="Fold the panel"
          title="Fold the panel; it folds by itself when a run ends"
          onClick={() => {
            foldSide(true);
            focusLater('button');
          }}
        >
          «
        </button>
      </div>
      <div class="body">
        {sidePanel.value === 'model' && <ModelPanel />}
        {sidePanel.value === 'runs' && <RunsPanel />}
        {sidePanel.value === 'calibrate' && <CalibratePanel />}
        {sidePanel.value === 'text' && <TextPanel />}
      </div>
    </aside>
  );
}
