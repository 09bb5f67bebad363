import { file, fileStem, isChanged, redo, redoes, undo, undoes, values } from '../project/document';
import { close } from '../project/opening';
import { askName, save } from '../project/saving';
import { isBuilding } from '../project/model';
import { isConnected, running, stop } from '../runs/runs';
import { displayOf, switchUnits, unitSystem } from '../state/displayUnits';
import { nextTheme, theme } from '../view/theme';
import { ComputeMenu } from '../runList/ComputeMenu';
import { RunEnds } from '../runList/RunEnds';
import { clockText } from '../units/texts';
import { counted } from '../units/numbers';
import { afterTyping } from '../project/typing';

function Progress() {
  const run = running.value;
  if (!run) return null;
  return (
    <div class="progress">
      <progress max={run.rocks} value={run.done} aria-label="Rocks done" />
      <span class="mono">
        {run.done.toLocaleString('en')} of {counted(run.rocks, 'rock')}
        {run.rate !== null && run.rate > 0 && `, ${Math.round(run.rate).toLocaleString()}/s`}
        {run.seconds_left !== null && `, ${clockText(run.seconds_left)} left`}
      </span>
      <button class="button" onClick={() => void stop(run.id)}>
        Stop
      </button>
    </div>
  );
}

export function TopBar() {
  const name = typeof values.value.name === 'string' ? values.value.name : fileStem();
  return (
    <header class="bar">
      <button class="button plain icon" title="Start page" aria-label="Start page" onClick={() => afterTyping(close)}>
        <img class="logo" src="/icon.svg" alt="" />
      </button>
      <div class="title">
        <h1 title={name}>{name}</h1>
        <span class="faint" title={file.value ?? ''}>
          {file.value}
          {isChanged.value && ' (changed)'}
        </span>
      </div>
      <button
        class="button icon"
        disabled={!undoes.value}
        title={undoes.value ? `Undo: ${undoes.value} (Ctrl+Z)` : 'Nothing to undo'}
        aria-label="Undo"
        onClick={undo}
      >
        ↶
      </button>
      <button
        class="button icon"
        disabled={!redoes.value}
        title={redoes.value ? `Redo: ${redoes.value} (Ctrl+Y)` : 'Nothing to redo'}
        aria-label="Redo"
        onClick={redo}
      >
        ↷
      </button>
      <button class="button" disabled={!isChanged.value} title="Save (Ctrl+S)" onClick={() => void save()}>
        Save
      </button>
      <button class="button" onClick={() => askName(true)}>
        Save as…
      </button>
      <span class="space" />
      <Progress />
      <RunEnds />
      {!isConnected.value && (
        <span class="problem" role="alert">
          The server does not respond
        </span>
      )}
      {isBuilding.value && <span class="faint">checking…</span>}
      <ComputeMenu />
      <button
        class="button icon"
        title={`Units of results: ${unitSystem.value}`}
        aria-label={`Units of results: ${unitSystem.value}`}
        onClick={switchUnits}
      >
        {displayOf('m').unit}
      </button>
      <button
        class="button icon"
        title={`Theme: ${theme.value}`}
        aria-label={`Theme: ${theme.value}`}
        onClick={nextTheme}
      >
        ◐
      </button>
    </header>
  );
}
