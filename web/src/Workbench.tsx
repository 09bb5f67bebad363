// The rooms of the workbench: bar, model or runs at the left, the view, results below it.

import { useEffect } from 'preact/hooks';
import { isOfBefore } from './state/model';
import { sidePanel } from './state/view';
import { ModelPanel } from './model/ModelPanel';
import { dimension } from './model/place';
import { listenToDrops, takeFiles } from './model/terrainFile';
import { TimeBar } from './paths/TimeBar';
import { ResultsPanel } from './results/ResultsPanel';
import { RunsPanel } from './runs/RunsPanel';
import { SceneView } from './scene/SceneView';
import { SectionView } from './section/SectionView';
import { TextPanel } from './model/TextPanel';
import { TopBar } from './ui/TopBar';
import { Tabs } from './ui/Tabs';
import { SavingDialogs } from './ui/SavingDialogs';

export function Workbench() {
  useEffect(() => listenToDrops(takeFiles), []);
  return (
    <div class="workbench">
      <TopBar />
      <aside class="side" aria-label="Model and runs">
        <Tabs
          label="Model and runs"
          tabs={[
            { name: 'model', title: 'Model' },
            { name: 'runs', title: 'Runs' },
            { name: 'text', title: 'Text' },
          ]}
          now={sidePanel.value}
          choose={(name) => (sidePanel.value = name)}
        />
        <div class="body">
          {sidePanel.value === 'model' && <ModelPanel />}
          {sidePanel.value === 'runs' && <RunsPanel />}
          {sidePanel.value === 'text' && <TextPanel />}
        </div>
      </aside>
      <main class="view">
        <div class="picture">
          {dimension.value === 2 ? <SectionView /> : <SceneView />}
          {isOfBefore.value && (
            <div class="of-before problem warning" role="status">
              The terrain has errors: shown is the one before them.
            </div>
          )}
        </div>
        <TimeBar />
        <ResultsPanel />
      </main>
      <SavingDialogs />
    </div>
  );
}
