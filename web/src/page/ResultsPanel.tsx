// The results of the shown run, below the view.

import { useId } from 'preact/hooks';
import type { Run, RunState } from '../api/types';
import { hasResults, ownRuns, resume, shown, shownCalibration, writePartialResults } from '../runs/runs';
import { keepResults, resultsOpen, resultsShare, resultsTab, showPanel, showTab, type ResultsTab } from '../state/panels';
import { dimension, tableAt } from '../project/place';
import { CalibrationTab } from '../calibration/CalibrationTab';
import { ObservedTab } from '../calibration/ObservedTab';
import { observedStops } from '../calibration/observations';
import { UncertaintyTab } from '../calibration/UncertaintyTab';
import { sectionLine } from '../sectionLine/sectionLine';
import { SectionTab } from '../sectionLine/SectionTab';
import { Tabs } from '../ui/Tabs';
import { Barriers } from '../results/Barriers';
import { Compare } from '../results/Compare';
import { Distributions } from '../results/Distributions';
import { EnvelopesTab } from '../results/EnvelopesTab';
import { Maps } from '../results/Maps';
import { Outdated } from '../results/Outdated';
import { Overview } from '../results/Overview';
import { Rock } from '../results/Rock';
import { SoFarTab } from '../results/SoFarTab';
import { Splitter } from '../results/Splitter';
import '../results/results.css';

const pages: Record<ResultsTab, { title: string; page: (props: { run: Run }) => preact.JSX.Element }> = {
  overview: { title: 'Overview', page: Overview },
  distributions: { title: 'Distributions', page: Distributions },
  barriers: { title: 'Barriers', page: Barriers },
  rock: { title: 'Rock', page: Rock },
  envelopes: { title: 'Envelopes', page: EnvelopesTab },
  maps: { title: 'Maps', page: Maps },
  compare: { title: 'Compare', page: Compare },
  section: { title: 'Section', page: SectionTab },
  observed: { title: 'Observed', page: ObservedTab },
  uncertainty: { title: 'Uncertainty', page: UncertaintyTab },
  calibration: { title: 'Calibration', page: CalibrationTab },
};

/// The tabs that apply now. The ground section belongs to the model and needs no run.
function tabsNow(): ResultsTab[] {
  const all = Object.keys(pages) as ResultsTab[];
  const hasRuns = shown.value !== null || ownRuns.value.length > 0;
  const mayHaveSection = dimension.value === 3 && (hasRuns || sectionLine.value !== null);
  const isOfOther = (name: ResultsTab) => name === (dimension.value === 2 ? 'maps' : 'envelopes');
  const applies: Partial<Record<ResultsTab, boolean>> = {
    section: mayHaveSection,
    observed: hasRuns && observedStops.value.length > 0,
    uncertainty: hasRuns && tableAt(['sampling']).parameters !== undefined,
    calibration: shownCalibration.value !== null,
  };
  return all.filter((name) => applies[name] ?? (hasRuns && !isOfOther(name)));
}

/// Tabs that need no run.
const isOfModel = (name: ResultsTab) => name === 'section' || name === 'calibration';

const halts: Partial<Record<RunState, string>> = {
  interrupted: 'The server stopped while this run was in progress.',
  stopped: 'This run was stopped before any rock was finished.',
};

/// Explains why a run has no results, with the possible actions.
function NoResults({ run }: { run: Run }) {
  if (run.state === 'waiting') return <div class="empty">This run is waiting for other runs to finish.</div>;
  if (run.state === 'running')
    return <SoFarTab run={run} />;
  if (run.state === 'done') return <div class="empty">The results of this run are no longer in its folder.</div>;
  if (halts[run.state])
    return (
      <div class="empty">
        <p>{halts[run.state]}</p>
        {run.state === 'interrupted' && run.done > 0 && (
          <button class="button" style={{ justifySelf: 'center' }} onClick={() => void writePartialResults(run.id)}>
            Write partial results
          </button>
        )}
        <button class="button" style={{ justifySelf: 'center' }} onClick={() => void resume(run.id)}>
          Resume
        </button>
      </div>
    );
  return (
    <div class="answer-missing">
      <p>This run failed. Correct the errors below, then resume it or compute again.</p>
      {run.problems.map((problem) => (
        <span key={problem.text} class={`problem ${problem.severity}`}>
          {problem.text}
        </span>
      ))}
      <button class="button" onClick={() => void resume(run.id)}>
        Resume
      </button>
    </div>
  );
}

export function ResultsPanel() {
  const panel = useId();
  const run = shown.value;
  const tabs = tabsNow().map((name) => ({ name, title: pages[name].title }));
  if (tabs.length === 0) return null;
  const now = (tabs.find(({ name }) => name === resultsTab.value) ?? tabs[0]!).name;
  const Page = pages[now].page;
  const name = (now === 'calibration' ? shownCalibration.value : run)?.name;
  const isOpen = resultsOpen.value;
  return (
    <section
      class={isOpen ? 'results open' : 'results'}
      aria-label="Results"
      style={isOpen ? { height: `${Math.round(resultsShare.value * 1000) / 10}vh` } : {}}
    >
      {isOpen && <Splitter />}
      <div class="results-bar">
        <Tabs
          label="Results"
          tabs={tabs}
          now={now}
          choose={(name) => {
            showTab(name);
            keepResults(true);
          }}
        />
        <span class="results-run" title={name}>
          {name}
        </span>
        <button
          class="button plain"
          aria-expanded={isOpen}
          aria-controls={panel}
          onClick={() => keepResults(!isOpen)}
        >
          {isOpen ? 'Hide ▾' : 'Results ▴'}
        </button>
      </div>
      {!isOfModel(now) && <Outdated />}
      <div id={panel} class="results-body" role="tabpanel" aria-label={pages[now].title}>
        {!isOpen ? null : now === 'section' ? (
          <SectionTab />
        ) : now === 'calibration' ? (
          <CalibrationTab />
        ) : !run ? (
          <div class="empty">
            <p>No run is shown.</p>
            <button class="button" style={{ justifySelf: 'center' }} onClick={() => showPanel('runs')}>
              Choose a run
            </button>
          </div>
        ) : hasResults(run) ? (
          <Page run={run} />
        ) : (
          <NoResults run={run} />
        )}
      </div>
    </section>
  );
}
