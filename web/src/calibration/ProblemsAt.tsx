import type { Problem } from '../api/types';
import { studyProblems } from './runStudy';

const isAt = ({ path }: Problem, at: string) => path === at || path.startsWith(`${at}.`);

/// The problems of a setting of the study, or of a row with its settings.
export function ProblemsAt({ path, except = [] }: { path: string; except?: readonly Problem[] }) {
  const shown = new Set(except.map(({ text }) => text));
  return (
    <>
      {studyProblems.value
        .filter((problem) => isAt(problem, path) && !shown.has(problem.text))
        .map((problem) => (
          <span key={problem.text} class={`problem ${problem.severity}`} role="alert">
            {problem.text}
          </span>
        ))}
    </>
  );
}

/// Those that are shown nowhere else.
export function OtherProblems({ paths }: { paths: readonly string[] }) {
  return (
    <>
      {studyProblems.value
        .filter((problem) => !paths.some((path) => isAt(problem, path)))
        .map((problem) => (
          <span key={problem.text} class={`problem ${problem.severity}`} role="alert">
            {problem.text}
          </span>
        ))}
    </>
  );
}
