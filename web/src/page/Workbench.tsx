// The layout of the workbench: top bar, side panel with model, runs or text, the view, and results below it.

import { useEffect } from 'preact/hooks';
import { unitSystem } from '../state/displayUnits';
import { isStale } from '../project/model';
import { isSideFolded, sidePanel } from '../state/panels';
import { AnswerCards } from '../answers/AnswerCards';
import { isAsking } from '../askLine/asked';
import { AskCard } from '../askLine/AskCard';
import { takeLineFiles } from '../askLine/lineFiles';
import { dimension } from '../project/place';
import { listenToDrops } from '../project/terrainFile';
import { SlopeCard } from '../slopeTools/SlopeCard';
import { slopePane } from '../slopeTools/state';
import { TimeBar } from '../paths/TimeBar';
import { hasResults, shown } from '../runs/runs';
import { ResultsPanel } from './ResultsPanel';
import { SceneView } from '../scene/SceneView';
import { SectionView } from '../section/SectionView';
import { takeObserved } from '../calibration/observations';
import { DropDialog } from '../dropped/DropDialog';
import { hasRaster, takeDropped } from '../dropped/dropped';
import { DocumentDialog } from '../help/Document';
import { ContextMenu } from '../drag/ContextMenu';
import { Side } from './Side';
import { TopBar } from './TopBar';
import './answersFirst';
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
    <div class={isSideFolded.value ? 'workbench side-folded' : 'workbench'}>
      <TopBar />
      <Side />
      <main class="view">
        {shown.value && hasResults(shown.value) && <AnswerCards key={`answers in ${unitSystem.value}`} />}
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
      <DocumentDialog />
      <DropDialog />
      <SavingDialogs />
    </div>
  );
}
