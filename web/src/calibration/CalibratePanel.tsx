// The Calibrate panel: observations, parameters, the study, and the calibrations of the project.

import { TypedInput } from '../ui/TypedInput';
import { ownCalibrations } from '../runs/runs';
import { CalibrationCard } from './CalibrationCard';
import { ObservationList } from './ObservationList';
import { changeForm, form } from './observations';
import { ParameterList } from './ParameterList';
import { OtherProblems, ProblemsAt } from './ProblemsAt';
import { calibrate, isSending, openStudy, studiesBeside } from './runStudy';
import { studyEnding, studyNumbers, type StudyNumber } from './study';
import '../ui/forms.css';
import '../runList/runs.css';
import './calibration.css';

/// With the defaults of `talus calibrate`.
const numbers: Record<StudyNumber, { title: string; usual: string; what: string }> = {
  rocks: { title: 'Rocks', usual: '200', what: 'Rocks simulated with each set of parameters' },
  draws: { title: 'Sets', usual: '1200', what: 'Sets of parameters in all rounds; half of them in the first' },
  rounds: { title: 'Rounds', usual: '3', what: 'The first draws from the prior, later ones near what earlier ones found' },
  most_draws: {
    title: 'Limit',
    usual: '3 times Sets',
    what: 'Further rounds follow up to this number of sets while the posterior is as accurate as fewer than 40',
  },
  folds: { title: 'Folds', usual: '0', what: 'Parts of the observations that are predicted from the others' },
  seed: { title: 'Seed', usual: '1', what: 'Determines the sets and the draws of rocks' },
};

function StudySettings() {
  const { name, numbers: given } = form.value;
  return (
    <section aria-label="Study">
      <h3>Study</h3>
      <div class="row numbers">
        {studyNumbers.map((key) => (
          <label key={key} title={numbers[key].what}>
            {numbers[key].title}
            <TypedInput
              label={`${numbers[key].title} of the study`}
              value={given[key]}
              placeholder={numbers[key].usual}
              take={(value) => {
                const { [key]: _, ...others } = form.peek().numbers;
                changeForm({ numbers: typeof value === 'number' ? { ...others, [key]: value } : others });
              }}
            />
          </label>
        ))}
      </div>
      {studyNumbers.map((key) => (
        <ProblemsAt key={key} path={key} />
      ))}
      <label class="study-name">
        Study file
        <span class="row">
          <input
            type="text"
            class="typed"
            aria-label="Name of the study"
            spellcheck={false}
            value={name}
            onChange={(event) => changeForm({ name: event.currentTarget.value.trim() || name })}
          />
          <span class="faint mono">{studyEnding}</span>
        </span>
      </label>
      <ProblemsAt path="name" />
    </section>
  );
}

export function CalibratePanel() {
  const { observations, parameters } = form.value;
  const studies = studiesBeside();
  const isReady = observations.length > 0 && parameters.length > 0;
  const shownPaths = [
    ...observations.map((_, k) => `observations.${k}`),
    ...parameters.map((_, k) => `parameter.${k}`),
    ...studyNumbers,
    'name',
  ];
  return (
    <div class="model calibrate">
      <h2 tabIndex={-1}>Calibrate</h2>
      <p class="faint">Which values of the ground agree with rocks that were observed, and how well are they known?</p>
      {studies.length > 0 && (
        <select aria-label="Open a study" value="" onChange={(event) => event.currentTarget.value && void openStudy(event.currentTarget.value)}>
          <option value="">Open a study…</option>
          {studies.map((name) => (
            <option key={name} value={name}>
              {name}
            </option>
          ))}
        </select>
      )}
      <ObservationList />
      <ParameterList />
      <StudySettings />
      <OtherProblems paths={shownPaths} />
      <div class="row">
        <button class="button first" disabled={!isReady || isSending.value} onClick={() => void calibrate()}>
          Calibrate
        </button>
        <span class="faint">{isReady ? 'Saves the project first.' : 'Needs observations and a parameter.'}</span>
      </div>
      {ownCalibrations.value.length > 0 && (
        <section aria-label="Calibrations">
          <h3>Calibrations</h3>
          <ul class="runs">
            {ownCalibrations.value.map((run) => (
              <CalibrationCard key={run.id} run={run} />
            ))}
          </ul>
        </section>
      )}
    </div>
  );
}
