// The layout of the workbench: top bar, side panel with model, runs or text, the view, and results below it.

import { useEffect } from 'preact/hooks';
import { unitSystem } from '../state/displayUnits';
import { isStale } from '../project/model';
import { showPanel, sidePanel } from '../state/panels';
import { isAsking } from '../askLine/asked';
import { AskCard } from '../askLine/AskCard';
import { takeLineFiles } from '../askLine/lineFiles';
import { ModelPanel } from '../forms/ModelPanel';
import { dimension } from '../project/place';
import { listenToDrops } from '../project/terrainFile';
import { SlopeCard } from '../slopeTools/SlopeCard';
import { slopePane } from '../slopeTools/state';
import { TimeBar } from '../paths/TimeBar';
import { ResultsPanel } from './ResultsPanel';
import { RunsPanel } from '../runList/RunsPanel';
import { SceneView } from '../scene/SceneView';
import { SectionView } from '../section/SectionView';
import { TextPanel } from '../forms/TextPanel';
import { CalibratePanel } from '../calibration/CalibratePanel';
import { takeObserved } from '../calibration/observations';
import { DropDialog } from '../dropped/DropDialog';
import { hasRaster, takeDropped } from '../dropped/dropped';
import { ContextMenu } from '../drag/ContextMenu';
import { TopBar } from './TopBar';
import { Tabs } from '../ui/Tabs';
import { SavingDialogs } from './SavingDialogs';

export function Workbench() {
  useEffect(
    () =>
      listenToDrops((list) =>
        isAsking.peek() && !hasRaster(list) ? takeLineFiles(list) : sidePanel.peek() === 'calibrate' ? takeObserved(list, 'stops') : takeDropped(list),
      ),
    [],
  );
  return (
    <div class="workbench">
      <TopBar />
      <aside class="side" aria-label="Model and runs">
        <Tabs
          label="Model and runs"
          tabs={[
            { name: 'model', title: 'Model' },
            { name: 'runs', title: 'Runs' },
            { name: 'calibrate', title: 'Calibrate' },
            { name: 'text', title: 'Text' },
          ]}
          now={sidePanel.value}
          choose={showPanel}
        />
        <div class="body">
          {sidePanel.value === 'model' && <ModelPanel />}
          {sidePanel.value === 'runs' && <RunsPanel />}
          {sidePanel.value === 'calibrate' && <CalibratePanel />}
          {sidePanel.value === 'text' && <TextPanel />}
        </div>
      </aside>
      <main class="view">
        <div class="picture">
          {dimension.value === 2 ? <SectionView /> : <SceneView />}
          {isStale.value && (
            <div class="stale problem warning" role="status">
              The terrain has errors. The last valid terrain is shown.
            </div>
          )}
        </div>
        <TimeBar />
        <ResultsPanel key={`results in ${unitSystem.value}`} />
        {isAsking.value && <AskCard key={`line in ${unitSystem.value}`} />}
        {slopePane.value && dimension.value === 2 && <SlopeCard />}
      </main>
      <ContextMenu />
      <DropDialog />
      <SavingDialogs />
    </div>
  );
}
